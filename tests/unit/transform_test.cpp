#include "math/transform.h"

#include <gtest/gtest.h>

namespace rb {
namespace {

void expect_near(const Vec3& a, const Vec3& b, double tolerance = 1e-6) {
    EXPECT_NEAR(a.x, b.x, tolerance);
    EXPECT_NEAR(a.y, b.y, tolerance);
    EXPECT_NEAR(a.z, b.z, tolerance);
}

// Measured: vrotate(<1,2,3>, <30,40,50>).
TEST(Transform, RotationMatchesTheLanguage) {
    expect_near(Transform::rotation_deg({30, 40, 50}).point({1, 2, 3}), {1.801281, 2.507690, 2.113499});
}

TEST(Transform, ComposesLeftToRight) {
    const Transform t = then(Transform::scaling(Vec3{2}), Transform::translation({1, 0, 0}));
    expect_near(t.point({1, 1, 1}), {3, 2, 2});
    expect_near(t.inverse_point({3, 2, 2}), {1, 1, 1});
}

TEST(Transform, InverseOfAGeneralMatrix) {
    const Affine m{{Vec3{1, 2, 3}, Vec3{4, 5, 6}, Vec3{7, 8, 10}, Vec3{11, 12, 13}}};
    const auto t = Transform::from_matrix(m);
    ASSERT_TRUE(t.has_value());
    expect_near(t->inverse_point(t->point({0.3, -0.7, 0.2})), {0.3, -0.7, 0.2}, 1e-12);
}

TEST(Transform, SingularMatrixIsRefused) {
    EXPECT_FALSE(
        Transform::from_matrix({{Vec3{1, 2, 3}, Vec3{2, 4, 6}, Vec3{0, 0, 1}, Vec3{0}}}).has_value());
}

TEST(Transform, NormalsStayPerpendicular) {
    const Transform t = then(Transform::scaling({1, 2, 3}), Transform::rotation_deg({10, 20, 30}));
    const Vec3 tangent{1, -1, 0};
    const Vec3 normal{1, 1, 5};
    EXPECT_NEAR(glm::dot(t.direction(tangent), t.normal(normal)), 0.0, 1e-12);
}

}  // namespace
}  // namespace rb
