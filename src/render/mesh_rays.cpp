#include "render/mesh_rays.h"

#include <algorithm>
#include <cmath>

namespace rb {

namespace {

constexpr double tiny = 1e-10;
constexpr Vec3 middle{1.0 / 3.0};

Vec3 unit(const Vec3& v) {
    const double length = glm::length(v);
    return length > 0.0 ? v / length : Vec3{1.0, 0.0, 0.0};
}

}  // namespace

MeshRays::MeshRays(const Camera& camera, int width, int height)
    : camera_(camera.mesh),
      offset_(camera.location.z),
      turned_(camera.direction.z < -tiny),
      width_(width),
      height_(height) {
    if (camera_->distribution == RayDistribution::by_uv)
        uv_grid_.emplace(*camera_->meshes.front().uvs, *camera_->meshes.front().face_uvs);
}

std::optional<Ray> MeshRays::at(double x, double y, int index) const {
    // The reference reaches pixel rows half a pixel late: the first row is seen twice.
    const double px = std::clamp(x + 0.5, 0.0, width_ - 1.0);
    const double py = std::clamp(y - 0.5, 0.0, height_ - 1.0);
    if (camera_->distribution == RayDistribution::by_uv) return by_uv(px, py);
    const auto face = face_of(px, py, index);
    if (!face) return std::nullopt;
    return leaving(*face, middle);
}

std::optional<MeshRays::Face> MeshRays::face_of(double x, double y, int index) const {
    const auto& meshes = camera_->meshes;
    const auto count = [](const CameraMesh& mesh) { return mesh.triangles->faces.size(); };
    size_t first = 0;
    size_t columns = static_cast<size_t>(width_);
    const auto column = static_cast<size_t>(x);
    const auto row = static_cast<size_t>(y);
    if (camera_->distribution == RayDistribution::mesh_per_ray) {
        first = static_cast<size_t>(index);
    } else if (camera_->distribution == RayDistribution::side_by_side) {
        columns = columns / meshes.size();
        if (columns == 0) return std::nullopt;
        // Measured: the column counts from the picture's left edge for each mesh.
        first = static_cast<size_t>(x * static_cast<double>(meshes.size()) / width_);
    }
    size_t face = row * columns + column;
    if (camera_->distribution == RayDistribution::one_after_other) {
        size_t total = 0;
        for (const CameraMesh& mesh : meshes) total += count(mesh);
        face += static_cast<size_t>(index) * total;
        while (first < meshes.size() && face >= count(meshes[first])) face -= count(meshes[first++]);
        if (first == meshes.size()) return std::nullopt;
    }
    if (face >= count(meshes[first])) return std::nullopt;
    return Face{&meshes[first], static_cast<uint32_t>(face)};
}

std::optional<Ray> MeshRays::by_uv(double x, double y) const {
    const Vec2 wanted{(x - 0.5) / width_, 1.0 - (y + 0.5) / height_};
    const CameraMesh& mesh = camera_->meshes.front();
    const auto place = uv_grid_->find(wanted);
    if (!place) return std::nullopt;
    return leaving({&mesh, place->triangle}, {1.0 - place->b - place->c, place->b, place->c});
}

Ray MeshRays::leaving(const Face& face, const Vec3& weights) const {
    const TriangleMesh& mesh = *face.mesh->triangles;
    const auto corner = [&](size_t i) { return Vec3(mesh.vertices[mesh.faces[face.index][i]]); };
    const Vec3 point = weights.x * corner(0) + weights.y * corner(1) + weights.z * corner(2);
    Vec3 normal = unit(glm::cross(corner(2) - corner(0), corner(1) - corner(0)));
    if (camera_->smooth && !mesh.face_normals.empty()) {
        const auto& normals = mesh.face_normals[face.index];
        const auto at = [&](size_t i) { return Vec3(mesh.normals[normals[i]]); };
        // Measured: the offset grows with the interpolated normal as it is, not made unit length.
        if (normals[0] < mesh.normals.size()) {
            normal = weights.x * at(0) + weights.y * at(1) + weights.z * at(2);
        }
    }
    const Transform& place = face.mesh->world_from_mesh;
    return {place.point(point + offset_ * normal), unit(place.normal(turned_ ? -normal : normal))};
}

}  // namespace rb
