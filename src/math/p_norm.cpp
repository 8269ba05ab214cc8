#include "math/p_norm.h"

#include <algorithm>
#include <cmath>

namespace rb {

PNorm::PNorm(double p) : p_(p), root_(1.0 / p) {
    constexpr int most_factors = 64;
    if (p <= most_factors && std::trunc(p) == p) whole_ = static_cast<int>(p);
    for (const int squares : {1, 2, 3}) {
        if (whole_ == 1 << squares) squares_ = squares;
    }
}

double PNorm::power(double base) const {
    if (whole_ == 0) return std::pow(base, p_);
    double out = 1.0;
    for (int n = whole_; n > 0; n >>= 1) {
        if (n & 1) out *= base;
        base *= base;
    }
    return out;
}

double PNorm::root(double base) const {
    if (squares_ == 0) return whole_ == 1 ? base : std::pow(base, root_);
    for (int i = 0; i < squares_; ++i) base = std::sqrt(base);
    return base;
}

double PNorm::operator()(double a, double b) const {
    const double most = std::max(a, b);
    if (!(most > 0.0)) return 0.0;
    return most * root(1.0 + power(std::min(a, b) / most));
}

PNorm::Growth PNorm::growth(double a, double b) const {
    const double most = std::max(a, b);
    if (!(most > 0.0)) return {0.0, 0.0, 0.0};
    const double ratio = std::min(a, b) / most;
    const double small = power(ratio);
    const double sum = 1.0 + small;
    const double stretch = root(sum);
    // (a / value)^(p - 1).
    const double by_most = stretch / sum;
    double by_least = 0.0;
    if (ratio > 0.0) {
        by_least = by_most * (small / ratio);
    } else if (p_ <= 1.0) {
        by_least = p_ == 1.0 ? 1.0 : std::numeric_limits<double>::infinity();
    }
    const double value = most * stretch;
    return a > b ? Growth{value, by_most, by_least} : Growth{value, by_least, by_most};
}

IntervalSlope PNorm::operator()(const IntervalSlope& a, const IntervalSlope& b) const {
    // Growth depends on a / b alone: these are its bounds.
    const Growth first = growth(a.value.lo, b.value.hi);
    const Growth last = growth(a.value.hi, b.value.lo);
    constexpr double rounding = 64.0 * std::numeric_limits<double>::epsilon();
    const auto between = [](double u, double v) {
        return Interval(std::min(u, v) * (1.0 - rounding), std::max(u, v) * (1.0 + rounding));
    };
    const Interval value = between((*this)(a.value.lo, b.value.lo), (*this)(a.value.hi, b.value.hi));
    // Where both may vanish, so may the ratio be any.
    const bool any = a.value.lo == 0.0 && b.value.lo == 0.0;
    const Interval all =
        p_ >= 1.0 ? Interval(0.0, 1.0) : Interval(1.0, std::numeric_limits<double>::infinity());
    const Interval by_a = any ? all : between(first.by_a, last.by_a);
    const Interval by_b = any ? all : between(first.by_b, last.by_b);
    return {value, by_a * a.slope + by_b * b.slope};
}

}  // namespace rb
