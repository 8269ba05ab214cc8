#include "math/roots.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace rb {

namespace {

/// b^2 - a c with a relative error of about 1.5 ulp, also where the products cancel.
double discriminant(double a, double b, double c) {
    const double p = b * b;
    const double q = a * c;
    const double d = p - q;
    if (3.0 * std::abs(d) >= p + std::abs(q)) return d;
    return d + (std::fma(b, b, -p) - std::fma(a, c, -q));
}

template <size_t N>
struct Value {
    double f;
    double slope;
};

/// Horner for the value and the slope at once.
template <size_t N>
Value<N> value_at(const std::array<double, N + 1>& c, double x) {
    double f = c[0];
    double slope = 0.0;
    for (size_t i = 1; i <= N; ++i) {
        slope = slope * x + f;
        f = f * x + c[i];
    }
    return {f, slope};
}

/// The root between a and b, where the values `fa` and `fb` have opposite signs.
template <size_t N>
double root_between(const std::array<double, N + 1>& c, double a, double fa, double b, double fb) {
    // Secant's first guess: pieces are monotone and mostly short.
    double x = a - fa * ((b - a) / (fb - fa));
    if (!(x > a && x < b)) x = 0.5 * (a + b);
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
        // Newton may creep along a multiple root: every fourth step halves.
        if (!(next > a && next < b) || i % 4 == 3) next = 0.5 * (a + b);
        if (std::abs(next - x) <= std::numeric_limits<double>::epsilon() * std::abs(next) || next == a ||
            next == b) {
            return next;
        }
        x = next;
    }
    return x;
}

template <size_t N>
int roots_in(const std::array<double, N + 1>& c, double lo, double hi, double* roots);

template <>
int roots_in<2>(const std::array<double, 3>& c, double lo, double hi, double* roots) {
    std::array<double, 2> all{};
    const int n = solve_quadratic(c[0], 0.5 * c[1], c[2], all);
    int kept = 0;
    for (int i = 0; i < n; ++i) {
        const double x = all[static_cast<size_t>(i)];
        if (x >= lo && x <= hi) roots[kept++] = x;
    }
    return kept;
}

template <size_t N>
int roots_in(const std::array<double, N + 1>& c, double lo, double hi, double* roots) {
    std::array<double, N> derivative;
    for (size_t i = 0; i < N; ++i) derivative[i] = static_cast<double>(N - i) * c[i];
    double cuts[N + 1];
    int pieces = roots_in<N - 1>(derivative, lo, hi, cuts);
    cuts[pieces++] = hi;
    double a = lo;
    double fa = value_at<N>(c, a).f;
    int n = 0;
    if (fa == 0.0) roots[n++] = a;
    for (int i = 0; i < pieces; ++i) {
        const double b = cuts[i];
        if (!(b > a)) continue;
        const double fb = value_at<N>(c, b).f;
        if (fb == 0.0) {
            roots[n++] = b;
        } else if (fa != 0.0 && (fa < 0.0) != (fb < 0.0)) {
            roots[n++] = root_between<N>(c, a, fa, b, fb);
        }
        a = b;
        fa = fb;
    }
    return n;
}

/// True if no root can lie in [lo, hi]: all Bernstein coefficients there have one sign.
bool one_sign(const std::array<double, 5>& c, double lo, double hi) {
    // Taylor shift to lo, then scale by the width.
    std::array<double, 5> t = c;
    for (size_t k = 0; k < 4; ++k) {
        for (size_t i = 1; i <= 4 - k; ++i) t[i] += lo * t[i - 1];
    }
    const double w = hi - lo;
    const double p1 = t[3] * w;
    const double p2 = t[2] * w * w;
    const double p3 = t[1] * w * w * w;
    const double p4 = t[0] * (w * w) * (w * w);
    const double b0 = t[4];
    const double b1 = b0 + p1 * 0.25;
    const double b2 = b0 + p1 * 0.5 + p2 / 6.0;
    const double b3 = b0 + p1 * 0.75 + p2 * 0.5 + p3 * 0.25;
    const double b4 = b0 + p1 + p2 + p3 + p4;
    const double magnitude = std::abs(b0) + std::abs(p1) + std::abs(p2) + std::abs(p3) + std::abs(p4);
    const double least = std::min({b0, b1, b2, b3, b4});
    const double most = std::max({b0, b1, b2, b3, b4});
    constexpr double rounding = 64.0 * std::numeric_limits<double>::epsilon();
    return least > rounding * magnitude || most < -rounding * magnitude;
}

}  // namespace

int solve_quadratic(double a, double half_b, double c, std::span<double, 2> roots) {
    if (a == 0.0) {
        if (half_b == 0.0) return 0;
        roots[0] = -0.5 * c / half_b;
        return 1;
    }
    const double d = discriminant(a, half_b, c);
    if (d < 0.0 || std::isnan(d)) return 0;
    const double q = -(half_b + std::copysign(std::sqrt(d), half_b));
    if (q == 0.0) {
        roots[0] = 0.0;
        return 1;
    }
    const double x = q / a;
    const double y = c / q;
    if (d == 0.0) {
        roots[0] = x;
        return 1;
    }
    if (!std::isfinite(x)) {
        roots[0] = y;
        return 1;
    }
    roots[0] = std::min(x, y);
    roots[1] = std::max(x, y);
    return 2;
}

int solve_cubic(const std::array<double, 4>& c, double lo, double hi, std::span<double, 3> roots) {
    return roots_in<3>(c, lo, hi, roots.data());
}

int solve_quartic(const std::array<double, 5>& c, double lo, double hi, std::span<double, 4> roots) {
    if (one_sign(c, lo, hi)) return 0;
    return roots_in<4>(c, lo, hi, roots.data());
}

double root_bound(std::span<const double> coefficients) {
    size_t first = 0;
    while (first < coefficients.size() && coefficients[first] == 0.0) ++first;
    if (first + 1 >= coefficients.size()) return 0.0;
    double largest = 0.0;
    for (size_t i = first + 1; i < coefficients.size(); ++i) {
        largest = std::max(largest, std::abs(coefficients[i] / coefficients[first]));
    }
    return 1.0 + largest;
}

}  // namespace rb
