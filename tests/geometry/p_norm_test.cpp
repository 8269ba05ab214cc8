#include "math/p_norm.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace rb {
namespace {

TEST(PNorm, IsThatOfItsFormula) {
    for (const double p : {0.4, 1.0, 2.0, 2.86, 8.0, 200.0}) {
        const PNorm norm(p);
        EXPECT_DOUBLE_EQ(norm(0.3, 0.5), std::pow(std::pow(0.3, p) + std::pow(0.5, p), 1.0 / p)) << p;
        EXPECT_DOUBLE_EQ(norm(0.3, 0.5), norm.growth(0.5, 0.3).value) << p;
    }
    EXPECT_DOUBLE_EQ(PNorm(2)(3e200, 4e200), 5e200);
    EXPECT_EQ(PNorm(20000)(0.25, 0.5), 0.5);
    EXPECT_EQ(PNorm(0.7)(0.0, 0.0), 0.0);
    EXPECT_EQ(PNorm(0.7)(0.0, 0.5), 0.5);
}

TEST(PNorm, GrowsByItsDerivatives) {
    constexpr double step = 1e-6;
    for (const double p : {0.4, 1.0, 2.0, 2.86, 8.0}) {
        const PNorm norm(p);
        const PNorm::Growth at = norm.growth(0.4, 0.7);
        EXPECT_NEAR(at.by_a, (norm(0.4 + step, 0.7) - norm(0.4 - step, 0.7)) / (2 * step), 1e-8) << p;
        EXPECT_NEAR(at.by_b, (norm(0.4, 0.7 + step) - norm(0.4, 0.7 - step)) / (2 * step), 1e-8) << p;
    }
}

TEST(PNorm, BoundsHoldValuesAndQuotients) {
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> unit(0, 1);
    for (int i = 0; i < 20000; ++i) {
        const PNorm norm(std::exp(4 * unit(random) - 1.5));
        // Along a straight line through the quarter plane.
        const double zero = i % 7 ? 1.0 : 0.0;
        const double a0 = zero * unit(random);
        const double b0 = (i % 5 ? 1.0 : zero) * unit(random);
        const double a1 = unit(random);
        const double b1 = unit(random);
        const IntervalSlope a{Interval(std::min(a0, a1), std::max(a0, a1)), a1 - a0};
        const IntervalSlope b{Interval(std::min(b0, b1), std::max(b0, b1)), b1 - b0};
        const IntervalSlope bound = norm(a, b);
        const auto at = [&](double t) { return norm(a0 + t * (a1 - a0), b0 + t * (b1 - b0)); };
        const double t = unit(random);
        const double u = t + (1 - t) * unit(random);
        ASSERT_TRUE(bound.value.holds(at(t))) << norm.p();
        if (u - t < 1e-3) continue;
        const double quotient = (at(u) - at(t)) / (u - t);
        ASSERT_GE(quotient, bound.slope.lo - 1e-10)
            << norm.p() << ' ' << a0 << ' ' << a1 << ' ' << b0 << ' ' << b1;
        ASSERT_LE(quotient, bound.slope.hi + 1e-10)
            << norm.p() << ' ' << a0 << ' ' << a1 << ' ' << b0 << ' ' << b1;
    }
}

}  // namespace
}  // namespace rb
