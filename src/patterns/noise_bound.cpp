#include "patterns/noise_bound.h"

#include "patterns/noise_lanes.h"

namespace rb {

namespace {

// Of the cell corners' numbers, as in CornerRows.
constexpr std::array<size_t, 3> axis_bit{2, 4, 1};

using CornerValues = std::array<Interval, 8>;

/// From a to b by a share within `weight`.
Interval blend(const Interval& a, const Interval& b, const Interval& weight) {
    const auto at = [](double from, double to, double share) { return from + share * (to - from); };
    return {std::min(at(a.lo, b.lo, weight.lo), at(a.lo, b.lo, weight.hi)),
            std::max(at(a.hi, b.hi, weight.lo), at(a.hi, b.hi, weight.hi))};
}

/// Mixes the corners along all axes.
Interval mix_corners(CornerValues values, const std::array<Interval, 3>& weights) {
    for (size_t axis = 0; axis < 3; ++axis) {
        for (size_t k = 0; k < 8; ++k) {
            if (k & axis_bit[axis]) continue;
            values[k] = blend(values[k], values[k | axis_bit[axis]], weights[axis]);
        }
    }
    return values[0];
}

/// A part of one cell, whose corners are whole numbers.
struct CellPart {
    Vec3 middle;
    Vec3 half;
    std::array<Interval, 3> weights;  ///< of the far corners
    std::array<Interval, 3> growths;  ///< derivatives of the weights

    explicit CellPart(const Bounds& part) : middle(part.center()), half(0.5 * part.size()) {
        const auto weight = [](double t) { return t * t * (3.0 - 2.0 * t); };
        const auto growth = [](double t) { return 6.0 * t * (1.0 - t); };
        for (int i = 0; i < 3; ++i) {
            const double a = part.lo[i];
            const double b = part.hi[i];
            const auto axis = static_cast<size_t>(i);
            weights[axis] = {weight(a), weight(b)};
            const double steepest = a < 0.5 && b > 0.5 ? 1.5 : std::max(growth(a), growth(b));
            growths[axis] = {std::min(growth(a), growth(b)), steepest};
        }
    }
    Interval linear(double at_middle, const Vec3& slope) const {
        const double reach = glm::dot(glm::abs(slope), half);
        return {at_middle - reach, at_middle + reach};
    }
};

struct Corner {
    double at_middle;
    Vec3 slope;
};

/// By the product rule: the corners' own slopes, and how the weights move from the near corners to the far.
Interval slope_along(size_t axis, const CellPart& part, const std::array<Corner, 8>& corners) {
    CornerValues slopes;
    CornerValues steps;
    for (size_t k = 0; k < 8; ++k) {
        slopes[k] = corners[k].slope[static_cast<int>(axis)];
        const Corner& near = corners[k & ~axis_bit[axis]];
        const Corner& far = corners[k | axis_bit[axis]];
        steps[k] = part.linear(far.at_middle - near.at_middle, far.slope - near.slope);
    }
    return mix_corners(slopes, part.weights) + part.growths[axis] * mix_corners(steps, part.weights);
}

template <bool HasValue>
NoiseBound bound_part(const CellPart& part, const CornerRows& rows) {
    std::array<Corner, 8> corners;
    CornerValues values;
    for (size_t k = 0; k < 8; ++k) {
        const double* row = rows[k];
        const Vec3 slope{row[1], row[2], row[3]};
        const Vec3 corner{k & axis_bit[0] ? 1.0 : 0.0, k & axis_bit[1] ? 1.0 : 0.0,
                          k & axis_bit[2] ? 1.0 : 0.0};
        corners[k] = {(HasValue ? row[0] : 0.0) + glm::dot(slope, part.middle - corner), slope};
        values[k] = part.linear(corners[k].at_middle, slope);
    }
    return {mix_corners(values, part.weights),
            {slope_along(0, part, corners), slope_along(1, part, corners), slope_along(2, part, corners)}};
}

void include(const NoiseBound& part, bool is_first, NoiseBound& all) {
    if (is_first) {
        all = part;
        return;
    }
    all.value = hull(all.value, part.value);
    for (size_t i = 0; i < 3; ++i) all.slopes[i] = hull(all.slopes[i], part.slopes[i]);
}

/// To [0, 1] as noise() does it, rounding included.
template <class Noise>
NoiseBound in_range(const NoiseBound& all) {
    constexpr double rounding = 1e-7;
    NoiseBound out;
    double lo = all.value.lo - rounding;
    double hi = all.value.hi + rounding;
    Noise::into_range(lo);
    Noise::into_range(hi);
    out.value = {lo, hi};
    for (size_t i = 0; i < 3; ++i) {
        out.slopes[i] = Noise::range_slope * all.slopes[i];
        if (lo == 0.0 || hi == 1.0) out.slopes[i] = hull(out.slopes[i], 0.0);
    }
    return out;
}

template <class Noise>
NoiseBound bound_over(const Noise& noise, const Bounds& box) {
    const auto& cells = noise.cells;
    const Vec3 lo = box.lo + cells.shift;
    const Vec3 hi = box.hi + cells.shift;
    const Vec3 first = glm::floor(lo);
    const Vec3 last = glm::max(first, glm::ceil(hi) - 1.0);
    constexpr double most_cells = 2.0;
    if (max_component(last - first) >= most_cells) {
        const Interval any = Interval::everything();
        return {{0.0, 1.0}, {any, any, any}};
    }
    NoiseBound all;
    bool is_first = true;
    for (double z = first.z; z <= last.z; ++z) {
        for (double y = first.y; y <= last.y; ++y) {
            for (double x = first.x; x <= last.x; ++x) {
                const Vec3 cell{x, y, z};
                CornerRows rows;
                cells(cells.number(x), cells.number(y), cells.number(z), rows);
                const CellPart part({glm::clamp(lo - cell, 0.0, 1.0), glm::clamp(hi - cell, 0.0, 1.0)});
                include(bound_part<Noise::has_value>(part, rows), is_first, all);
                is_first = false;
            }
        }
    }
    return in_range<Noise>(all);
}

}  // namespace

NoiseBound bound_noise(const Bounds& box, int generator) {
    NoiseBound bound;
    with_noise(generator, [&](const auto& kind) { bound = bound_over(kind, box); });
    return bound;
}

}  // namespace rb
