#include "compile/tessellated.h"

#include "shapes/mesh_refinement.h"

#include <algorithm>
#include <cmath>

namespace rb {

namespace {

MeshData mesh_data(TriangleMesh mesh) {
    MeshData data;
    data.triangles = std::move(mesh);
    return data;
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

/// Takes facets in their refined form to a filter.
class TessellatedShape::Refinement final : public CrossingFilter {
public:
    Refinement(const TessellatedShape& shape, const ShapeRay& ray, const CrossingFilter* filter)
        : shape_(shape), ray_(ray), filter_(filter) {}

    bool counts(const Crossing& facet) const override {
        const auto refined = shape_.refined(ray_, facet);
        if (!refined || (filter_ && !filter_->counts(*refined))) return false;
        last_ = *refined;
        return true;
    }
    /// The last one that counted: what the mesh takes in the end.
    const Crossing& last() const { return last_; }

private:
    const TessellatedShape& shape_;
    const ShapeRay& ray_;
    const CrossingFilter* filter_;
    mutable Crossing last_;
};

TessellatedShape::TessellatedShape(ShapePtr truth, const TriangleMesh& mesh, Hits hits)
    : truth_(std::move(truth)),
      mesh_(truth_->keyword(), mesh_data(mesh)),
      hits_(hits),
      error_(mesh.error + float_rounding(mesh_.bounds())) {}

Crossing TessellatedShape::nearest_crossing(const Vec3& p, const Crossing& facet) const {
    const Vec3 n = glm::normalize(mesh_.normal(p, facet));
    const double size = glm::length(mesh_.bounds().size());
    Crossing nearest{std::numeric_limits<double>::infinity(), 0, Vec2{0.0}};
    // From outside and near by first: of some shapes the language wants the first crossing only.
    constexpr double growth = 8.0;
    const double least = std::max(4.0 * error_, 1e-6 * size);
    for (double way = least; !std::isfinite(nearest.t); way *= growth) {
        way = std::min(way, size);
        Crossings all;
        truth_->crossings(ShapeRay{{p + way * n, -n}, 0.0, 2.0 * way}, all);
        for (size_t i = 0; i < all.size(); ++i) {
            if (std::abs(all[i].t - way) < std::abs(nearest.t - way)) nearest = all[i];
        }
        if (!(way < size)) break;
    }
    nearest.t = facet.t;
    return nearest;
}

std::optional<Crossing> TessellatedShape::refined(const ShapeRay& ray, const Crossing& facet) const {
    const Vec3& d = ray.ray.direction;
    const Vec3 n = mesh_.normal(ray.ray.at(facet.t), facet);
    const double facing = glm::dot(n, d);
    constexpr double flattest = 0.02;
    const double slant = std::max(std::abs(facing) / (glm::length(n) * glm::length(d)), flattest);
    const double reach = 2.0 * error_ / (slant * glm::length(d));
    ShapeRay near = ray;
    near.t_min = std::max(ray.t_min, facet.t - reach);
    near.t_max = std::min(ray.t_max, facet.t + reach);
    Crossings all;
    truth_->crossings(near, all);
    std::optional<Crossing> best;
    std::pair<bool, double> least;
    for (size_t i = 0; i < all.size(); ++i) {
        // Where a ray comes in, it does not go out; but some normals follow the order of points.
        const double way = glm::dot(truth_->normal(ray.ray.at(all[i].t), all[i]), d);
        const std::pair<bool, double> rank{(way < 0.0) != (facing < 0.0), std::abs(all[i].t - facet.t)};
        if (best && least <= rank) continue;
        best = all[i];
        least = rank;
    }
    const bool is_at_origin = near.t_min == ray.t_min && (ray.starts_on_surface || ray.origin_error > 0.0);
    if (!best && !is_at_origin) best = nearest_crossing(ray.ray.at(facet.t), facet);
    return best;
}

void TessellatedShape::crossings(const ShapeRay& ray, Crossings& out) const {
    if (hits_ == Hits::on_facets) return mesh_.crossings(ray, out);
    Crossings facets;
    mesh_.crossings(ShapeRay{ray.ray, ray.t_min, ray.t_max}, facets);
    for (size_t i = 0; i < facets.size(); ++i) {
        if (const auto crossing = refined(ray, facets[i])) out.add(*crossing);
    }
}

bool TessellatedShape::closest(const ShapeRay& ray, const CrossingFilter* filter, Crossing& nearest) const {
    if (hits_ == Hits::on_facets) return mesh_.closest(ray, filter, nearest);
    const Refinement refinement(*this, ray, filter);
    if (!mesh_.closest(ShapeRay{ray.ray, ray.t_min, ray.t_max}, &refinement, nearest)) return false;
    nearest = refinement.last();
    return true;
}

bool TessellatedShape::any(const ShapeRay& ray, const CrossingFilter* filter, Crossing& found) const {
    if (hits_ == Hits::on_facets) return mesh_.any(ray, filter, found);
    const Refinement refinement(*this, ray, filter);
    if (!mesh_.any(ShapeRay{ray.ray, ray.t_min, ray.t_max}, &refinement, found)) return false;
    found = refinement.last();
    return true;
}

void tessellate_leaves(FlatGeometry& flat, const Camera& camera, const CompileOptions& options) {
    const double pixel = pixel_size(camera, options);
    const auto hits = options.geometry == GeometryMode::refine ? TessellatedShape::Hits::refined
                                                               : TessellatedShape::Hits::on_facets;
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
        // Facets reach out of the surface's box.
        const Vec3 error{mesh->error / to_object + float_rounding(box)};
        flat.boxes[i] = {flat.boxes[i].lo - error, flat.boxes[i].hi + error};
        leaf.shape = std::make_shared<TessellatedShape>(leaf.shape, std::move(*mesh), hits);
    }
}

}  // namespace rb
