#pragma once
#include "math/interval.h"

#include <array>

namespace rb {

/// What a function of one variable does over an interval of it: `value` holds its values, `slope` every
/// difference quotient between two places of the interval (of the exact function: only `value` knows of
/// rounding). Automatic differentiation on intervals (R. E. Moore, Methods and Applications of Interval
/// Analysis, 1979); at a kink the slope holds those of both sides, where there may be a jump it is
/// everything.
struct IntervalSlope {
    Interval value;
    Interval slope;

    IntervalSlope() = default;
    // Constants mix with it freely, so that a function may be written once for numbers and intervals.
    // NOLINTNEXTLINE(google-explicit-constructor)
    IntervalSlope(double v) : value(v) {}
    IntervalSlope(const Interval& v, const Interval& s)
        : value(v), slope(v.maybe_nan ? Interval::everything() : s) {}

    static IntervalSlope everything() { return {Interval::everything(), Interval::everything()}; }
    /// What is finite, and not known.
    static IntervalSlope any_number() {
        constexpr double inf = std::numeric_limits<double>::infinity();
        return {Interval(-inf, inf), Interval::everything()};
    }
    /// Of a function that may jump; it does not if it has but one value.
    static IntervalSlope jumping(const Interval& v) {
        return {v, v.is_point() ? Interval(0) : Interval::everything()};
    }
};

/// Places along a line in space: coordinates over an interval of it, and their slopes.
using LinePlace = std::array<IntervalSlope, 3>;

/// Its slope is exactly 0.
inline bool is_constant(const IntervalSlope& a) { return a.slope.is_point() && a.slope.lo == 0; }

inline IntervalSlope operator-(const IntervalSlope& a) { return {-a.value, -a.slope}; }
inline IntervalSlope operator+(const IntervalSlope& a, const IntervalSlope& b) {
    if (is_constant(a)) return {a.value + b.value, b.slope};
    return {a.value + b.value, is_constant(b) ? a.slope : a.slope + b.slope};
}
inline IntervalSlope operator-(const IntervalSlope& a, const IntervalSlope& b) { return a + -b; }
inline IntervalSlope operator*(const IntervalSlope& a, const IntervalSlope& b) {
    const Interval value = a.value * b.value;
    if (is_constant(a)) return {value, is_constant(b) ? Interval(0) : a.value * b.slope};
    if (is_constant(b)) return {value, a.slope * b.value};
    return {value, a.slope * b.value + a.value * b.slope};
}
IntervalSlope operator/(const IntervalSlope& a, const IntervalSlope& b);
inline IntervalSlope& operator+=(IntervalSlope& a, const IntervalSlope& b) { return a = a + b; }
inline IntervalSlope& operator-=(IntervalSlope& a, const IntervalSlope& b) { return a = a - b; }
inline IntervalSlope& operator*=(IntervalSlope& a, const IntervalSlope& b) { return a = a * b; }

/// By the chain rule; a constant stays one however steep the function is.
inline IntervalSlope chain(const Interval& value, const Interval& derivative, const IntervalSlope& a) {
    return {value, is_constant(a) ? Interval(0) : derivative * a.slope};
}

inline IntervalSlope square(const IntervalSlope& a) {
    return chain(square(a.value), {2 * a.value.lo, 2 * a.value.hi, a.value.maybe_nan}, a);
}
IntervalSlope cube(const IntervalSlope& a);
IntervalSlope abs(const IntervalSlope& a);
IntervalSlope min(const IntervalSlope& a, const IntervalSlope& b);
IntervalSlope max(const IntervalSlope& a, const IntervalSlope& b);
IntervalSlope sqrt(const IntervalSlope& a);
IntervalSlope pow(const IntervalSlope& base, const IntervalSlope& exponent);
IntervalSlope exp(const IntervalSlope& a);
IntervalSlope log(const IntervalSlope& a);
IntervalSlope sin(const IntervalSlope& a);
IntervalSlope cos(const IntervalSlope& a);
IntervalSlope tan(const IntervalSlope& a);
IntervalSlope atan(const IntervalSlope& a);
IntervalSlope atan2(const IntervalSlope& y, const IntervalSlope& x);
IntervalSlope fmod(const IntervalSlope& a, const IntervalSlope& b);

}  // namespace rb
