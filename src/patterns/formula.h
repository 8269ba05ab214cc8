#pragma once
#include "math/recurrence.h"
#include "patterns/registry.h"

#include <cmath>
#include <cstdint>
#include <string>

#include <fmt/format.h>

namespace rb {

// The small functions that the pattern formulas share (spec: textures 0).

inline double clamp01(double v) { return v < 0.0 ? 0.0 : (v > 1.0 ? 1.0 : v); }
/// floor() without the call; a zero may lose its sign.
inline double quick_floor(double v) {
    if (!(std::abs(v) < 1e15)) return std::floor(v);
    const auto whole = static_cast<double>(static_cast<int64_t>(v));
    return whole > v ? whole - 1.0 : whole;
}
/// Of a whole number; one that is no number counts as odd.
inline bool is_odd(double whole) {
    if (!(std::abs(whole) < 1e15)) return std::fmod(whole, 2.0) != 0.0;
    return (static_cast<int64_t>(whole) & 1) != 0;
}
/// floor, but one less on negative whole numbers.
inline double floor_below(double v) { return v >= 0.0 ? std::floor(v) : -std::floor(-v) - 1.0; }
inline double triangle(double v) { return 1.0 - std::abs(2.0 * fraction(v) - 1.0); }
/// Angle from +x towards +z, in [0, 2 pi).
inline double turn(double x, double z) {
    if (z == 0.0) return x > 0.0 ? 0.0 : pi;
    const double a = std::acos(x / std::sqrt(x * x + z * z));
    return z < 0.0 ? 2.0 * pi - a : a;
}
/// One in the centre, nothing from 1 outward.
inline double faded(double r) { return r < 0.0 ? 1.0 : (r > 1.0 ? 0.0 : 1.0 - r); }
inline double single(double v) { return static_cast<double>(static_cast<float>(v)); }

/// A pattern whose value depends on nothing but the point.
template <class Formula>
class PointPattern : public Pattern {
public:
    void evaluate(const PatternContext&, std::span<const Vec3> points,
                  std::span<double> values) const override {
        const auto& formula = static_cast<const Formula&>(*this);
        for (size_t i = 0; i < points.size(); ++i) values[i] = formula.value(points[i]);
    }
};

template <class P>
PatternPtr read_plain(BlockReader&) {
    return std::make_shared<P>();
}

}  // namespace rb
