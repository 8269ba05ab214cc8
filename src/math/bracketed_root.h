#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace rb {

template <size_t N>
struct Value {
    double f;
    double slope;
    double bend;  ///< half the second derivative
};

/// Horner for all three at once.
template <size_t N>
Value<N> value_at(const std::array<double, N + 1>& c, double x) {
    double f = c[0];
    double slope = 0.0;
    double bend = 0.0;
    for (size_t i = 1; i <= N; ++i) {
        bend = bend * x + slope;
        slope = slope * x + f;
        f = f * x + c[i];
    }
    return {f, slope, bend};
}

/// The root between a and b, to the last bits, where the values `fa` and `fb` have opposite signs.
template <size_t N>
double root_between(const std::array<double, N + 1>& c, double a, double fa, double b, double fb) {
    // Secant's first guess: pieces are monotone and mostly short. Not next to an end, where what looks like a
    // root may be the rounding of one that lies at or beyond that end.
    double x = a - fa * ((b - a) / (fb - fa));
    const double apart = 0x1p-20 * (b - a);
    if (!(x - a > apart && b - x > apart)) x = 0.5 * (a + b);
    constexpr double eps = std::numeric_limits<double>::epsilon();
    const double least = 0.125 * (b - a);
    double before = b - a;
    double last = before;
    constexpr int most = 100;
    for (int i = 0; i < most; ++i) {
        const Value<N> v = value_at<N>(c, x);
        if (v.f == 0.0) return x;
        if ((v.f < 0.0) == (fa < 0.0)) {
            a = x;
        } else {
            b = x;
        }
        double next = x - v.f / v.slope;
        // Newton may creep along a multiple root: then halving is faster.
        const bool halves = !(next > a && next < b) || std::abs(next - x) > 0.5 * before;
        if (halves) next = 0.5 * (a + b);
        before = last;
        last = std::abs(next - x);
        const double enough = eps * std::max(std::abs(next), least);
        // The step that would follow is too small to matter, by the bend here (which an inflection hides) and
        // by how the steps have shrunk.
        const bool bends_little = std::abs(v.bend) * last * last <= 0.25 * enough * std::abs(v.slope);
        const bool settled = !halves && bends_little && last * last * last <= enough * before * before;
        if (last <= enough || settled || next == a || next == b) return next;
        x = next;
    }
    return x;
}

}  // namespace rb
