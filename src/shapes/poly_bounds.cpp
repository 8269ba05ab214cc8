#include "shapes/poly_bounds.h"

#include "math/roots.h"
#include "shapes/cell_hull.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace rb {

namespace {

struct Monomial {
    double c;
    std::array<int, 3> power;

    int degree() const { return power[0] + power[1] + power[2]; }
    /// Never negative.
    bool is_square() const { return c >= 0.0 && power[0] % 2 == 0 && power[1] % 2 == 0 && power[2] % 2 == 0; }
};
using Monomials = std::vector<Monomial>;

Monomials monomials(int order, std::span<const double> coefficients) {
    Monomials out;
    size_t at = 0;
    for (int i = order; i >= 0; --i) {
        for (int j = order - i; j >= 0; --j) {
            for (int k = order - i - j; k >= 0; --k) {
                const double c = coefficients[at++];
                if (c != 0.0) out.push_back({c, {i, j, k}});
            }
        }
    }
    return out;
}

struct Range {
    double lo;
    double hi;
};

/// The least value over a box by sums of the monomials' ranges, less far more than any rounding.
class LeastValue {
public:
    explicit LeastValue(const Monomials& terms) : terms_(terms) {}

    double over(const Bounds& box) {
        for (int axis = 0; axis < 3; ++axis) set_powers(axis, box.lo[axis], box.hi[axis]);
        double least = 0.0;
        double size = 0.0;
        for (const Monomial& m : terms_) {
            Range r{m.c, m.c};
            for (size_t axis = 0; axis < 3; ++axis)
                r = product(r, powers_[axis][static_cast<size_t>(m.power[axis])]);
            least += r.lo;
            size += std::max(std::abs(r.lo), std::abs(r.hi));
        }
        constexpr double rounding = 1e-12;
        return least - rounding * size;
    }

private:
    static Range product(const Range& a, const Range& b) {
        const auto [lo, hi] = std::minmax({a.lo * b.lo, a.lo * b.hi, a.hi * b.lo, a.hi * b.hi});
        return {lo, hi};
    }
    void set_powers(int axis, double lo, double hi) {
        auto& out = powers_[static_cast<size_t>(axis)];
        double of_lo = 1.0;
        double of_hi = 1.0;
        for (size_t n = 0; n < out.size(); ++n) {
            const bool valley = n > 0 && n % 2 == 0 && lo < 0.0 && hi > 0.0;
            out[n] = {valley ? 0.0 : std::min(of_lo, of_hi), std::max(of_lo, of_hi)};
            of_lo *= lo;
            of_hi *= hi;
        }
    }

    const Monomials& terms_;
    std::array<std::array<Range, most_degree + 1>, 3> powers_;
};

/// The least value on a part of the cube's surface, or 0 if it is not seen to be positive.
double least_on_face(LeastValue& form, const Bounds& part, int axis, int levels) {
    const double least = form.over(part);
    if (least > 0.0 || levels == 0) return std::max(least, 0.0);
    double out = std::numeric_limits<double>::infinity();
    const Vec3 middle = part.center();
    for (int k = 0; k < 4 && out > 0.0; ++k) {
        Bounds quarter = part;
        const int u = (axis + 1) % 3;
        const int v = (axis + 2) % 3;
        (k & 1 ? quarter.lo : quarter.hi)[u] = middle[u];
        (k & 2 ? quarter.lo : quarter.hi)[v] = middle[v];
        out = std::min(out, least_on_face(form, quarter, axis, levels - 1));
    }
    return out;
}

/// Half the size of a cube beyond which the highest powers outweigh all others; infinity if there is none.
double outer_radius(int order, const Monomials& terms) {
    // An odd power has both signs.
    if (order % 2 == 1) return infinity;
    Monomials highest;
    std::vector<double> against(static_cast<size_t>(order), 0.0);
    for (const Monomial& m : terms) {
        if (m.degree() == order) {
            highest.push_back(m);
        } else if (!m.is_square()) {
            against[static_cast<size_t>(m.degree())] += std::abs(m.c);
        }
    }
    LeastValue form(highest);
    double least = infinity;
    constexpr int levels = 5;
    for (int axis = 0; axis < 3; ++axis) {
        // The opposite face holds the same values.
        Bounds face{Vec3{-1.0}, Vec3{1.0}};
        face.lo[axis] = 1.0;
        least = std::min(least, least_on_face(form, face, axis, levels));
    }
    if (!(least > 0.0)) return infinity;
    constexpr double smallest = 1e-12;
    constexpr double largest = 1e12;
    for (double r = smallest; r < largest; r *= 2.0) {
        double sum = 0.0;
        for (int degree = 0; degree < order; ++degree)
            sum += against[static_cast<size_t>(degree)] * std::pow(r, degree - order);
        if (sum < least) return r;
    }
    return infinity;
}

}  // namespace

Bounds poly_bounds(int order, std::span<const double> coefficients) {
    const Monomials terms = monomials(order, coefficients);
    // Not worth the time.
    constexpr size_t most_terms = 200;
    if (terms.size() > most_terms) return Bounds::everything();
    const double r = outer_radius(order, terms);
    if (!std::isfinite(r)) return Bounds::everything();
    LeastValue value(terms);
    const auto content = [&](const Bounds& cell) {
        return value.over(cell) > 0.0 ? CellContent::none : CellContent::some;
    };
    Bounds box{Vec3{-r}, Vec3{r}};
    // Finer cells would fit better, but take longer than most pictures gain: 8 times for each level.
    constexpr int levels = 3;
    bool settled = false;
    while (!settled) {
        Bounds hull;
        add_cells(content, box, levels, hull);
        // Never below zero, but for points that rounding decides.
        if (hull.is_empty()) return Bounds::everything();
        settled = hull.half_area() > 0.95 * box.half_area();
        box = hull;
    }
    return box;
}

}  // namespace rb
