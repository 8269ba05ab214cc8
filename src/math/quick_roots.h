#pragma once
#include "math/bernstein.h"
#include "math/bracketed_root.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>

namespace rb {

/// The places in [0, 1] where a polynomial of degree N (highest power first) changes its sign, in double
/// precision: the interval is halved until the signs of the Bernstein coefficients, all clear of rounding,
/// change once or not at all (Descartes' rule).
template <size_t N>
class QuickRoots {
public:
    using Coefficients = std::array<double, N + 1>;

    /// `error`: what the coefficients' own errors may change of a value in [0, 1].
    explicit QuickRoots(const Coefficients& c, double error = 0.0) : c_(c) {
        double magnitude = 0.0;
#pragma GCC unroll 16
        for (size_t i = 0; i <= N; ++i) magnitude += std::abs(c[i]);
        constexpr double unit_rounding = 0x1p-53;
        margin_ = 8.0 * static_cast<double>(N + 5) * unit_rounding * magnitude + error;
    }

    /// Writes them in ascending order and returns their number; empty where double precision or a few
    /// halvings cannot tell them apart: see solve_polynomial().
    std::optional<size_t> search(std::span<double, N> roots) {
        size_t count = 0;
        if (!search(bernstein_over_unit(c_), 0.0, 1.0, most_halvings, roots, count)) return std::nullopt;
        return count;
    }

private:
    static constexpr int most_halvings = 16;

    bool search(const Coefficients& b, double lo, double hi, int halvings, std::span<double, N> roots,
                size_t& count) const {
        int unclear = 0;
        int changes = 0;
#pragma GCC unroll 16
        for (size_t i = 0; i <= N; ++i) unclear += std::abs(b[i]) > margin_ ? 0 : 1;
#pragma GCC unroll 16
        for (size_t i = 1; i <= N; ++i) changes += (b[i] < 0.0) != (b[i - 1] < 0.0) ? 1 : 0;
        if (unclear == 0 && changes == 0) return true;
        if (unclear == 0 && changes == 1) {
            roots[count++] = root_between<N>(c_, lo, b[0], hi, b[N]);
            return true;
        }
        if (halvings == 0 || !(std::abs(b[0]) > margin_ && std::abs(b[N]) > margin_)) return false;
        const auto cut = halve(b);
        const double middle = 0.5 * (lo + hi);
        return search(cut.left, lo, middle, halvings - 1, roots, count) &&
               search(cut.right, middle, hi, halvings - 1, roots, count);
    }

    const Coefficients& c_;
    double margin_;  ///< of the coefficients' rounding
};

/// To the last bits of the coefficients, from a place very near a simple root.
template <size_t N>
double polished(const std::array<double, N + 1>& c, double t) {
    constexpr int most = 3;
    for (int i = 0; i < most; ++i) {
        const Value<N> v = value_at<N>(c, t);
        const double step = v.f / v.slope;
        t -= step;
        if (std::abs(step) <= 0x1p-40 * std::abs(t)) break;
    }
    return t;
}

/// The same in [lo, hi], both finite; empty if 0 is a root.
template <size_t N>
std::optional<size_t> quick_roots_between(const std::array<double, N + 1>& c, double lo, double hi,
                                          std::span<double, N> roots) {
    if (c[N] == 0.0) return std::nullopt;
    const double reach = std::fmax(std::abs(lo), std::abs(hi));
    const double width = hi - lo;
    // By synthetic division the polynomial of u, t = lo + width u.
    std::array<double, N + 1> moved = c;
    double magnitude = std::abs(c[0]);
#pragma GCC unroll 16
    for (size_t i = 1; i <= N; ++i) magnitude = magnitude * reach + std::abs(c[i]);
#pragma GCC unroll 16
    for (size_t last = N; last > 0; --last) {
#pragma GCC unroll 16
        for (size_t i = 1; i <= last; ++i) moved[i] += moved[i - 1] * lo;
    }
    double power = 1.0;
    for (size_t i = N + 1; i-- > 0; power *= width) moved[i] *= power;
    constexpr double rounding = 0x1p-53 * static_cast<double>(4 * N * N);
    const auto count = QuickRoots<N>(moved, rounding * magnitude).search(roots);
    if (!count) return std::nullopt;
    for (size_t k = 0; k < *count; ++k) {
        const double t = lo + width * roots[k];
        roots[k] = polished<N>(c, t);
        constexpr double small = 1e-6;
        if (!(std::abs(roots[k] - t) <= small * width)) return std::nullopt;
    }
    return count;
}

}  // namespace rb
