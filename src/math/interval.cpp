#include "math/interval.h"

#include "math/vec.h"

#include <algorithm>
#include <cmath>

namespace rb {

namespace {

/// Around a result that is rounded correctly.
Interval rounded(double lo, double hi, bool nan) { return {next_below(lo), next_above(hi), nan}; }

/// Around results of the C library.
Interval widened(double lo, double hi, bool nan) {
    const double width = hi - lo;
    if (width - width == 0) {
        // More than 4 units in the last place, and this difference's own rounding.
        constexpr double share = 5.5 * std::numeric_limits<double>::epsilon();
        constexpr double least = 8.0 * std::numeric_limits<double>::denorm_min();
        return {lo - (share * std::abs(lo) + least), hi + (share * std::abs(hi) + least), nan};
    }
    for (int i = 0; i < 4; ++i) {
        lo = next_below(lo);
        hi = next_above(hi);
    }
    return {lo, hi, nan};
}

Interval rising(double (*f)(double), const Interval& v) { return widened(f(v.lo), f(v.hi), v.maybe_nan); }

/// `v` cut to [lo, hi]; what lies outside gives nan. False if nothing is left.
bool cut(Interval& v, double lo, double hi) {
    if (v.lo < lo || v.hi > hi) v.maybe_nan = true;
    v.lo = std::max(v.lo, lo);
    v.hi = std::min(v.hi, hi);
    return v.lo <= v.hi;
}

/// Whether first + k * period lies within v for a whole k; yes in doubt.
bool meets(const Interval& v, double first, double period) {
    const double from = (v.lo - first) / period;
    const double to = (v.hi - first) / period;
    const double doubt = 1e-12 * (1 + std::abs(from) + std::abs(to));
    return std::floor(to + doubt) >= std::ceil(from - doubt);
}

/// Beyond it the library is not trusted to reduce the angle well enough to tell where the crests are.
constexpr double largest_angle = 1e9;

/// The multiples of a quarter turn that lie in an interval of angles; in doubt one more.
struct Quarters {
    int64_t first;
    int64_t last;

    explicit Quarters(const Interval& v) {
        const double from = v.lo * (2.0 / pi);
        const double to = v.hi * (2.0 / pi);
        const double doubt = 1e-12 * (1.0 + std::abs(from) + std::abs(to));
        first = -floor_of(doubt - from);
        last = floor_of(to + doubt);
    }
    /// One that is `turn` quarters after a whole turn.
    bool hold(int64_t turn) const { return ((turn - first) & 3) <= last - first; }

private:
    static int64_t floor_of(double v) {
        const auto towards_zero = static_cast<int64_t>(v);
        return towards_zero - (v < static_cast<double>(towards_zero) ? 1 : 0);
    }
};

/// Between the values at both ends of an interval of angles, with -1 and 1 where they are taken within.
Interval wave(double at_lo, double at_hi, bool crest, bool trough) {
    const auto [low, high] = std::minmax({at_lo, at_hi});
    Interval out = widened(low, high, false);
    out.lo = trough ? -1 : std::max(out.lo, -1.0);
    out.hi = crest ? 1 : std::min(out.hi, 1.0);
    return out;
}

bool is_usual_angle(const Interval& v) {
    return v.lo > -largest_angle && v.hi < largest_angle && !v.maybe_nan;
}
Interval any_wave(const Interval& v) { return {-1, 1, v.maybe_nan || v.has_infinity()}; }

}  // namespace

Interval add_infinite(const Interval& a, const Interval& b) {
    const bool opposite = (a.hi == infinity && b.lo == -infinity) || (a.lo == -infinity && b.hi == infinity);
    const bool nan = a.maybe_nan || b.maybe_nan || opposite;
    const double lo = a.lo + b.lo;
    const double hi = a.hi + b.hi;
    return rounded(std::isnan(lo) ? -infinity : lo, std::isnan(hi) ? infinity : hi, nan);
}

Interval multiply_infinite(const Interval& a, const Interval& b) {
    const bool nan =
        a.maybe_nan || b.maybe_nan || (a.has_infinity() && b.holds(0)) || (b.has_infinity() && a.holds(0));
    // 0 times a bound without end is 0: what lies between is finite.
    const auto product = [](double u, double v) { return u == 0 || v == 0 ? 0 : u * v; };
    const auto [lo, hi] =
        std::minmax({product(a.lo, b.lo), product(a.lo, b.hi), product(a.hi, b.lo), product(a.hi, b.hi)});
    return rounded(lo, hi, nan);
}

Interval operator/(const Interval& a, const Interval& b) {
    const bool nan =
        a.maybe_nan || b.maybe_nan || (a.has_infinity() && b.has_infinity()) || (a.holds(0) && b.holds(0));
    if (b.holds(0)) return {-infinity, infinity, nan};
    const auto quotient = [](double u, double v) {
        const double q = u / v;
        return std::isnan(q) ? 0 : q;
    };
    const auto [lo, hi] =
        std::minmax({quotient(a.lo, b.lo), quotient(a.lo, b.hi), quotient(a.hi, b.lo), quotient(a.hi, b.hi)});
    return rounded(lo, hi, nan);
}

Interval cube(const Interval& v) {
    Interval out = rounded(v.lo * v.lo * v.lo, v.hi * v.hi * v.hi, v.maybe_nan);
    return {next_below(out.lo), next_above(out.hi), v.maybe_nan};
}

Interval min(const Interval& a, const Interval& b) {
    if (a.maybe_nan || b.maybe_nan) return hull(a, b);
    return {std::min(a.lo, b.lo), std::min(a.hi, b.hi)};
}

Interval max(const Interval& a, const Interval& b) {
    if (a.maybe_nan || b.maybe_nan) return hull(a, b);
    return {std::max(a.lo, b.lo), std::max(a.hi, b.hi)};
}

Interval floor(const Interval& v) { return {std::floor(v.lo), std::floor(v.hi), v.maybe_nan}; }
Interval ceil(const Interval& v) { return {std::ceil(v.lo), std::ceil(v.hi), v.maybe_nan}; }
Interval trunc(const Interval& v) { return {std::trunc(v.lo), std::trunc(v.hi), v.maybe_nan}; }

Interval fmod(const Interval& a, const Interval& b) {
    const bool nan = a.maybe_nan || b.maybe_nan || a.has_infinity() || b.holds(0);
    if (b.is_point() && b.lo != 0 && !a.has_infinity() && (a.lo >= 0 || a.hi <= 0)) {
        // Within one period the remainder rises with a; it is exact.
        const double lo = std::fmod(a.lo, b.lo);
        const double hi = std::fmod(a.hi, b.lo);
        if (next_above(a.hi - a.lo) < std::abs(b.lo) && lo <= hi) return {lo, hi, nan};
    }
    const Interval size = abs(b);
    const double most = std::min(std::max(std::abs(a.lo), std::abs(a.hi)), size.hi);
    return {a.lo < 0 ? -most : 0.0, a.hi > 0 ? most : 0.0, nan};
}

Interval sqrt(const Interval& v) {
    Interval in = v;
    // The root of -0 is -0, that of 0 is 0.
    if (!cut(in, 0, infinity)) return {0, 0, true};
    Interval out = rounded(std::sqrt(in.lo), std::sqrt(in.hi), in.maybe_nan);
    out.lo = std::max(out.lo, 0.0);
    return out;
}

Interval pow(const Interval& base, const Interval& exponent) {
    const bool whole =
        exponent.is_point() && std::trunc(exponent.lo) == exponent.lo && std::abs(exponent.lo) < 9e15;
    if (base.lo < 0 && whole) {
        const double n = exponent.lo;
        if (n < 0 && base.holds(0)) return {-infinity, infinity, base.maybe_nan};
        const bool even = std::fmod(n, 2) == 0;
        const Interval in = even ? abs(base) : base;
        const auto [lo, hi] = std::minmax({std::pow(in.lo, n), std::pow(in.hi, n)});
        // pow(nan, 0) is 1.
        Interval out = widened(lo, hi, base.maybe_nan);
        if (even) out.lo = std::max(out.lo, 0.0);
        return out;
    }
    if (base.lo < 0) return Interval::everything();
    const bool nan = base.maybe_nan || exponent.maybe_nan;
    if (exponent.has_infinity() || base.hi == infinity) return {0, infinity, nan};
    // For a positive base it rises or falls in either argument.
    const double least = base.lo + 0.0;  // never -0
    const auto [lo, hi] = std::minmax({std::pow(least, exponent.lo), std::pow(least, exponent.hi),
                                       std::pow(base.hi, exponent.lo), std::pow(base.hi, exponent.hi)});
    Interval out = widened(lo, hi, nan);
    out.lo = std::max(out.lo, 0.0);
    if (nan) out = hull(out, 1);
    // -0 to a negative odd power.
    if (base.lo == 0 && exponent.lo < 0) out.lo = -infinity;
    return out;
}

Interval exp(const Interval& v) {
    Interval out = rising(std::exp, v);
    out.lo = std::max(out.lo, 0.0);
    return out;
}

Interval log(const Interval& v) {
    Interval in = v;
    return cut(in, 0, infinity) ? rising(std::log, in) : Interval::everything();
}

Interval log10(const Interval& v) {
    Interval in = v;
    return cut(in, 0, infinity) ? rising(std::log10, in) : Interval::everything();
}

Interval sin(const Interval& v) {
    if (!is_usual_angle(v)) return any_wave(v);
    const Quarters quarters(v);
    return wave(std::sin(v.lo), std::sin(v.hi), quarters.hold(1), quarters.hold(3));
}
Interval cos(const Interval& v) {
    if (!is_usual_angle(v)) return any_wave(v);
    const Quarters quarters(v);
    return wave(std::cos(v.lo), std::cos(v.hi), quarters.hold(0), quarters.hold(2));
}
Waves sin_and_cos(const Interval& v) {
    if (!is_usual_angle(v)) return {any_wave(v), any_wave(v)};
    const Quarters quarters(v);
    return {wave(std::sin(v.lo), std::sin(v.hi), quarters.hold(1), quarters.hold(3)),
            wave(std::cos(v.lo), std::cos(v.hi), quarters.hold(0), quarters.hold(2))};
}

Interval tan(const Interval& v) {
    const bool nan = v.maybe_nan || v.has_infinity();
    const bool far = !(v.lo > -largest_angle && v.hi < largest_angle);
    if (far || meets(v, pi / 2, pi)) return {-infinity, infinity, nan};
    return rising(std::tan, v);
}

Interval asin(const Interval& v) {
    Interval in = v;
    return cut(in, -1, 1) ? rising(std::asin, in) : Interval::everything();
}

Interval acos(const Interval& v) {
    Interval in = v;
    if (!cut(in, -1, 1)) return Interval::everything();
    return widened(std::acos(in.hi), std::acos(in.lo), in.maybe_nan);
}

Interval atan(const Interval& v) { return rising(std::atan, v); }

Interval atan2(const Interval& y, const Interval& x) {
    const bool nan = y.maybe_nan || x.maybe_nan;
    if (y.holds(0) && x.lo <= 0) return widened(-pi, pi, nan);
    const auto [lo, hi] = std::minmax(
        {std::atan2(y.lo, x.lo), std::atan2(y.lo, x.hi), std::atan2(y.hi, x.lo), std::atan2(y.hi, x.hi)});
    return widened(lo, hi, nan);
}

Interval sinh(const Interval& v) { return rising(std::sinh, v); }
Interval cosh(const Interval& v) { return rising(std::cosh, abs(v)); }
Interval tanh(const Interval& v) { return rising(std::tanh, v); }
Interval asinh(const Interval& v) { return rising(std::asinh, v); }

Interval acosh(const Interval& v) {
    Interval in = v;
    return cut(in, 1, infinity) ? rising(std::acosh, in) : Interval::everything();
}

Interval atanh(const Interval& v) {
    Interval in = v;
    return cut(in, -1, 1) ? rising(std::atanh, in) : Interval::everything();
}

}  // namespace rb
