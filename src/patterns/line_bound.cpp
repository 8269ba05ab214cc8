#include "patterns/line_bound.h"

#include "patterns/noise.h"
#include "patterns/noise_bound.h"

#include <algorithm>
#include <cmath>

namespace rb {

namespace {

/// Both ends are in one piece between whole numbers, which may end with the upper one.
bool is_one_piece(const Interval& v) { return v.hi <= std::floor(v.lo) + 1.0; }

}  // namespace

IntervalSlope fraction(const IntervalSlope& v) {
    const double whole = std::floor(v.value.lo);
    if (std::floor(v.value.hi) != whole) return somewhere_in(0.0, 1.0);
    return v - whole;
}

IntervalSlope triangle(const IntervalSlope& v) {
    if (!is_one_piece(v.value)) return chain({0.0, 1.0}, {-2.0, 2.0}, v);
    return not_negative(1.0 - abs(2.0 * (v - std::floor(v.value.lo)) - 1.0));
}

IntervalSlope faded(const IntervalSlope& r) { return max(1.0 - r, IntervalSlope(0.0)); }

IntervalSlope length(std::span<const IntervalSlope> v) {
    Interval squares(0.0);
    Interval products(0.0);
    Interval speeds(0.0);
    for (const IntervalSlope& c : v) {
        squares += square(c.value);
        products += c.value * c.slope;
        speeds += square(c.slope);
    }
    const Interval length = sqrt(squares);
    if (std::ranges::all_of(v, is_constant)) return {length, 0.0};
    if (length.lo > 0.0) return {length, products / length};
    const double speed = sqrt(speeds).hi;
    return {length, {-speed, speed}};
}

LinePlace scaled(const LinePlace& place, double factor) {
    return {place[0] * factor, place[1] * factor, place[2] * factor};
}

LinePlace carried(const LinePlace& place, const Affine& map) {
    LinePlace out;
    for (int i = 0; i < 3; ++i) {
        out[static_cast<size_t>(i)] =
            place[0] * map.row[0][i] + place[1] * map.row[1][i] + place[2] * map.row[2][i] + map.row[3][i];
    }
    return out;
}

IntervalSlope bound_noise(const LinePlace& place, int generator) {
    const auto all = [&](const auto& is) { return std::ranges::all_of(place, is); };
    const auto reaches = [](double limit) {
        return [limit](const IntervalSlope& v) {
            return !v.value.maybe_nan && v.value.lo > -limit && v.value.hi < limit;
        };
    };
    // Beyond, weights overflow.
    constexpr double finite = 1e50;
    if (!all(reaches(finite))) return IntervalSlope::everything();
    if (all(is_constant)) {
        const Vec3 p{place[0].value.lo, place[1].value.lo, place[2].value.lo};
        const bool is_point = all([](const IntervalSlope& v) { return v.value.is_point(); });
        return is_point ? IntervalSlope(noise(p, generator)) : IntervalSlope({0.0, 1.0}, 0.0);
    }
    constexpr double lattice = 2e9;
    if (!all(reaches(lattice))) return somewhere_in(0.0, 1.0);
    Bounds box;
    for (int i = 0; i < 3; ++i) {
        box.lo[i] = place[static_cast<size_t>(i)].value.lo;
        box.hi[i] = place[static_cast<size_t>(i)].value.hi;
    }
    const NoiseBound bound = bound_noise(box, generator);
    Interval slope(0.0);
    for (size_t i = 0; i < 3; ++i) {
        if (!is_constant(place[i])) slope += bound.slopes[i] * place[i].slope;
    }
    return {bound.value, slope};
}

}  // namespace rb
