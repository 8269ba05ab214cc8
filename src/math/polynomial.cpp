// Roots of polynomials of any degree; roots.cpp has the fast ones of low degree.
#include "math/roots.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace rb {

namespace {

using Coefficients = std::array<double, most_degree + 1>;

class PolynomialRoots {
public:
    PolynomialRoots(std::span<const double> c, std::span<double> roots)
        : c_(c), degree_(c.size() - 1), roots_(roots) {}

    int run(double lo, double hi) {
        const Coefficients b = bernstein(lo, hi);
        search(b, lo, value(lo), hi, value(hi), depth);
        return count_;
    }

private:
    /// Halvings of the interval; what is closer together counts as one place.
    static constexpr int depth = 44;

    double value(double x) const {
        double f = 0.0;
        for (const double c : c_) f = f * x + c;
        return f;
    }

    /// Coefficients over [lo, hi]: Taylor shift to lo, scaled by the width. Sets the margin of their
    /// rounding.
    Coefficients bernstein(double lo, double hi) {
        Coefficients b{};
        double magnitude = 0.0;
        double total = 0.0;
        for (size_t i = 0; i <= degree_; ++i) {
            b[i] = c_[degree_ - i];
            magnitude = magnitude * std::abs(lo) + std::abs(c_[i]);
        }
        for (size_t k = 0; k < degree_; ++k) {
            for (size_t i = degree_; i-- > k;) b[i] += lo * b[i + 1];
        }
        double power = 1.0;
        double choose = 1.0;
        for (size_t k = 1; k <= degree_; ++k) {
            power *= hi - lo;
            choose *= static_cast<double>(degree_ + 1 - k) / static_cast<double>(k);
            b[k] *= power;
            total += std::abs(b[k]);
            b[k] /= choose;
        }
        for (size_t k = 1; k <= degree_; ++k) {
            for (size_t i = degree_; i >= k; --i) b[i] += b[i - 1];
        }
        constexpr double rounding = 64.0 * std::numeric_limits<double>::epsilon();
        margin_ = rounding * (magnitude + total);
        return b;
    }

    void search(const Coefficients& b, double lo, double flo, double hi, double fhi, int levels) {
        bool all_above = true;
        bool all_below = true;
        bool all_noise = true;
        int changes = 0;
        for (size_t i = 0; i <= degree_; ++i) {
            all_above = all_above && b[i] > margin_;
            all_below = all_below && b[i] < -margin_;
            all_noise = all_noise && std::abs(b[i]) <= margin_;
            if (i > 0 && (b[i] < 0.0) != (b[i - 1] < 0.0)) ++changes;
        }
        if (all_above || all_below) return;
        const bool opposite = (flo < 0.0) != (fhi < 0.0);
        if (opposite && changes == 1) {
            add(root_between(lo, flo, hi, fhi));
            return;
        }
        const double x = 0.5 * (lo + hi);
        // Where rounding decides the signs, cutting on tells nothing.
        if (all_noise || levels == 0 || !(x > lo && x < hi)) {
            if (opposite) add(root_between(lo, flo, hi, fhi));
            return;
        }
        Coefficients right = b;
        Coefficients left{};
        left[0] = b[0];
        for (size_t k = 1; k <= degree_; ++k) {
            for (size_t i = 0; i <= degree_ - k; ++i) right[i] = 0.5 * (right[i] + right[i + 1]);
            left[k] = right[0];
        }
        const double f = value(x);
        search(left, lo, flo, x, f, levels - 1);
        search(right, x, f, hi, fhi, levels - 1);
    }

    /// Newton's iteration, kept in the bracket, to the last bits.
    double root_between(double a, double fa, double b, double fb) const {
        double x = a - fa * ((b - a) / (fb - fa));
        if (!(x > a && x < b)) x = 0.5 * (a + b);
        double before = b - a;
        constexpr int most = 200;
        for (int i = 0; i < most; ++i) {
            double f = 0.0;
            double slope = 0.0;
            for (const double c : c_) {
                slope = slope * x + f;
                f = f * x + c;
            }
            if (f == 0.0) return x;
            ((f < 0.0) == (fa < 0.0) ? a : b) = x;
            double next = x - f / slope;
            if (!(next > a && next < b) || std::abs(next - x) > 0.5 * before) next = 0.5 * (a + b);
            before = std::abs(next - x);
            if (!(next > a && next < b) || before <= std::numeric_limits<double>::epsilon() * std::abs(next))
                return next;
            x = next;
        }
        return x;
    }

    void add(double x) {
        if (count_ > 0 && x <= roots_[static_cast<size_t>(count_ - 1)]) return;
        roots_[static_cast<size_t>(count_++)] = x;
    }

    std::span<const double> c_;
    size_t degree_;
    std::span<double> roots_;
    int count_ = 0;
    double margin_ = 0;
};

}  // namespace

int solve_polynomial(std::span<const double> c, double lo, double hi, std::span<double> roots) {
    if (c.size() < 2 || !(lo < hi)) return 0;
    return PolynomialRoots(c, roots).run(lo, hi);
}

}  // namespace rb
