#include "math/shuffle.h"
#include "render/camera_rays.h"

#include <array>
#include <cmath>
#include <memory>
#include <vector>

#include <gtest/gtest.h>

namespace rb {
namespace {

void expect_near(const Vec3& a, const Vec3& b) {
    EXPECT_NEAR(a.x, b.x, 1e-12);
    EXPECT_NEAR(a.y, b.y, 1e-12);
    EXPECT_NEAR(a.z, b.z, 1e-12);
}

Ray ray_at(const CameraRays& rays, double x, double y) {
    Ray ray;
    EXPECT_TRUE(rays.at(x, y, 0, ray));
    return ray;
}

TEST(CameraRays, PerspectiveCorners) {
    Camera camera;
    const CameraRays rays(camera, {}, 4, 2);
    // Left edge of pixel 0 and top edge of row 0.
    expect_near(ray_at(rays, -0.5, -0.5).direction, glm::normalize(Vec3{-0.665, 0.5, 1}));
    expect_near(ray_at(rays, 3.5, 1.5).direction, glm::normalize(Vec3{0.665, -0.5, 1}));
    expect_near(ray_at(rays, 1.5, 0.5).direction, {0, 0, 1});
}

TEST(CameraRays, ManyAtOnceAreTheSameBitForBit) {
    Camera camera;
    camera.location = {1, 2, 3};
    std::vector<Vec2> positions;
    for (int i = 0; i < 77; ++i) positions.emplace_back(0.37 * i, 5.0 - 0.11 * i);
    for (const CameraKind kind : {CameraKind::perspective, CameraKind::fisheye}) {
        camera.kind = kind;
        const CameraRays rays(camera, {}, 30, 20);
        std::vector<CameraRay> many(positions.size());
        rays.at(positions, many);
        for (size_t i = 0; i < positions.size(); ++i) {
            Ray one;
            ASSERT_EQ(rays.at(positions[i].x, positions[i].y, 0, one), many[i].exists);
            if (!many[i].exists) continue;
            EXPECT_EQ(one.origin, many[i].ray.origin);
            EXPECT_EQ(one.direction, many[i].ray.direction);
        }
    }
}

TEST(CameraRays, OrthographicMovesTheOrigin) {
    Camera camera;
    camera.kind = CameraKind::orthographic;
    camera.location = {0, 0, -5};
    camera.right = {2, 0, 0};
    camera.up = {0, 2, 0};
    const CameraRays rays(camera, {}, 4, 4);
    expect_near(ray_at(rays, 0, 0).origin, {-0.75, 0.75, -5});
    expect_near(ray_at(rays, 0, 0).direction, {0, 0, 1});
}

TEST(CameraRays, FisheyeHasACircle) {
    Camera camera;
    camera.kind = CameraKind::fisheye;
    camera.right = {1, 0, 0};
    camera.angle_deg = 180;
    const CameraRays rays(camera, {}, 100, 100);
    Ray none;
    EXPECT_FALSE(rays.at(0, 0, 0, none));
    expect_near(ray_at(rays, 49.5, 49.5).direction, {0, 0, 1});
    EXPECT_NEAR(ray_at(rays, 99.5 - 1e-9, 49.5).direction.z, 0.0, 1e-6);
}

TEST(CameraRays, SphericalTurnsLeftHanded) {
    Camera camera;
    camera.kind = CameraKind::spherical;
    camera.right = {1, 0, 0};
    camera.angle_deg = 360;
    camera.vertical_angle_deg = 180;
    const CameraRays rays(camera, {}, 4, 2);
    // A quarter of the picture to the right of the centre looks along +x; the upper edge looks up.
    expect_near(ray_at(rays, 2.5, 0.5).direction, {1, 0, 0});
    expect_near(ray_at(rays, 1.5, -0.5).direction, {0, 1, 0});
}

/// The pattern sees x of the place where the camera's normal is evaluated.
class PushAlongX final : public Pattern {
public:
    std::string_view keyword() const override { return "push"; }
    void evaluate(const PatternContext&, std::span<const Vec3>, std::span<double>) const override {}
    bool perturb(const PatternContext&, float amount, std::span<const Vec3> points,
                 std::span<Vec3> normals) const override {
        for (size_t i = 0; i < points.size(); ++i) normals[i].y += static_cast<double>(amount) * points[i].x;
        return true;
    }
};

TEST(CameraRays, TheNormalTurnsDirections) {
    auto normal = std::make_shared<Normal>();
    normal->pattern = std::make_shared<PushAlongX>();
    normal->amount = 1;
    Camera camera;
    camera.normal = normal;
    const CameraRays flat(camera, {}, 4, 2);
    expect_near(ray_at(flat, 1.5, 0.5).direction, {0, 0, 1});
    const Vec3 straight = glm::normalize(Vec3{0.665, 0, 1});
    expect_near(ray_at(flat, 3.5, 0.5).direction, glm::normalize(straight + Vec3{0, 0.5, 0}));

    // The place of a fisheye is the angle about its axis: below the axis on the left it goes on growing.
    camera.kind = CameraKind::fisheye;
    camera.right = {1, 0, 0};
    camera.angle_deg = 180;
    const CameraRays round(camera, {}, 100, 100);
    const Vec3 left_below = ray_at(round, 24.5, 74.5).direction;
    camera.normal = nullptr;
    const Vec3 before = ray_at(CameraRays(camera, {}, 100, 100), 24.5, 74.5).direction;
    expect_near(left_below, glm::normalize(before + Vec3{0, 1.25 * pi, 0}));
}

// First entries as measured (geometry spec 19.1).
TEST(Jitter, HashTable) {
    const std::array expected{2291u, 2574u, 3654u, 1557u, 1196u, 3388u, 2637u, 1820u};
    for (uint32_t i = 0; i < expected.size(); ++i) EXPECT_EQ(shuffled_hash[i], expected[i]);
    EXPECT_EQ(shuffled_hash[4095], 3088u);
}

}  // namespace
}  // namespace rb
