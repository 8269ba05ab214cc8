#pragma once
#include "math/interval.h"

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
    /// Of a function that may jump; it does not if it has but one value.
    static IntervalSlope jumping(const Interval& v) {
        return {v, v.is_point() ? Interval(0) : Interval::everything()};
    }
};

IntervalSlope operator-(const IntervalSlope& a);
IntervalSlope operator+(const IntervalSlope& a, const IntervalSlope& b);
IntervalSlope operator-(const IntervalSlope& a, const IntervalSlope& b);
IntervalSlope operator*(const IntervalSlope& a, const IntervalSlope& b);
IntervalSlope operator/(const IntervalSlope& a, const IntervalSlope& b);
inline IntervalSlope& operator+=(IntervalSlope& a, const IntervalSlope& b) { return a = a + b; }
inline IntervalSlope& operator-=(IntervalSlope& a, const IntervalSlope& b) { return a = a - b; }
inline IntervalSlope& operator*=(IntervalSlope& a, const IntervalSlope& b) { return a = a * b; }

IntervalSlope square(const IntervalSlope& a);
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
