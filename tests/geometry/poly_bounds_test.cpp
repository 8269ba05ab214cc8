#include "shapes/poly_bounds.h"

#include "shapes/poly_along.h"
#include "shapes/poly_shape.h"
#include "tests/geometry/shape_cases.h"

#include <array>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace rb {
namespace {

TEST(PolyBounds, HoldATorusWithRoom) {
    // Radii 0.8 and 0.3 about y.
    const ShapePtr torus = shape_from(
        "quartic { <1,0,0,0,2,0,0,2,0,-1.46, 0,0,0,0,0,0,0,0,0,0, 1,0,0,2,0,1.1,0,0,0,0, "
        "1,0,-1.46,0,0.3025> }");
    const Bounds box = torus->bounds();
    for (int i = 0; i < 3; ++i) {
        // Sums of the monomials' ranges over an eighth of the box are not tight.
        const double r = i == 1 ? 0.3 : 1.1;
        constexpr double room = 0.6;
        EXPECT_GE(box.hi[i], r);
        EXPECT_LE(box.hi[i], r + room);
        EXPECT_LE(box.lo[i], -r);
        EXPECT_GE(box.lo[i], -r - room);
    }
    EXPECT_FALSE(torus->language_extent().is_finite());
}

TEST(PolyBounds, AreInfiniteForWhatHasNoEnd) {
    for (const char* statement :
         {"poly { 2, <1,0,0,0,1,0,0,-1,0,-1> }", "poly { 2, <1,0,0,0,1,0,0,0,0,-1> }",
          "poly { 2, <-1,0,0,0,-1,0,0,-1,0,1> }", "poly { 3, <1,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,-1> }"}) {
        EXPECT_FALSE(shape_from(statement)->bounds().is_finite()) << statement;
    }
}

TEST(PolyAlong, IsThePolynomialAtEachPlaceOfTheRay) {
    std::mt19937_64 random(9);
    std::uniform_real_distribution<double> number(-1, 1);
    std::array<double, 35> c;
    for (double& v : c) v = number(random);
    const Vec3 o{0.3, -0.7, 0.4};
    const Vec3 d{0.5, 0.2, -0.9};
    const std::array<double, 5> along = PolyAlong(c.data(), o, d).find<4>();
    for (const double t : {-1.3, 0.0, 0.6, 2.0}) {
        const Vec3 p = o + t * d;
        double wanted = 0.0;
        for (int i = 4; i >= 0; --i) {
            for (int j = 4 - i; j >= 0; --j) {
                for (int k = 4 - i - j; k >= 0; --k)
                    wanted +=
                        c[poly_index(4, i, j, k)] * std::pow(p.x, i) * std::pow(p.y, j) * std::pow(p.z, k);
            }
        }
        double value = 0.0;
        for (size_t i = 5; i-- > 0;) value = value * t + along[i];
        EXPECT_NEAR(value, wanted, 1e-13);
    }
}

TEST(PolyBounds, HoldAllThatIsInside) {
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> number(-1, 1);
    int inside = 0;
    for (int i = 0; i < 200; ++i) {
        std::string statement = "quartic { <";
        // Fourth powers win in the end.
        for (int k = 0; k < 35; ++k) {
            const bool highest = k == 0 || k == 20 || k == 30;
            statement +=
                std::to_string(highest ? 3 + number(random) : 0.7 * number(random)) + (k < 34 ? "," : "> }");
        }
        const ShapePtr shape = shape_from(statement);
        const Bounds box = shape->bounds();
        if (!box.is_finite()) continue;
        for (int k = 0; k < 500; ++k) {
            const Vec3 p = 3.0 * Vec3{number(random), number(random), number(random)};
            if (!shape->inside(p)) continue;
            ++inside;
            ASSERT_TRUE(box.contains(p)) << statement;
        }
    }
    EXPECT_GT(inside, 100);
}

}  // namespace
}  // namespace rb
