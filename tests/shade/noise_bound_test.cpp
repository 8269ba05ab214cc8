#include "patterns/noise_bound.h"

#include "patterns/noise.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace rb {
namespace {

TEST(NoiseBound, HoldsValuesAndSlopes) {
    std::mt19937_64 random(11);
    std::uniform_real_distribution<double> unit(0, 1);
    const auto within = [&](const Bounds& b) {
        return b.lo + b.size() * Vec3{unit(random), unit(random), unit(random)};
    };
    size_t narrow = 0;
    for (int i = 0; i < 6000; ++i) {
        const int generator = 1 + i % 3;
        const double far = i % 5 ? 10.0 : 1000.0;
        const Vec3 lo = far * Vec3{unit(random) - 0.5, unit(random) - 0.5, unit(random) - 0.5};
        const Bounds box{lo, lo + 0.6 * Vec3{unit(random), unit(random), unit(random)}};
        const NoiseBound bound = bound_noise(box, generator);
        narrow += bound.value.hi - bound.value.lo < 0.5;
        for (int k = 0; k < 20; ++k) {
            const Vec3 p = within(box);
            const double value = noise(p, generator);
            ASSERT_GE(value, bound.value.lo);
            ASSERT_LE(value, bound.value.hi);
            Vec3 q = p;
            const int axis = k % 3;
            q[axis] = within(box)[axis];
            if (std::abs(q[axis] - p[axis]) < 1e-3) continue;
            const double slope = (noise(q, generator) - value) / (q[axis] - p[axis]);
            const Interval& held = bound.slopes[static_cast<size_t>(axis)];
            ASSERT_GE(slope, held.lo - 1e-5) << generator;
            ASSERT_LE(slope, held.hi + 1e-5) << generator;
        }
    }
    EXPECT_GT(narrow, 2000u);
}

TEST(NoiseBound, BecomesThePointsOwn) {
    for (int generator = 1; generator <= 3; ++generator) {
        const Vec3 p{1.3, -7.2, 0.45};
        constexpr double step = 1e-5;
        const NoiseBound bound = bound_noise({p - step, p + step}, generator);
        EXPECT_NEAR(bound.value.lo, bound.value.hi, 1e-4);
        for (int axis = 0; axis < 3; ++axis) {
            Vec3 next = p;
            next[axis] += step;
            Vec3 before = p;
            before[axis] -= step;
            const double slope = (noise(next, generator) - noise(before, generator)) / (2.0 * step);
            const Interval& held = bound.slopes[static_cast<size_t>(axis)];
            EXPECT_NEAR(0.5 * (held.lo + held.hi), slope, 1e-3);
            EXPECT_LT(held.hi - held.lo, 1e-2);
        }
    }
}

TEST(NoiseBound, OfManyCellsIsTheRange) {
    const NoiseBound bound = bound_noise({Vec3{0.0}, Vec3{0.5, 4.0, 0.5}}, 2);
    EXPECT_EQ(bound.value.lo, 0.0);
    EXPECT_EQ(bound.value.hi, 1.0);
    EXPECT_TRUE(bound.slopes[0].has_infinity());
}

}  // namespace
}  // namespace rb
