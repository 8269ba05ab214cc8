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
__attribute__((always_inline)) inline uint32_t staying(const JuliaFormula& formula,
                                                       std::span<const Quaternion, lanes> places) {
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
    Mask stays = x == x;
    const auto bits = [&] {
        uint32_t set = 0;
        for (int k = 0; k < lanes; ++k) set |= static_cast<uint32_t>(stays[k] & 1) << k;
        return set;
    };
    constexpr size_t steps_between_looks = 4;
    for (size_t i = 0; i < formula.steps; ++i) {
        stays &= (x * x + y * y) + (z * z + w * w) <= limit;
        if (i % steps_between_looks == steps_between_looks - 1 && bits() == 0) return 0;
        advance<algebra, cubes>(formula.c, x, y, z, w);
    }
    return bits();
}

__attribute__((always_inline)) inline uint32_t staying(const JuliaFormula& formula,
                                                       std::span<const Quaternion, lanes> places) {
    if (formula.algebra == JuliaAlgebra::hypercomplex)
        return staying<JuliaAlgebra::hypercomplex, false>(formula, places);
    return formula.function == JuliaFunction::cube
               ? staying<JuliaAlgebra::quaternion, true>(formula, places)
               : staying<JuliaAlgebra::quaternion, false>(formula, places);
}

RB_WIDE uint32_t staying_by_eights(const JuliaFormula& formula, std::span<const Quaternion, lanes> places) {
    return staying(formula, places);
}

}  // namespace

uint32_t JuliaFormula::staying_of(std::span<const Quaternion, places_at_once> places) const {
    return has_wide() ? staying_by_eights(*this, places) : staying(*this, places);
}

}  // namespace rb
