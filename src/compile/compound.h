#pragma once
#include "compile/geometry_parts.h"

namespace rb {

/// A compound that stands in the world many times: flattened once, in its own space, with its own box tree.
/// To the world's geometry it is one shape; Crossing::member says which of its surfaces was met. What those
/// wear differs from copy to copy: see Instance.
class Compound final : public Shape {
public:
    Compound(std::shared_ptr<const Geometry> geometry, CompoundLooks looks);

    /// Stand for what a copy gives to surfaces without texture: one that light passes, one that it does not.
    static const TexturePtr& texture_of_copy(bool opaque);
    static bool is_texture_of_copy(const TexturePtr& texture);

    const CompoundLooks& looks() const { return looks_; }
    RayMask mask() const { return geometry_->parts->all_masks; }
    /// How many surfaces Crossing::member tells apart.
    uint32_t member_count() const { return member_count_; }

    /// As Shape::closest() and any(), among surfaces with one of the mask's bits. `member`: where the ray
    /// starts, if it starts on this very copy.
    bool closest_of(const ShapeRay& ray, RayMask mask, uint32_t member, Crossing& nearest) const;
    bool any_of(const ShapeRay& ray, RayMask mask, uint32_t member, Crossing& found) const;

    /// Of a hit on a member.
    ElementError error_of(uint32_t member) const;
    uint32_t surface_of(uint32_t member) const;
    void surfaces_at(const Vec3& p, const Crossing& at, std::vector<SurfaceWeight>& out) const;
    std::vector<uint32_t> interiors_at(const Vec3& p) const { return geometry_->interiors_at(p); }

    std::string_view keyword() const override { return "union"; }
    Bounds bounds() const override { return box_; }
    Bounds solid_bounds() const override { return region_; }
    bool inside(const Vec3& p) const override;
    void crossings(const ShapeRay& ray, Crossings& out) const override;
    Vec3 normal(const Vec3& p, const Crossing& at) const override;
    std::optional<Vec2> uv(const Vec3& p, const Crossing& at) const override;
    std::optional<TriangleMesh> tessellate(double) const override { return std::nullopt; }
    std::string describe() const override;

private:
    /// A member's leaf, and which surface of that leaf it is.
    struct Place {
        uint32_t leaf = 0;
        uint32_t member = 0;
    };
    Place place_of(uint32_t member) const;
    /// The hit in terms of the geometry's own leaves.
    Hit lowered(const Vec3& p, const Crossing& at) const;
    void raise(uint32_t leaf, Crossing& crossing) const;
    RayQuery query_of(const ShapeRay& ray, RayMask mask, uint32_t member) const;

    std::shared_ptr<const Geometry> geometry_;
    CompoundLooks looks_;
    Bounds box_;
    Bounds region_;
    std::vector<uint32_t> first_member_;  ///< by leaf; empty if every leaf is one member
    uint32_t member_count_ = 0;
};

}  // namespace rb
