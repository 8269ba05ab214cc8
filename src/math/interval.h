#pragma once
#include <bit>
#include <cstdint>
#include <limits>

namespace rb {

/// The next double above or below; infinities stay.
inline double next_above(double v) {
    if (!(v < std::numeric_limits<double>::infinity())) return v;
    if (v == 0) return std::numeric_limits<double>::denorm_min();
    return std::bit_cast<double>(std::bit_cast<uint64_t>(v) + (v > 0 ? 1u : ~uint64_t{0}));
}
inline double next_below(double v) { return -next_above(-v); }

/// A set of doubles: all from lo to hi, infinities included, and not-a-number if `maybe_nan`. Every operation
/// on intervals holds what the same operation gives, as a computer rounds it, for any members (outward
/// rounding; functions of the C library are trusted to 4 units in the last place). R. E. Moore, Methods and
/// Applications of Interval Analysis, 1979.
struct Interval {
    double lo = 0;
    double hi = 0;
    bool maybe_nan = false;

    constexpr Interval() = default;
    constexpr Interval(double v) : lo(v), hi(v), maybe_nan(v != v) {
        if (maybe_nan) {
            lo = -std::numeric_limits<double>::infinity();
            hi = std::numeric_limits<double>::infinity();
        }
    }
    constexpr Interval(double low, double high, bool nan = false) : lo(low), hi(high), maybe_nan(nan) {}

    static constexpr Interval everything() {
        return {-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(), true};
    }
    bool holds(double v) const { return v != v ? maybe_nan : lo <= v && v <= hi; }
    bool is_point() const { return lo == hi && !maybe_nan; }
    bool has_infinity() const {
        return lo == -std::numeric_limits<double>::infinity() ||
               hi == std::numeric_limits<double>::infinity();
    }
};

/// Sum and product where an end is infinite or something overflows.
Interval add_infinite(const Interval& a, const Interval& b);
Interval multiply_infinite(const Interval& a, const Interval& b);

/// The smallest interval that holds both.
inline Interval hull(const Interval& a, const Interval& b) {
    return {a.lo < b.lo ? a.lo : b.lo, a.hi > b.hi ? a.hi : b.hi, a.maybe_nan || b.maybe_nan};
}

inline Interval operator-(const Interval& a) { return {-a.hi, -a.lo, a.maybe_nan}; }

inline Interval operator+(const Interval& a, const Interval& b) {
    const double lo = a.lo + b.lo;
    const double hi = a.hi + b.hi;
    const double width = hi - lo;
    // Neither nan nor infinite.
    if (width - width == 0) return {next_below(lo), next_above(hi), a.maybe_nan || b.maybe_nan};
    return add_infinite(a, b);
}
inline Interval operator-(const Interval& a, const Interval& b) { return a + -b; }

inline Interval operator*(const Interval& a, const Interval& b) {
    const double p = a.lo * b.lo;
    const double q = a.lo * b.hi;
    const double r = a.hi * b.lo;
    const double s = a.hi * b.hi;
    const double low_p = p < q ? p : q;
    const double low_r = r < s ? r : s;
    const double high_p = p > q ? p : q;
    const double high_r = r > s ? r : s;
    const double lo = low_p < low_r ? low_p : low_r;
    const double hi = high_p > high_r ? high_p : high_r;
    const double all = p + q + r + s;
    if (all - all == 0) return {next_below(lo), next_above(hi), a.maybe_nan || b.maybe_nan};
    return multiply_infinite(a, b);
}
Interval operator/(const Interval& a, const Interval& b);
inline Interval& operator+=(Interval& a, const Interval& b) { return a = a + b; }
inline Interval& operator-=(Interval& a, const Interval& b) { return a = a - b; }
inline Interval& operator*=(Interval& a, const Interval& b) { return a = a * b; }

inline Interval abs(const Interval& v) {
    if (v.lo >= 0) return v;
    if (v.hi <= 0) return -v;
    return {0, -v.lo > v.hi ? -v.lo : v.hi, v.maybe_nan};
}

/// v * v with the same v twice.
inline Interval square(const Interval& v) {
    const Interval a = abs(v);
    const double lo = next_below(a.lo * a.lo);
    return {lo > 0 ? lo : 0, next_above(a.hi * a.hi), v.maybe_nan};
}
inline double square(double v) { return v * v; }
Interval cube(const Interval& v);
inline double cube(double v) { return v * v * v; }

/// The operand that C's `a < b ? a : b` (`a < b ? b : a`) chooses; where one may be nan, either.
Interval min(const Interval& a, const Interval& b);
Interval max(const Interval& a, const Interval& b);
Interval floor(const Interval& v);
Interval ceil(const Interval& v);
Interval trunc(const Interval& v);
Interval fmod(const Interval& a, const Interval& b);

Interval sqrt(const Interval& v);
Interval pow(const Interval& base, const Interval& exponent);
Interval exp(const Interval& v);
Interval log(const Interval& v);
Interval log10(const Interval& v);

Interval sin(const Interval& v);
Interval cos(const Interval& v);
struct Waves {
    Interval sin;
    Interval cos;
};
Waves sin_and_cos(const Interval& v);
Interval tan(const Interval& v);
Interval asin(const Interval& v);
Interval acos(const Interval& v);
Interval atan(const Interval& v);
Interval atan2(const Interval& y, const Interval& x);
Interval sinh(const Interval& v);
Interval cosh(const Interval& v);
Interval tanh(const Interval& v);
Interval asinh(const Interval& v);
Interval acosh(const Interval& v);
Interval atanh(const Interval& v);

}  // namespace rb
