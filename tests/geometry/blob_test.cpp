// Blobs of many components, found by a tree, against all components one after the other.
#include "shapes/blob.h"

#include "shape_cases.h"

#include <gtest/gtest.h>

namespace rb {
namespace {

BlobData crowd(Dice& dice, size_t count) {
    BlobData data;
    data.threshold = 0.5;
    for (size_t i = 0; i < count; ++i) {
        BlobComponent c;
        c.object_from_local =
            then(Transform::scaling(Vec3{dice.between(0.05, 0.3)}), Transform::translation(dice.point(1.0)));
        c.length = dice.coin() ? 0.0 : dice.between(0.1, 1.0);
        c.strength = dice.between(-0.5, 1.5);
        data.components.push_back(c);
    }
    return data;
}

TEST(Blob, TreeFindsTheSameBits) {
    Dice dice(5);
    for (const size_t count : {size_t{13}, size_t{60}, size_t{400}}) {
        const BlobData data = crowd(dice, count);
        const Blob quick(data);
        const Blob slow(data, false);
        EXPECT_EQ(quick.bounds().lo, slow.bounds().lo);
        size_t met = 0;
        for (int i = 0; i < 2000; ++i) {
            const Vec3 p = dice.point(1.2);
            const Vec3 d = i % 5 == 0 ? Vec3{0, 0, 1} : dice.direction();
            ASSERT_EQ(quick.field(p), slow.field(p));
            ASSERT_EQ(quick.slope(p), slow.slope(p));
            const ShapeRay ray{{i % 4 == 0 ? p : p - 3.0 * d, d}};
            Crossings a;
            Crossings b;
            quick.crossings(ray, a);
            slow.crossings(ray, b);
            ASSERT_EQ(a.size(), b.size());
            for (size_t k = 0; k < a.size(); ++k) ASSERT_EQ(a[k].t, b[k].t);
            met += a.size();
        }
        EXPECT_GT(met, 20u);
    }
}

TEST(Blob, ExtentHoldsTheSolid) {
    Dice dice(7);
    for (const size_t count : {size_t{1}, size_t{3}, size_t{40}}) {
        const Blob blob(crowd(dice, count));
        if (blob.bounds().is_empty()) continue;
        for (int i = 0; i < 50; ++i) {
            const Vec3 direction = dice.between(0.5, 2.0) * dice.direction();
            const Extent extent = blob.extent(direction);
            for (int k = 0; k < 400; ++k) {
                const Vec3 p = dice.point(1.3);
                if (!blob.inside(p)) continue;
                ASSERT_GE(glm::dot(p, direction), extent.lo);
                ASSERT_LE(glm::dot(p, direction), extent.hi);
            }
        }
    }
}

TEST(Blob, ExtentOfOneIsExact) {
    BlobData data;
    data.threshold = 0.36;
    data.components.push_back({});
    data.components.back().object_from_local = Transform::translation({1, 2, 3});
    const Extent extent = Blob(data).extent({0, 1, 0});
    const double radius = std::sqrt(1.0 - 0.6);
    EXPECT_NEAR(extent.lo, 2.0 - radius, 1e-6);
    EXPECT_NEAR(extent.hi, 2.0 + radius, 1e-6);
}

// What overlaps reaches no farther than its parts do together.
TEST(Blob, ExtentOfSeveralIsTight) {
    BlobData data;
    data.threshold = 0.36;
    data.components.resize(3);
    data.components[1].object_from_local = Transform::scaling({0.3, 1.0, 0.3});
    data.components[2].object_from_local = Transform::scaling({0.2, 0.2, 1.0});
    EXPECT_NEAR(Blob(data).extent({1, 0, 0}).hi, std::sqrt(1.0 - 0.6), 1e-6);
    EXPECT_LT(Blob(data).extent({1, 0, 0}).hi, 0.8 * Blob(data).bounds().hi.x);
}

}  // namespace
}  // namespace rb
