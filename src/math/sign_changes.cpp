// Where pieces of curves cross a line or a surface: roots between 0 and 1 whose number the signs at both ends
// decide.
#include "math/bernstein.h"
#include "math/bracketed_root.h"
#include "math/roots.h"

namespace rb {

namespace {

/// Halves the interval until the signs of the Bernstein coefficients between the given end signs change once
/// or not at all (Descartes' rule in Bernstein form).
template <size_t N>
class SignChanges {
public:
    using Coefficients = std::array<double, N + 1>;
    struct End {
        double x;
        double f;  ///< never 0
    };

    SignChanges(const Coefficients& c, std::span<double, N> roots) : c_(c), roots_(roots) {}

    int search(bool negative_at_0, bool negative_at_1) {
        double at_1 = 0.0;
        double magnitude = 0.0;
        for (const double a : c_) {
            at_1 += a;
            magnitude += std::abs(a);
        }
        constexpr double rounding = 32.0 * std::numeric_limits<double>::epsilon();
        margin_ = rounding * magnitude;
        search(bernstein_over_unit(c_), {0.0, with_sign(c_[N], negative_at_0)},
               {1.0, with_sign(at_1, negative_at_1)}, depth);
        return static_cast<int>(count_);
    }

private:
    /// What is closer together than 2^-depth and does not change the sign is no root.
    static constexpr int depth = 40;

    static double with_sign(double f, bool negative) {
        if (f != 0.0 && (f < 0.0) == negative) return f;
        return negative ? -std::numeric_limits<double>::min() : std::numeric_limits<double>::min();
    }

    void search(const Coefficients& b, const End& lo, const End& hi, int levels) {
        // What rounding could turn may hide two roots, unless both neighbours agree anyway.
        bool sure = true;
        bool noise = true;
        int changes = 0;
        bool negative = lo.f < 0.0;
        for (size_t i = 1; i < N; ++i) {
            const bool clear = std::abs(b[i]) > margin_;
            sure = sure && clear;
            noise = noise && !clear;
            changes += (b[i] < 0.0) != negative ? 1 : 0;
            negative = b[i] < 0.0;
        }
        changes += (hi.f < 0.0) != negative ? 1 : 0;
        const bool opposite = (lo.f < 0.0) != (hi.f < 0.0);
        if (sure && changes == 0) return;
        const double x = 0.5 * (lo.x + hi.x);
        if ((sure && changes == 1) || noise || levels == 0) {
            if (opposite && count_ < N) roots_[count_++] = root_between<N>(c_, lo.x, lo.f, hi.x, hi.f);
            return;
        }
        const auto cut = halve(b);
        const double f = value_at<N>(c_, x).f;
        const End middle{x, with_sign(f, f < 0.0)};
        search(cut.left, lo, middle, levels - 1);
        search(cut.right, middle, hi, levels - 1);
    }

    const Coefficients& c_;
    std::span<double, N> roots_;
    size_t count_ = 0;
    double margin_ = 0;  ///< of the coefficients' rounding
};

int changes_of_linear(const std::array<double, 2>& c, bool negative_at_0, bool negative_at_1,
                      std::span<double, 1> roots) {
    if (negative_at_0 == negative_at_1) return 0;
    const double x = -c[1] / c[0];
    roots[0] = std::isnan(x) ? 0.5 : std::clamp(x, 0.0, 1.0);
    return 1;
}

int changes_of_quadratic(const std::array<double, 3>& c, bool negative_at_0, bool negative_at_1,
                         std::span<double, 2> roots) {
    const bool opposite = negative_at_0 != negative_at_1;
    const double middle = c[2] + 0.5 * c[1];
    if (!opposite && (middle < 0.0) == negative_at_0) return 0;
    std::array<double, 2> all{};
    const int n = solve_quadratic(c[0], 0.5 * c[1], c[2], all);
    if (!opposite) {
        // Both are within or none: where one is beyond an end it is by rounding, of the nearer of the two.
        const double between = 0.5 * (all[0] + all[1]);
        if (n < 2 || !(between > 0.0 && between < 1.0)) return 0;
        roots[0] = std::clamp(all[0], 0.0, 1.0);
        roots[1] = std::clamp(all[1], 0.0, 1.0);
        return 2;
    }
    if (n == 0) {
        // Then the given sign at one end contradicts a value that is mere rounding.
        roots[0] = (c[2] < 0.0) == negative_at_0 ? 1.0 : 0.0;
        return 1;
    }
    // Between the roots the sign is opposite to that of the leading coefficient.
    const bool second = n == 2 && negative_at_0 == (c[0] > 0.0);
    roots[0] = std::clamp(all[second ? 1 : 0], 0.0, 1.0);
    return 1;
}

}  // namespace

template <size_t N>
int sign_changes(const std::array<double, N + 1>& c, bool negative_at_0, bool negative_at_1,
                 std::span<double, N> roots) {
    if constexpr (N == 1) {
        return changes_of_linear(c, negative_at_0, negative_at_1, roots);
    } else if constexpr (N == 2) {
        return changes_of_quadratic(c, negative_at_0, negative_at_1, roots);
    } else {
        return SignChanges<N>(c, roots).search(negative_at_0, negative_at_1);
    }
}

template int sign_changes<1>(const std::array<double, 2>&, bool, bool, std::span<double, 1>);
template int sign_changes<2>(const std::array<double, 3>&, bool, bool, std::span<double, 2>);
template int sign_changes<3>(const std::array<double, 4>&, bool, bool, std::span<double, 3>);
template int sign_changes<4>(const std::array<double, 5>&, bool, bool, std::span<double, 4>);
template int sign_changes<5>(const std::array<double, 6>&, bool, bool, std::span<double, 5>);
template int sign_changes<6>(const std::array<double, 7>&, bool, bool, std::span<double, 6>);

}  // namespace rb
