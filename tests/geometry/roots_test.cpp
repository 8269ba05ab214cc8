#include "math/roots.h"

#include "math/quick_roots.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace rb {
namespace {

std::vector<double> quartic(const std::array<double, 5>& c) {
    std::array<double, 4> roots{};
    const double bound = root_bound(c);
    const int n = solve_quartic(c, -bound, bound, roots);
    return {roots.begin(), roots.begin() + n};
}

double value(const std::array<double, 5>& c, double x) {
    return (((c[0] * x + c[1]) * x + c[2]) * x + c[3]) * x + c[4];
}

TEST(Roots, QuadraticDoesNotCancel) {
    std::array<double, 2> r{};
    ASSERT_EQ(solve_quadratic(1.0, -0.5e8, 1.0, r), 2);
    EXPECT_DOUBLE_EQ(r[0], 1e-8);
    EXPECT_DOUBLE_EQ(r[1], 1e8);
    ASSERT_EQ(solve_quadratic(0.0, 1.0, -4.0, r), 1);
    EXPECT_DOUBLE_EQ(r[0], 2.0);
    EXPECT_EQ(solve_quadratic(1.0, 0.0, 1.0, r), 0);
    EXPECT_EQ(solve_quadratic(0.0, 0.0, 1.0, r), 0);
    ASSERT_EQ(solve_quadratic(1.0, 0.0, 0.0, r), 1);
    EXPECT_EQ(r[0], 0.0);
}

TEST(Roots, CubicFindsAll) {
    std::array<double, 3> r{};
    ASSERT_EQ(solve_cubic({1, -6, 11, -6}, 0, 10, r), 3);
    EXPECT_NEAR(r[0], 1, 1e-14);
    EXPECT_NEAR(r[1], 2, 1e-14);
    EXPECT_NEAR(r[2], 3, 1e-14);
    EXPECT_EQ(solve_cubic({0, 0, 1, -0.5}, 0, 1, r), 1);
}

// Polynomials that public solvers have lost roots of.
TEST(Roots, KnownHardQuartics) {
    EXPECT_EQ(quartic({1, -240, 25449, -1325880, 26471900.25}).size(), 2u);
    const auto sturm = quartic({1, -7, 0, 7, -1});
    ASSERT_EQ(sturm.size(), 4u);
    EXPECT_NEAR(sturm[3], 6.854101966249685, 1e-12);
    EXPECT_EQ(quartic({1, 0, 0, 1, 1}).size(), 0u);
    EXPECT_EQ(quartic({1, 0, 0, -1, -1}).size(), 2u);
    for (const double tail : {1e-12, 1e-28}) {
        const auto roots = quartic({1, -1, 0, 0, -tail});
        ASSERT_EQ(roots.size(), 2u);
        EXPECT_NEAR(roots[1], 1.0, 1e-11);
    }
    const std::array<double, 5> torus{1, -202.35, 15343, -516680, 6.52025e6};
    for (const double x : quartic(torus)) EXPECT_NEAR(value(torus, x) / 6.52025e6, 0.0, 1e-12);
}

TEST(Roots, RandomQuarticsKeepSimpleRoots) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> place(-1, 1);
    int lost = 0;
    for (int i = 0; i < 100000; ++i) {
        std::array<double, 4> wanted{place(random), place(random), place(random), place(random)};
        std::sort(wanted.begin(), wanted.end());
        double gap = 1;
        for (size_t k = 0; k < 3; ++k) gap = std::min(gap, wanted[k + 1] - wanted[k]);
        if (gap < 1e-3) continue;
        const double a = wanted[0], b = wanted[1], c = wanted[2], d = wanted[3];
        const std::array<double, 5> p{1, -(a + b + c + d), a * b + a * c + a * d + b * c + b * d + c * d,
                                      -(a * b * c + a * b * d + a * c * d + b * c * d), a * b * c * d};
        EXPECT_TRUE(changes_sign(p, -1.5, a + 0.5 * gap));
        EXPECT_TRUE(changes_sign(p, a + 0.5 * gap, d - 0.5 * gap));
        EXPECT_FALSE(changes_sign(p, a + 0.1 * gap, b - 0.1 * gap));
        std::array<double, 4> got{};
        const int n = solve_quartic(p, -1.5, 1.5, got);
        if (n != 4) {
            ++lost;
            continue;
        }
        for (size_t k = 0; k < 4; ++k)
            ASSERT_NEAR(got[k], wanted[k], 1e-13 / (gap * gap * gap) * 1e-2 + 1e-13);
    }
    EXPECT_EQ(lost, 0);
}

TEST(Roots, PairsOfCloseRoots) {
    // (x - 1/4)(x - 1/4 - e)(x^2 + 1): the two roots must be seen as long as doubles can tell them apart.
    for (const double e : {1e-2, 1e-4, 1e-6, 1e-7}) {
        const double s = 0.5 + e;
        const double p = 0.25 * (0.25 + e);
        const auto roots = quartic({1, -s, p + 1, -s, p});
        ASSERT_EQ(roots.size(), 2u) << e;
        EXPECT_NEAR(roots[0], 0.25, 1e-15 / e);
        EXPECT_NEAR(roots[1], 0.25 + e, 1e-15 / e);
    }
}

TEST(Roots, SignChangesObeyTheGivenEnds) {
    // (x - 1/4)(x - 1/2)(x - 3/4), and an end exactly on a root, where the given sign decides.
    std::array<double, 3> got{};
    ASSERT_EQ(sign_changes<3>({1, -1.5, 0.6875, -0.09375}, true, false, got), 3);
    for (size_t k = 0; k < 3; ++k) EXPECT_NEAR(got[k], 0.25 * static_cast<double>(k + 1), 1e-15);
    std::array<double, 2> two{};
    EXPECT_EQ(sign_changes<2>({1, -0.5, 0}, false, false, two), 2);
    EXPECT_NEAR(two[1], 0.5, 1e-15);
    EXPECT_EQ(sign_changes<2>({1, -0.5, 0}, true, false, two), 1);
    EXPECT_NEAR(two[0], 0.5, 1e-15);
    // Rounding has put the second root, which the signs prove, behind the end; but not a second one far away.
    ASSERT_EQ(sign_changes<2>({1, -1.9 - 1e-9, 0.9 + 0.9e-9}, false, false, two), 2);
    EXPECT_NEAR(two[0], 0.9, 1e-15);
    EXPECT_EQ(two[1], 1.0);
    EXPECT_EQ(sign_changes<2>({1, -2.5 + 1e-9, 1.5 - 1.5e-9}, false, false, two), 0);
    // Newton's first step starts from an inflection: v(w) = 0.2 of a Catmull-Rom piece, met at its end.
    ASSERT_EQ(sign_changes<3>({-0.4, 0.6, 0.2, -0.4}, true, false, got), 1);
    EXPECT_NEAR(got[0], 1.0, 1e-12);
    std::array<double, 6> six{};
    // x^6 - 2^-6
    EXPECT_EQ(sign_changes<6>({1, 0, 0, 0, 0, 0, -0.015625}, true, false, six), 1);
    EXPECT_NEAR(six[0], 0.5, 1e-15);
}

TEST(Roots, PolynomialsOfAnyDegreeFindAllTheirRoots) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> place(-1, 1);
    for (const size_t degree : {1u, 2u, 5u, 9u}) {
        for (int trial = 0; trial < 200; ++trial) {
            // Half of the factors have real roots, the others are quadratic without any.
            std::vector<double> wanted;
            std::vector<double> c{1.0};
            while (c.size() <= degree) {
                const bool real = c.size() == degree || trial % 2 == 0;
                const double a = place(random);
                const std::vector<double> factor =
                    real ? std::vector<double>{1, -a} : std::vector<double>{1, -2 * a, a * a + 0.1};
                if (real) wanted.push_back(a);
                std::vector<double> product(c.size() + factor.size() - 1, 0.0);
                for (size_t i = 0; i < c.size(); ++i) {
                    for (size_t k = 0; k < factor.size(); ++k) product[i + k] += c[i] * factor[k];
                }
                c = product;
            }
            std::sort(wanted.begin(), wanted.end());
            bool apart = true;
            for (size_t i = 1; i < wanted.size(); ++i) apart = apart && wanted[i] - wanted[i - 1] > 0.02;
            if (!apart) continue;
            std::vector<double> roots(degree);
            const int n = solve_polynomial(c, -1, 1, roots);
            ASSERT_EQ(static_cast<size_t>(n), wanted.size());
            for (size_t i = 0; i < wanted.size(); ++i) EXPECT_NEAR(roots[i], wanted[i], 1e-5);
        }
    }
}

/// Coefficients, highest first, of the polynomial with these roots.
std::vector<double> with_roots(const std::vector<double>& roots) {
    std::vector<double> c{1.0};
    for (const double r : roots) {
        c.push_back(0.0);
        for (size_t i = c.size() - 1; i > 0; --i) c[i] -= r * c[i - 1];
    }
    return c;
}

TEST(Roots, ChebyshevPolynomialsKeepAllRoots) {
    for (const size_t degree : {8u, 16u, 24u, 32u}) {
        std::vector<double> before{1.0};
        std::vector<double> c{1.0, 0.0};
        for (size_t n = 1; n < degree; ++n) {
            std::vector<double> next(n + 2, 0.0);
            for (size_t i = 0; i < c.size(); ++i) next[i] += 2.0 * c[i];
            for (size_t i = 0; i < before.size(); ++i) next[i + 2] -= before[i];
            before = c;
            c = next;
        }
        std::vector<double> roots(degree);
        ASSERT_EQ(solve_polynomial(c, -1, 1, roots), static_cast<int>(degree));
        for (size_t k = 0; k < degree; ++k) {
            const double angle = 3.14159265358979323846 * (static_cast<double>(degree - k) - 0.5);
            EXPECT_NEAR(roots[k], std::cos(angle / static_cast<double>(degree)),
                        1e-15 * std::pow(2.5, degree));
        }
    }
}

TEST(Roots, WilkinsonsPolynomialsKeepAllRoots) {
    // Up to 1...16 the coefficients are whole numbers below 2^53, so that the roots are known.
    for (const size_t degree : {10u, 16u}) {
        std::vector<double> wanted(degree);
        for (size_t i = 0; i < degree; ++i) wanted[i] = static_cast<double>(i + 1);
        std::vector<double> roots(degree);
        ASSERT_EQ(solve_polynomial(with_roots(wanted), 0.5, 40, roots), static_cast<int>(degree));
        for (size_t i = 0; i < degree; ++i) EXPECT_NEAR(roots[i], wanted[i], 1e-6);
    }
}

TEST(Roots, AnyDegreeObeysSignsAtZeroAndHugeRatios) {
    std::vector<double> roots(10);
    // x^3 changes its sign at 0, x^2 does not; a double root is none.
    EXPECT_EQ(solve_polynomial(std::vector<double>{1, 0, 0, 0}, -1, 1, roots), 1);
    EXPECT_EQ(roots[0], 0.0);
    EXPECT_EQ(solve_polynomial(std::vector<double>{1, 0, 0}, -1, 1, roots), 0);
    EXPECT_EQ(solve_polynomial(std::vector<double>{1, -1, 0.25}, -1, 1, roots), 0);
    // x^10 - 1e250
    EXPECT_EQ(solve_polynomial(std::vector<double>{1, 0, 0, 0, 0, 0, 0, 0, 0, 0, -1e250}, -1e26, 1e26, roots),
              2);
    EXPECT_NEAR(roots[1], 1e25, 1e10);
    // (x - 1e-9)(x - 1)(x - 1e9)
    ASSERT_EQ(solve_polynomial(std::vector<double>{1, -1e9 - 1 - 1e-9, 1e9 + 1 + 1e-9, -1}, 0, 2e9, roots),
              3);
    EXPECT_NEAR(roots[0], 1e-9, 1e-23);
    EXPECT_NEAR(roots[1], 1.0, 1e-8);
}

/// Some of the roots lie beyond [0, 1].
template <size_t N>
void expect_quick_roots_as_slow_ones(std::mt19937_64& random) {
    std::uniform_real_distribution<double> place(-0.5, 1.5);
    int told = 0;
    constexpr int tries = 2000;
    for (int i = 0; i < tries; ++i) {
        std::array<double, N + 1> c{1.0};
        for (size_t k = 0; k < N; ++k) {
            const double root = place(random);
            for (size_t m = k + 1; m > 0; --m) c[m] -= root * c[m - 1];
        }
        std::array<double, N> quick;
        std::array<double, N> slow;
        const std::optional<size_t> n = QuickRoots<N>(c).search(quick);
        if (!n) continue;
        ++told;
        ASSERT_EQ(*n, static_cast<size_t>(solve_polynomial(c, 0.0, 1.0, slow)));
        for (size_t k = 0; k < *n; ++k) ASSERT_NEAR(quick[k], slow[k], 1e-6) << N;
    }
    EXPECT_GT(told, tries / 2) << N;
}

TEST(QuickRoots, AreThoseOfTheSlowTwinOrNone) {
    std::mt19937_64 random(11);
    expect_quick_roots_as_slow_ones<2>(random);
    expect_quick_roots_as_slow_ones<4>(random);
    expect_quick_roots_as_slow_ones<6>(random);
    expect_quick_roots_as_slow_ones<10>(random);
    // Of another interval, by way of the polynomial there.
    std::uniform_real_distribution<double> place(-0.5, 1.5);
    int told = 0;
    for (int i = 0; i < 4000; ++i) {
        std::vector<double> wanted{place(random), place(random), place(random)};
        const std::vector<double> c = with_roots(wanted);
        std::array<double, 3> quick;
        std::array<double, 3> slow;
        const int n = try_solve_polynomial(c, -0.3, 1.4, quick);
        if (n < 0) continue;
        ++told;
        ASSERT_EQ(n, solve_polynomial(c, -0.3, 1.4, slow));
        for (size_t k = 0; k < static_cast<size_t>(n); ++k) ASSERT_NEAR(quick[k], slow[k], 1e-9);
    }
    EXPECT_GT(told, 3000);
    std::array<double, 2> roots;
    EXPECT_LT(try_solve_polynomial(std::vector<double>{1, 0, -1}, -1e4, 2, roots), 0);
    // A double root is not told.
    EXPECT_FALSE(QuickRoots<2>({1, -1, 0.25}).search(roots).has_value());
}

}  // namespace
}  // namespace rb
