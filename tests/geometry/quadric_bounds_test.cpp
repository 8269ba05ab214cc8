// What a slab or a box leaves of infinite quadrics.
#include "base/diagnostics.h"
#include "compile/geometry_parts.h"
#include "compile/world.h"
#include "tests/geometry/shape_cases.h"
#include "tests/geometry/statement.h"

#include <cmath>
#include <random>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace rb {
namespace {

/// Open along an axis: from -inf to inf.
Bounds slab(int axis, double lo, double hi) {
    Bounds region = Bounds::everything();
    region.lo[axis] = lo;
    region.hi[axis] = hi;
    return region;
}

TEST(QuadricBounds, HyperboloidBetweenPlanes) {
    // x^2 + z^2 <= 1 + (y - 5)^2: a waist of radius 1.
    const ShapePtr waist = shape_from("quadric { <1,-1,1>, 0, <0,10,0>, -26 }");
    EXPECT_FALSE(waist->bounds().is_finite());
    const Bounds box = waist->solid_bounds_within(slab(1, 4.0, 7.0));
    const double radius = std::sqrt(5.0);
    for (const int axis : {0, 2}) {
        EXPECT_NEAR(box.hi[axis], radius, 1e-5);
        EXPECT_GE(box.hi[axis], radius);
        EXPECT_NEAR(box.lo[axis], -radius, 1e-5);
        EXPECT_LE(box.lo[axis], -radius);
    }
    EXPECT_EQ(box.lo.y, 4.0);
    EXPECT_EQ(box.hi.y, 7.0);
    EXPECT_FALSE(waist->solid_bounds_within(slab(0, -1.0, 1.0)).is_finite());
    // The complement's surface is the same, its solid has no end.
    const ShapePtr outside = shape_from("quadric { <-1,1,-1>, 0, <0,-10,0>, 26 }");
    EXPECT_TRUE(outside->bounds_within(slab(1, 4.0, 7.0)).is_finite());
    EXPECT_FALSE(outside->solid_bounds_within(slab(1, 4.0, 7.0)).is_finite());
}

TEST(QuadricBounds, HoldEveryPointInTheRegion) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    const auto number = [&](double scale) { return scale * unit(random); };
    int made_finite = 0;
    for (int trial = 0; trial < 20 * RB_TEST_SAMPLES; ++trial) {
        const double moved = std::pow(10.0, 3.0 * unit(random));
        const ShapePtr quadric = shape_from(
            fmt::format("quadric {{ <{},{},{}>, <{},{},{}>, <{},{},{}>, {} translate <{},{},{}> }}",
                        number(2), number(2), number(2), number(1), number(1), number(1), number(2),
                        number(2), number(2), number(3), number(moved), number(moved), number(moved)));
        Bounds region = Bounds::everything();
        const Vec3 middle{number(moved), number(moved), number(moved)};
        for (int axis = 0; axis < 3; ++axis) {
            if (unit(random) < -0.2) continue;
            region.lo[axis] = middle[axis] - std::abs(number(3));
            region.hi[axis] = middle[axis] + std::abs(number(3));
        }
        const Bounds solid = quadric->solid_bounds_within(region);
        const Bounds surface = quadric->bounds_within(region);
        made_finite += solid.is_finite() && !solid.is_empty() && !region.is_finite() ? 1 : 0;
        const auto place = [&] {
            Vec3 p;
            for (int axis = 0; axis < 3; ++axis) {
                const bool open = !std::isfinite(region.lo[axis]);
                const double far = open ? 30.0 * unit(random) * std::abs(unit(random)) + middle[axis] : 0.0;
                p[axis] =
                    open ? far
                         : region.lo[axis] + 0.5 * (1.0 + unit(random)) * (region.hi[axis] - region.lo[axis]);
            }
            return p;
        };
        for (int i = 0; i < 100; ++i) {
            Vec3 a = place();
            Vec3 b = place();
            ASSERT_TRUE(solid.contains(a) || !quadric->inside(a)) << quadric->describe();
            if (quadric->inside(a) == quadric->inside(b)) continue;
            for (int halving = 0; halving < 60; ++halving) {
                const Vec3 half = 0.5 * (a + b);
                (quadric->inside(half) == quadric->inside(a) ? a : b) = half;
            }
            ASSERT_TRUE(surface.contains(a) || surface.contains(b)) << quadric->describe();
        }
    }
    EXPECT_GT(4 * made_finite, RB_TEST_SAMPLES);
}

TEST(QuadricBounds, LeavesOfASolidWithPlanesAreFinite) {
    for (const char* text :
         {"intersection { plane { y, 2 } quadric { <1,-1,1>, 0, 0, -1 } plane { -y, 1 } }",
          "intersection { quadric { <1,0,1>, 0, <0,1,0>, -1 } plane { -y, 0 } }",
          "difference { intersection { plane { y, 2 } quadric { <1,0,1>, 0, 0, -4 } plane { -y, 1 } } "
          "quadric { <1,0,1>, 0, 0, -1 } }"}) {
        Diagnostics diagnostics;
        const World world = compile(scene_from(text), {}, diagnostics);
        for (const Bounds& box : world.geometry->parts->flat.boxes)
            EXPECT_TRUE(box.is_finite()) << text
                                         << fmt::format(" x {} {} y {} {} z {} {}", box.lo.x, box.hi.x,
                                                        box.lo.y, box.hi.y, box.lo.z, box.hi.z);
    }
}

}  // namespace
}  // namespace rb
