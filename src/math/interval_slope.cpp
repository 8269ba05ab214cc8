#include "math/interval_slope.h"

#include <cmath>

namespace rb {

IntervalSlope operator/(const IntervalSlope& a, const IntervalSlope& b) {
    const Interval q = a.value / b.value;
    if (is_constant(b)) return {q, is_constant(a) ? Interval(0) : a.slope / b.value};
    return {q, (a.slope - q * b.slope) / b.value};
}

IntervalSlope cube(const IntervalSlope& a) { return chain(cube(a.value), 3 * square(a.value), a); }

IntervalSlope abs(const IntervalSlope& a) {
    if (a.value.lo >= 0) return a;
    if (a.value.hi <= 0) return -a;
    return chain(abs(a.value), {-1, 1}, a);
}

IntervalSlope min(const IntervalSlope& a, const IntervalSlope& b) {
    const Interval value = min(a.value, b.value);
    if (a.value.hi < b.value.lo) return {value, a.slope};
    if (b.value.hi < a.value.lo) return {value, b.slope};
    return {value, hull(a.slope, b.slope)};
}
IntervalSlope max(const IntervalSlope& a, const IntervalSlope& b) { return -min(-a, -b); }

IntervalSlope sqrt(const IntervalSlope& a) {
    const Interval root = sqrt(a.value);
    return chain(root, 0.5 / root, a);
}

IntervalSlope pow(const IntervalSlope& base, const IntervalSlope& exponent) {
    const Interval value = pow(base.value, exponent.value);
    if (is_constant(base) && is_constant(exponent)) return {value, 0};
    const bool whole = exponent.value.is_point() && std::trunc(exponent.value.lo) == exponent.value.lo;
    if (!exponent.value.is_point() || !is_constant(exponent) || (!whole && !(base.value.lo >= 0)))
        return {value, Interval::everything()};
    const bool pole = exponent.value.lo < 0 && base.value.holds(0);
    if (pole) return {value, Interval::everything()};
    return chain(value, exponent.value * pow(base.value, exponent.value - 1), base);
}

IntervalSlope exp(const IntervalSlope& a) {
    const Interval value = exp(a.value);
    return chain(value, value, a);
}
IntervalSlope log(const IntervalSlope& a) { return chain(log(a.value), 1 / a.value, a); }
IntervalSlope sin(const IntervalSlope& a) {
    const Waves waves = sin_and_cos(a.value);
    return chain(waves.sin, waves.cos, a);
}
IntervalSlope cos(const IntervalSlope& a) {
    const Waves waves = sin_and_cos(a.value);
    return chain(waves.cos, -waves.sin, a);
}
IntervalSlope tan(const IntervalSlope& a) {
    const Interval value = tan(a.value);
    // Across a pole it falls from one infinity to the other.
    if (value.has_infinity()) return {value, is_constant(a) ? Interval(0) : Interval::everything()};
    return chain(value, 1 + square(value), a);
}
IntervalSlope atan(const IntervalSlope& a) { return chain(atan(a.value), 1 / (1 + square(a.value)), a); }

IntervalSlope atan2(const IntervalSlope& y, const IntervalSlope& x) {
    const Interval value = atan2(y.value, x.value);
    if (is_constant(y) && is_constant(x)) return {value, 0};
    // Across the negative half of the x axis it jumps.
    if (y.value.holds(0) && x.value.lo <= 0) return {value, Interval::everything()};
    return {value, (x.value * y.slope - y.value * x.slope) / (square(x.value) + square(y.value))};
}

IntervalSlope fmod(const IntervalSlope& a, const IntervalSlope& b) {
    const Interval value = fmod(a.value, b.value);
    if (is_constant(a) && is_constant(b)) return {value, 0};
    // Within one period, which is as wide as its image, it runs along with a.
    const double slack = next_above(next_above(a.value.hi - a.value.lo));
    const bool one_period =
        is_constant(b) && b.value.is_point() && value.hi - value.lo <= slack && slack < std::abs(b.value.lo);
    return {value, one_period ? a.slope : Interval::everything()};
}

}  // namespace rb
