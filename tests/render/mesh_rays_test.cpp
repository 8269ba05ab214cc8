#include "render/mesh_rays.h"

#include <gtest/gtest.h>

namespace rb {
namespace {

/// A row of `count` unit squares' lower halves in z = 0, facing -z; face i between x = i and x = i + 1.
CameraMesh row_of(uint32_t count, const Transform& place = {}) {
    auto mesh = std::make_shared<TriangleMesh>();
    auto uvs = std::make_shared<std::vector<Vec2>>();
    for (uint32_t i = 0; i < count; ++i) {
        const auto x = static_cast<float>(i);
        mesh->vertices.insert(mesh->vertices.end(), {{x, 0, 0}, {x + 1, 0, 0}, {x, 1, 0}});
        mesh->faces.push_back({3 * i, 3 * i + 1, 3 * i + 2});
        const double u = static_cast<double>(i) / count;
        uvs->insert(uvs->end(), {{u, 0}, {u + 1.0 / count, 0}, {u, 1}});
    }
    auto face_uvs = std::make_shared<std::vector<std::array<uint32_t, 3>>>(mesh->faces);
    return {mesh, uvs, face_uvs, place};
}

Camera camera_of(RayDistribution distribution, std::vector<CameraMesh> meshes) {
    auto mesh = std::make_shared<MeshCamera>();
    mesh->distribution = distribution;
    mesh->meshes = std::move(meshes);
    Camera camera;
    camera.kind = CameraKind::mesh_camera;
    camera.mesh = std::move(mesh);
    return camera;
}

constexpr double third = 1.0 / 3.0;

void expect_equal(const Vec3& a, const Vec3& b) {
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(a[i], b[i], 1e-12);
}

TEST(MeshRays, LeaveTheMiddleOfAFaceAlongItsNormal) {
    const MeshRays rays(camera_of(RayDistribution::mesh_per_ray, {row_of(8)}), 4, 4);
    const auto ray = rays.at(2, 1, 0);
    ASSERT_TRUE(ray);
    expect_equal(ray->origin, {2 + third, third, 0});
    expect_equal(ray->direction, {0, 0, -1});
    // The first two rows of pixels look the same way.
    expect_equal(rays.at(2, 0, 0)->origin, ray->origin);
    expect_equal(rays.at(2, 2, 0)->origin, {6 + third, third, 0});
    EXPECT_FALSE(rays.at(2, 3, 0));
}

TEST(MeshRays, LocationAndDirectionTurnThemRound) {
    Camera camera = camera_of(RayDistribution::mesh_per_ray, {row_of(8, Transform::scaling({2, 2, 2}))});
    camera.location = {5, 6, 0.25};
    camera.direction = {0, 0, -1};
    const auto ray = MeshRays(camera, 4, 4).at(0, 1, 0);
    expect_equal(ray->origin, {2 * third, 2 * third, -0.5});
    expect_equal(ray->direction, {0, 0, 1});
}

TEST(MeshRays, MeshPerRayAndOneAfterOther) {
    const Transform up = Transform::translation({0, 10, 0});
    const MeshRays per_ray(camera_of(RayDistribution::mesh_per_ray, {row_of(4), row_of(4, up)}), 4, 4);
    expect_equal(per_ray.at(1, 1, 0)->origin, {1 + third, third, 0});
    expect_equal(per_ray.at(1, 1, 1)->origin, {1 + third, 10 + third, 0});
    const MeshRays row(camera_of(RayDistribution::one_after_other, {row_of(4), row_of(4, up)}), 4, 4);
    expect_equal(row.at(1, 2, 0)->origin, {1 + third, 10 + third, 0});
    EXPECT_FALSE(row.at(1, 3, 0));
    EXPECT_FALSE(row.at(1, 1, 1));
}

TEST(MeshRays, SideBySideShareTheWidth) {
    const Transform up = Transform::translation({0, 10, 0});
    const MeshRays rays(camera_of(RayDistribution::side_by_side, {row_of(12), row_of(12, up)}), 4, 4);
    expect_equal(rays.at(1, 2, 0)->origin, {3 + third, third, 0});
    expect_equal(rays.at(3, 2, 0)->origin, {5 + third, 10 + third, 0});
}

TEST(MeshRays, ByUvFindTheTriangle) {
    const MeshRays rays(camera_of(RayDistribution::by_uv, {row_of(2)}), 8, 8);
    // u = 5/8 and v = 1 - (5.5 + .5)/8 lie in the second triangle, a quarter along and a quarter up.
    expect_equal(rays.at(5, 6, 0)->origin, {1.25, 0.25, 0});
    EXPECT_FALSE(rays.at(7, 1, 0));
}

/// Interpolated normals lean over; flat ones do not.
TEST(MeshRays, SmoothOnesFanOut) {
    CameraMesh mesh = row_of(1);
    auto bent = std::make_shared<TriangleMesh>(*mesh.triangles);
    bent->normals = {{-0.6f, 0, -0.8f}, {0.6f, 0, -0.8f}, {0, 0, -1}};
    bent->face_normals = {{0, 1, 2}};
    mesh.triangles = bent;
    auto smooth = std::make_shared<MeshCamera>();
    smooth->distribution = RayDistribution::by_uv;
    smooth->meshes = {mesh};
    smooth->smooth = true;
    Camera camera;
    camera.kind = CameraKind::mesh_camera;
    camera.mesh = smooth;
    const MeshRays rays(camera, 8, 8);
    EXPECT_LT(rays.at(0, 7.5, 0)->direction.x, -0.5);
    EXPECT_GT(rays.at(6, 7.5, 0)->direction.x, 0.2);
    EXPECT_NEAR(glm::length(rays.at(2, 5, 0)->direction), 1.0, 1e-12);
}

}  // namespace
}  // namespace rb
