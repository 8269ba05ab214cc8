#include "math/wide.h"
#include "shapes/julia_orbit.h"

namespace rb {

namespace {

constexpr int lanes = JuliaFormula::places_at_once;
using Lanes = double __attribute__((vector_size(lanes * sizeof(double))));
using Mask = int64_t __attribute__((vector_size(lanes * sizeof(int64_t))));

/// JuliaFormula::next() with the same bits, of squares and cubes.
template <JuliaAlgebra algebra, bool cubes>
__attribute__((always_inline)) inline void advance(const Quaternion& c, Lanes& x, Lanes& y, Lanes& z,
                                                   Lanes& w) {
    if constexpr (algebra == JuliaAlgebra::hypercomplex) {
        const Lanes a = x * x - y * y - z * z + w * w;
        const Lanes b = y * x + x * y - w * z - z * w;
        const Lanes d = z * x - w * y + x * z - y * w;
        const Lanes e = w * x + z * y + y * z + x * w;
        x = a;
        y = b;
        z = d;
        w = e;
    } else {
        const Lanes across = y * y + z * z + w * w;
        const Lanes factor = cubes ? 3.0 * x * x - across : 2.0 * x;
        x = cubes ? x * (x * x - 3.0 * across) : x * x - across;
        y = factor * y;
        z = factor * z;
        w = factor * w;
    }
    x += c.x;
    y += c.y;
    z += c.z;
    w += c.w;
}

template <JuliaAlgebra algebra, bool cubes>
__attribute__((always_inline)) inline void follow(const JuliaFormula& formula,
                                                  std::span<const Quaternion, lanes> places,
                                                  JuliaFormula::Orbits& out) {
    Lanes x;
    Lanes y;
    Lanes z;
    Lanes w;
    for (int k = 0; k < lanes; ++k) {
        const Quaternion& q = places[static_cast<size_t>(k)];
        x[k] = q.x;
        y[k] = q.y;
        z[k] = q.z;
        w[k] = q.w;
    }
    const double limit = formula.escape();
    // What grows beyond all numbers has first been too large.
    Lanes largest{};
    const auto staying = [&] {
        const Mask stays = largest <= limit;
        uint32_t set = 0;
        for (int k = 0; k < lanes; ++k) set |= static_cast<uint32_t>(stays[k] & 1) << k;
        return set;
    };
    constexpr size_t steps_between_looks = 4;
    for (size_t i = 0; i < formula.steps; ++i) {
        const Lanes square = (x * x + y * y) + (z * z + w * w);
        largest = square > largest ? square : largest;
        if (i % steps_between_looks == steps_between_looks - 1 && staying() == 0) break;
        advance<algebra, cubes>(formula.c, x, y, z, w);
    }
    out.staying = staying();
    for (int k = 0; k < lanes; ++k) out.largest[static_cast<size_t>(k)] = largest[k];
}

__attribute__((always_inline)) inline void follow(const JuliaFormula& formula,
                                                  std::span<const Quaternion, lanes> places,
                                                  JuliaFormula::Orbits& out) {
    if (formula.algebra == JuliaAlgebra::hypercomplex) {
        follow<JuliaAlgebra::hypercomplex, false>(formula, places, out);
    } else if (formula.function == JuliaFunction::cube) {
        follow<JuliaAlgebra::quaternion, true>(formula, places, out);
    } else {
        follow<JuliaAlgebra::quaternion, false>(formula, places, out);
    }
}

RB_WIDE void follow_by_eights(const JuliaFormula& formula, std::span<const Quaternion, lanes> places,
                              JuliaFormula::Orbits& out) {
    follow(formula, places, out);
}

}  // namespace

JuliaFormula::Orbits JuliaFormula::orbits_of(std::span<const Quaternion, places_at_once> places) const {
    Orbits out;
    if (has_wide()) {
        follow_by_eights(*this, places, out);
    } else {
        follow(*this, places, out);
    }
    return out;
}

}  // namespace rb
