#include "math/roots.h"

#include "math/bernstein.h"
#include "math/bracketed_root.h"

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

/// Roots by cutting an interval in halves until the signs of the Bernstein coefficients tell: no change, no
/// root; one change, one root.
template <size_t N>
class Isolation {
public:
    using Coefficients = std::array<double, N + 1>;

    Isolation(const Coefficients& c, double* roots, int most) : c_(c), roots_(roots), most_(most) {}

    int search(double lo, double hi) {
        const Coefficients b = bernstein(lo, hi);
        if (signs(b).possible > 0) search(b, end(lo), end(hi), depth);
        return count_;
    }

    bool changes_sign(double lo, double hi) {
        const End first = end(lo);
        const End last = end(hi);
        if ((first.f < 0.0) != (last.f < 0.0)) return true;
        return changes_sign(bernstein(lo, hi), first, last, depth);
    }

private:
    static constexpr int depth = 5;
    struct End {
        double x;
        double f;
    };
    struct Signs {
        int possible;  ///< 0: surely no root
        bool one;      ///< surely one
    };

    End end(double x) const { return {x, value_at<N>(c_, x).f}; }

    /// Coefficients over [lo, hi]; sets the margin of their rounding.
    Coefficients bernstein(double lo, double hi) {
        // Taylor shift to lo, then scale by the width.
        Coefficients b;
        std::reverse_copy(c_.begin(), c_.end(), b.begin());
        double magnitude = std::abs(c_[0]);
        for (size_t i = 1; i <= N; ++i) magnitude = magnitude * std::abs(lo) + std::abs(c_[i]);
        for (size_t k = 0; k < N; ++k) {
            for (size_t i = N; i-- > k;) b[i] += lo * b[i + 1];
        }
        double power = 1.0;
        double choose = 1.0;
        for (size_t k = 1; k <= N; ++k) {
            power *= hi - lo;
            choose *= static_cast<double>(N + 1 - k) / static_cast<double>(k);
            b[k] *= power;
            magnitude += std::abs(b[k]);
            b[k] /= choose;
        }
        for (size_t k = 1; k <= N; ++k) {
            for (size_t i = N; i >= k; --i) b[i] += b[i - 1];
        }
        constexpr double rounding = 64.0 * std::numeric_limits<double>::epsilon();
        margin_ = rounding * magnitude;
        return b;
    }

    Signs signs(const Coefficients& b) const {
        int above = 0;
        int below = 0;
        int changes = 0;
        for (size_t i = 0; i <= N; ++i) {
            above += b[i] > margin_ ? 1 : 0;
            below += b[i] < -margin_ ? 1 : 0;
            if (i > 0) changes += (b[i] < 0.0) != (b[i - 1] < 0.0) ? 1 : 0;
        }
        constexpr int all = static_cast<int>(N) + 1;
        return {above == all || below == all ? 0 : 1, above + below == all && changes == 1};
    }

    void search(const Coefficients& b, const End& lo, const End& hi, int levels) {
        if (count_ >= most_) return;
        const Signs found = signs(b);
        if (found.possible == 0) return;
        if (found.one && (lo.f < 0.0) != (hi.f < 0.0)) {
            add(root_between<N>(c_, lo.x, lo.f, hi.x, hi.f));
            return;
        }
        const double x = 0.5 * (lo.x + hi.x);
        if (levels == 0 || !(x > lo.x && x < hi.x)) {
            double roots[N];
            const int n = roots_in<N>(c_, lo.x, hi.x, roots);
            for (int i = 0; i < n; ++i) add(roots[i]);
            return;
        }
        const auto cut = halve(b);
        const End middle = end(x);
        search(cut.left, lo, middle, levels - 1);
        search(cut.right, middle, hi, levels - 1);
    }

    /// For ends of the same sign.
    bool changes_sign(const Coefficients& b, const End& lo, const End& hi, int levels) {
        if (signs(b).possible == 0) return false;
        const double x = 0.5 * (lo.x + hi.x);
        if (levels == 0 || !(x > lo.x && x < hi.x)) {
            double roots[N];
            return roots_in<N>(c_, lo.x, hi.x, roots) > 0;
        }
        const End middle = end(x);
        if ((middle.f < 0.0) != (lo.f < 0.0)) return true;
        const auto cut = halve(b);
        return changes_sign(cut.left, lo, middle, levels - 1) ||
               changes_sign(cut.right, middle, hi, levels - 1);
    }

    /// A root at the end of two intervals comes twice.
    void add(double x) {
        if (count_ >= most_ || (count_ > 0 && x <= roots_[count_ - 1])) return;
        roots_[count_++] = x;
    }

    const Coefficients& c_;
    double* roots_;
    int most_;
    int count_ = 0;
    double margin_ = 0;
};

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

int solve_cubic(const std::array<double, 4>& c, double lo, double hi, std::span<double, 3> roots, int most) {
    return Isolation<3>(c, roots.data(), most).search(lo, hi);
}

int solve_quartic(const std::array<double, 5>& c, double lo, double hi, std::span<double, 4> roots,
                  int most) {
    return Isolation<4>(c, roots.data(), most).search(lo, hi);
}

bool changes_sign(const std::array<double, 4>& c, double lo, double hi) {
    return Isolation<3>(c, nullptr, 0).changes_sign(lo, hi);
}

bool changes_sign(const std::array<double, 5>& c, double lo, double hi) {
    return Isolation<4>(c, nullptr, 0).changes_sign(lo, hi);
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
