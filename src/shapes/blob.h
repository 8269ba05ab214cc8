#pragma once
#include "kdtree/box_tree.h"
#include "math/transform.h"
#include "scene/shape.h"

namespace rb {

/// A sphere (length 0) or a cylinder with round ends, in its own frame: from the origin to `length` along z,
/// with radius 1. At a distance r < 1 its field is strength (1 - r^2)^2, beyond it is 0.
struct BlobComponent {
    Transform object_from_local;
    double length = 0;
    double strength = 1;
    uint32_t texture = own_texture;  ///< index into BlobData::textures

    /// The point relative to the nearest point of the axis, in the frame.
    Vec3 from_axis(const Vec3& local) const;
    double field(const Vec3& p) const;
    Vec3 slope(const Vec3& p) const;  ///< minus the gradient of the field
    /// Box of the points at a distance up to `r`.
    Bounds box(double r) const;
    /// Bound on the field where dot(direction, p) is `height` or more.
    double most_beyond(const Vec3& direction, double height) const;
};

struct BlobData {
    double threshold = 1;
    std::vector<BlobComponent> components;
    std::vector<TexturePtr> textures;
};

/// Where the sum of the components' fields equals the threshold.
class Blob final : public Shape {
public:
    /// `with_tree`: many components are found by a tree; the slow way round gives the same bits.
    explicit Blob(BlobData data, bool with_tree = true);

    std::string_view keyword() const override { return "blob"; }
    Bounds bounds() const override { return box_; }
    Bounds language_extent() const override { return extent_; }
    Bounds solid_bounds() const override;
    Extent extent(const Vec3& direction) const override;
    bool has_tight_extent() const override { return data_.threshold > 0.0; }
    bool inside(const Vec3& p) const override;
    void crossings(const ShapeRay& ray, Crossings& out) const override;
    bool closest(const ShapeRay& ray, const CrossingFilter* filter, Crossing& nearest) const override;
    Vec3 normal(const Vec3& p, const Crossing& at) const override;
    ShapePtr transformed(const Transform& map) const override;
    std::span<const TexturePtr> textures() const override { return data_.textures; }
    void textures_at(const Vec3& p, const Crossing& at, std::vector<TextureWeight>& out) const override;
    std::optional<TriangleMesh> tessellate(double tolerance) const override;
    std::string describe() const override;

    double field(const Vec3& p) const;
    Vec3 slope(const Vec3& p) const;  ///< minus the gradient of the field

private:
    /// Call take(component) for those that the ray, or the point, may be within, in the order of the scene:
    /// their sums are the same bits as over all of them.
    template <class Take>
    void each_along(const Ray& ray, Take&& take) const;
    template <class Take>
    void each_at(const Vec3& p, Take&& take) const;
    template <class Walk, class Take>
    void each_found(Walk&& walk, Take&& take) const;
    double height_along(const Vec3& direction) const;
    bool starts_here(const ShapeRay& query, double& level) const;
    template <class Take>
    void each_crossing(const ShapeRay& query, Take&& take) const;

    BlobData data_;
    BoxTree tree_;  ///< over the components; empty where they are few
    Bounds box_;
    Bounds extent_;
};

}  // namespace rb
