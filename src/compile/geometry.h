#pragma once
#include "compile/candidates.h"
#include "compile/world.h"

namespace rb {

/// The surfaces of a world with everything that answers rays. Immutable while rendering; all functions are
/// safe to call from many threads.
class Geometry {
public:
    Geometry();
    ~Geometry();

    const std::vector<Leaf>& leaves() const;
    const Leaf& leaf(uint32_t index) const { return leaves()[index]; }

    /// What rays of the bundle with any of the mask's bits may meet; false if that is too much to be listed.
    /// `left`: a leaf that all of them leave for good, or no_leaf.
    bool candidates(const RayBundle& bundle, RayMask mask, uint32_t left, Candidates& out) const;

    /// What of `wider` the rays of a narrower bundle may meet.
    void candidates(const Candidates& wider, const RayBundle& bundle, uint32_t left, Candidates& out) const;

    /// True if a ray that starts on the leaf cannot meet it again. `outward`: it goes to the leaf's outer
    /// side, and not along the surface.
    bool leaves_for_good(uint32_t leaf, bool outward) const;

    /// True if the leaf is opaque, the whole boundary of a convex body, and `p` is outside of it.
    bool is_convex_body(uint32_t leaf, const Vec3& p) const;

    /// The nearest crossing that counts (CSG, clips, mask), beyond the origin and before t_max. `candidates`,
    /// here and below: of a bundle that holds the ray, or null.
    bool closest(const RayQuery& query, Hit& hit, const Candidates* candidates = nullptr) const;

    /// True if anything with one of the query's mask bits lies before t_max; no order, first found wins.
    /// `blocker` (in: a leaf to try first, or no_leaf; out: the leaf that blocked) makes the next query of a
    /// similar ray cheap.
    bool occluded(const RayQuery& query, uint32_t& blocker, const Candidates* candidates = nullptr) const;

    /// True if any leaf carries one of these bits: a query that asks only for absent bits can be skipped.
    bool has(RayMask mask) const;

    /// Indices into World::interiors of the solids that contain `p`, in top-level order.
    std::vector<uint32_t> interiors_at(const Vec3& p) const;
    /// The same, where `tops` are solids_near() of a box around `p`.
    std::vector<uint32_t> interiors_at(const Vec3& p, std::span<const uint32_t> tops) const;
    /// The top-level solids that may contain points of a box, in order.
    std::vector<uint32_t> solids_near(const Bounds& box) const;

    /// Surface coordinates for uv_mapping at a hit.
    Vec2 uv(const Hit& hit) const;

    /// The surface that a hit on a leaf (and a member of it, if it is an instance) wears, own textures of
    /// meshes aside.
    uint32_t surface_of(uint32_t leaf, uint32_t member) const;

    /// The surfaces that a hit wears: one, or several on a mesh or blob with textures of its own.
    void surfaces_at(const Hit& hit, std::vector<SurfaceWeight>& out) const;

    struct Parts;
    std::unique_ptr<Parts> parts;
};

}  // namespace rb
