#pragma once
#include <cmath>

namespace rb {

/// A number as the unevaluated sum of two doubles, about 106 bits (Dekker 1971; sums and products as in
/// Joldes, Muller and Popescu 2017). For what double precision cannot decide.
struct Twofold {
    double hi = 0;
    double lo = 0;

    Twofold() = default;
    // Doubles mix with it freely, so that an algorithm may be written once for both.
    // NOLINTNEXTLINE(google-explicit-constructor)
    Twofold(double value) : hi(value) {}
    Twofold(double high, double low) : hi(high), lo(low) {}

    explicit operator double() const { return hi + lo; }
};

namespace twofold {
/// Exact as long as |a| >= |b|.
inline Twofold quick_sum(double a, double b) {
    const double s = a + b;
    return {s, b - (s - a)};
}
inline Twofold sum(double a, double b) {
    const double s = a + b;
    const double part = s - a;
    return {s, (a - (s - part)) + (b - part)};
}
}  // namespace twofold

inline Twofold operator+(const Twofold& a, const Twofold& b) {
    const Twofold high = twofold::sum(a.hi, b.hi);
    const Twofold low = twofold::sum(a.lo, b.lo);
    const Twofold mid = twofold::quick_sum(high.hi, high.lo + low.hi);
    return twofold::quick_sum(mid.hi, mid.lo + low.lo);
}

inline Twofold operator*(const Twofold& a, const Twofold& b) {
    const double p = a.hi * b.hi;
    const double rest = std::fma(a.hi, b.hi, -p);
    return twofold::quick_sum(p, rest + (a.hi * b.lo + a.lo * b.hi));
}

/// By an exact double.
inline Twofold operator/(const Twofold& a, double b) {
    const double q = a.hi / b;
    const double rest = (std::fma(-q, b, a.hi) + a.lo) / b;
    return twofold::quick_sum(q, rest);
}

/// Half of it, exact but for underflow.
inline Twofold half(const Twofold& a) { return {0.5 * a.hi, 0.5 * a.lo}; }
inline double half(double a) { return 0.5 * a; }

inline bool is_negative(const Twofold& a) { return a.hi < 0.0 || (a.hi == 0.0 && a.lo < 0.0); }
inline bool is_negative(double a) { return a < 0.0; }
inline double size_of(const Twofold& a) { return std::abs(a.hi); }
inline double size_of(double a) { return std::abs(a); }

}  // namespace rb
