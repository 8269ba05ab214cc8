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

    explicit QuickRoots(const Coefficients& c) : c_(c) {
        double magnitude = 0.0;
#pragma GCC unroll 16
        for (size_t i = 0; i <= N; ++i) magnitude += std::abs(c[i]);
        constexpr double unit_rounding = 0x1p-53;
        margin_ = 8.0 * static_cast<double>(N + 5) * unit_rounding * magnitude;
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

}  // namespace rb
