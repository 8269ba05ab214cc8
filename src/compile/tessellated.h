#pragma once
#include "compile/flatten.h"
#include "shapes/mesh_shape.h"

namespace rb {

/// A shape seen through its mesh: rays meet the facets; normals, uv and inside come from the true shape.
class TessellatedShape final : public Shape {
public:
    TessellatedShape(ShapePtr truth, TriangleMesh mesh);

    std::string_view keyword() const override { return truth_->keyword(); }
    Bounds bounds() const override { return mesh_.bounds(); }
    Bounds solid_bounds() const override { return truth_->solid_bounds(); }
    bool inside(const Vec3& p) const override { return truth_->inside(p); }
    bool is_patch() const override { return truth_->is_patch(); }
    bool is_faceted() const override { return true; }
    void crossings(const ShapeRay& ray, Crossings& out) const override { mesh_.crossings(ray, out); }
    bool closest(const ShapeRay& ray, const CrossingFilter* filter, Crossing& nearest) const override {
        return mesh_.closest(ray, filter, nearest);
    }
    bool any(const ShapeRay& ray, const CrossingFilter* filter, Crossing& found) const override {
        return mesh_.any(ray, filter, found);
    }
    Vec3 normal(const Vec3& p, const Crossing& at) const override {
        return truth_->normal(p, true_crossing(at));
    }
    std::optional<Vec2> uv(const Vec3& p, const Crossing& at) const override {
        return truth_->uv(p, true_crossing(at));
    }
    std::optional<TriangleMesh> tessellate(double tolerance) const override {
        return truth_->tessellate(tolerance);
    }
    std::string describe() const override {
        return truth_->describe() + ", tessellated: " + mesh_.describe();
    }

private:
    Crossing true_crossing(const Crossing& at) const { return {at.t, parts_[at.part], at.at}; }

    ShapePtr truth_;
    MeshShape mesh_;
    std::vector<uint32_t> parts_;  ///< of the true shape, by facet
};

/// Replaces the finite curved shapes by meshes within `options.tessellation_error_pixels` of the nearest
/// distance at which the camera may see them (algorithms 2.1).
void tessellate_leaves(FlatGeometry& flat, const Camera& camera, const CompileOptions& options);

}  // namespace rb
