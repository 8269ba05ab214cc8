#include "compile/tessellated.h"

#include <algorithm>
#include <cmath>

namespace rb {

namespace {

MeshData mesh_data(TriangleMesh mesh) {
    MeshData data;
    data.triangles = std::move(mesh);
    return data;
}

/// The part of the true surface nearest to a facet, looking both ways along the facet's normal.
uint32_t nearest_part(const Shape& truth, const Vec3& center, const Vec3& normal) {
    uint32_t part = 0;
    double best = std::numeric_limits<double>::infinity();
    for (const double sign : {1.0, -1.0}) {
        Crossings all;
        truth.crossings(ShapeRay{{center - 1e-9 * sign * normal, sign * normal}}, all);
        for (size_t i = 0; i < all.size(); ++i) {
            if (all[i].t < best) {
                best = all[i].t;
                part = all[i].part;
            }
        }
    }
    return part;
}

/// Size of a pixel at distance 1 (at any distance for an orthographic camera).
double pixel_size(const Camera& camera, const CompileOptions& options) {
    const double height = std::max(options.image_height, 1);
    const double width = std::max(options.image_width, 1);
    if (camera.kind == CameraKind::orthographic) {
        return std::min(glm::length(camera.up) / height, glm::length(camera.right) / width);
    }
    if (camera.kind != CameraKind::perspective) return pi / std::max(height, width);
    const double distance = std::max(glm::length(camera.direction), 1e-6);
    return std::min(glm::length(camera.up) / height, glm::length(camera.right) / width) / distance;
}

double nearest_distance(const Bounds& box, const Vec3& eye) {
    const Vec3 off = glm::max(glm::max(box.lo - eye, eye - box.hi), Vec3{0.0});
    // Inside or at the box: some part of its size, or the mesh would have no end.
    constexpr double least_share = 0.02;
    return std::max(glm::length(off), least_share * glm::length(box.size()));
}

}  // namespace

TessellatedShape::TessellatedShape(ShapePtr truth, TriangleMesh mesh)
    : truth_(std::move(truth)), mesh_(truth_->keyword(), mesh_data(mesh)) {
    for (const auto& f : mesh.faces) {
        const Vec3 a(mesh.vertices[f[0]]);
        const Vec3 b(mesh.vertices[f[1]]);
        const Vec3 c(mesh.vertices[f[2]]);
        const Vec3 n = glm::cross(c - a, b - a);
        const double length = glm::length(n);
        parts_.push_back(length > 0.0 ? nearest_part(*truth_, (a + b + c) / 3.0, n / length) : 0);
    }
}

void tessellate_leaves(FlatGeometry& flat, const Camera& camera, const CompileOptions& options) {
    const double pixel = pixel_size(camera, options);
    for (size_t i = 0; i < flat.leaves.size(); ++i) {
        Leaf& leaf = flat.leaves[i];
        if (leaf.shape->is_faceted() || flat.boxes[i].is_empty()) continue;
        Bounds box = leaf.shape->bounds();
        if (!box.is_finite()) continue;
        double to_object = 1.0;
        if (!leaf.in_world_space) {
            const auto world_from_object = inverse_of(leaf.object_from_world);
            if (!world_from_object) continue;
            to_object = 1.0 / stretch(*world_from_object);
            box = transformed(box, *world_from_object);
        }
        const bool parallel = camera.kind == CameraKind::orthographic;
        const double distance = parallel ? 1.0 : nearest_distance(box, camera.location);
        const double tolerance = options.tessellation_error_pixels * pixel * distance * to_object;
        auto mesh = leaf.shape->tessellate(tolerance);
        if (!mesh || mesh->faces.empty()) continue;
        leaf.shape = std::make_shared<TessellatedShape>(leaf.shape, std::move(*mesh));
    }
}

}  // namespace rb
