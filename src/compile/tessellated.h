#pragma once
#include "compile/flatten.h"
#include "shapes/mesh_shape.h"

namespace rb {

/// A shape seen through its mesh: rays meet the facets; normals, uv, textures and inside come from the true
/// shape. Where hits are refined, a ray that meets a facet asks the true shape for its crossing near by, and
/// keeps the facet's only where there is none (silhouettes): crossings are then the true shape's.
class TessellatedShape final : public Shape {
public:
    enum class Hits { on_facets, refined };

    TessellatedShape(ShapePtr truth, const TriangleMesh& mesh, Hits hits);

    std::string_view keyword() const override { return truth_->keyword(); }
    Bounds bounds() const override { return truth_->bounds(); }
    Bounds solid_bounds() const override { return truth_->solid_bounds(); }
    bool inside(const Vec3& p) const override { return truth_->inside(p); }
    bool is_patch() const override { return truth_->is_patch(); }
    bool is_faceted() const override { return true; }
    void crossings(const ShapeRay& ray, Crossings& out) const override;
    bool closest(const ShapeRay& ray, const CrossingFilter* filter, Crossing& nearest) const override;
    bool any(const ShapeRay& ray, const CrossingFilter* filter, Crossing& found) const override;
    Vec3 normal(const Vec3& p, const Crossing& at) const override {
        return truth_->normal(p, true_crossing(p, at));
    }
    std::optional<Vec2> uv(const Vec3& p, const Crossing& at) const override {
        return truth_->uv(p, true_crossing(p, at));
    }
    std::span<const TexturePtr> textures() const override { return truth_->textures(); }
    void textures_at(const Vec3& p, const Crossing& at, std::vector<TextureWeight>& out) const override {
        truth_->textures_at(p, true_crossing(p, at), out);
    }
    void prepare() const override { mesh_.prepare(); }
    std::optional<TriangleMesh> tessellate(double tolerance) const override {
        return truth_->tessellate(tolerance);
    }
    std::string describe() const override {
        return truth_->describe() + ", tessellated: " + mesh_.describe();
    }

private:
    class Refinement;
    /// What the true shape says of a crossing of this one.
    Crossing true_crossing(const Vec3& p, const Crossing& at) const {
        return hits_ == Hits::refined ? at : nearest_crossing(p, at);
    }
    /// The true crossing on the line through a point of a facet along the facet's normal.
    Crossing nearest_crossing(const Vec3& p, const Crossing& facet) const;
    /// The true crossing near one with a facet; empty where that is about the ray's own origin.
    std::optional<Crossing> refined(const ShapeRay& ray, const Crossing& facet) const;

    ShapePtr truth_;
    MeshShape mesh_;
    Hits hits_;
    double error_;  ///< of the mesh
};

/// Replaces the finite curved shapes by meshes within `options.tessellation_error_pixels` of the nearest
/// distance at which the camera may see them (algorithms 2.1).
void tessellate_leaves(FlatGeometry& flat, const Camera& camera, const CompileOptions& options);

}  // namespace rb
