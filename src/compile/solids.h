#pragma once
#include "kdtree/box_tree.h"
#include "scene/object.h"

#include <cstdint>
#include <span>
#include <vector>

namespace rb {

constexpr uint32_t no_node = std::numeric_limits<uint32_t>::max();

/// A node of the forest of solids: a shape, or a compound of nodes. Complements have been pushed down to the
/// shapes (De Morgan), so a compound is "any of" (union, merge) or "all of" (intersection).
struct SolidNode {
    enum class Kind : uint8_t { shape, union_, merge, intersection };
    Kind kind = Kind::shape;
    bool inverted = false;    ///< shapes only
    bool tests_hits = false;  ///< this node or one above it refuses some hits
    bool difference = false;  ///< an intersection that was written as a difference
    uint32_t parent = no_node;
    uint32_t placed = 0;       ///< shapes only: index into SolidForest::shapes
    uint32_t lists = no_node;  ///< index into SolidForest::lists, for the few that have any
    uint32_t first_child = 0;  ///< index into SolidForest::children
    uint32_t child_count = 0;
    uint32_t crowd = no_node;  ///< index into SolidForest::crowds, for compounds of many
    Bounds region;             ///< holds every point inside
};

/// Nodes that further limit a node.
struct SolidLists {
    std::vector<uint32_t> clips;   ///< all must contain the point
    std::vector<uint32_t> bounds;  ///< all must be met by the ray (kept `bounded_by` only)
};

/// The children of a compound by where they have a say. Elsewhere a `local` child is outside of a union or a
/// merge, and inside of an intersection, whose local children are complements.
struct SolidCrowd {
    std::vector<uint32_t> everywhere;
    std::vector<uint32_t> local;
    BoxTree tree;  ///< over `local`
};

/// A shape and where it stands.
struct PlacedShape {
    ShapePtr shape;
    SharedAffine object_from_world;
    bool in_world_space = false;
};

/// All solids of a world; answers inside tests and decides which hits count (spec: geometry 5.2, 5.3, 6).
class SolidForest {
public:
    std::vector<SolidNode> nodes;
    std::vector<PlacedShape> shapes;
    std::vector<uint32_t> children;  ///< of all compounds, one after the other
    std::vector<SolidLists> lists;
    std::vector<SolidCrowd> crowds;

    /// INSIDE* of the spec: inside the node's clips and its shape or compound.
    bool inside(uint32_t node, const Vec3& p) const;
    /// The same without the node's own clips.
    bool inside_unclipped(uint32_t node, const Vec3& p) const;
    /// inside() for a computed crossing of `ray`: true, too, within rounding errors of the surface.
    bool touches(uint32_t node, const Vec3& p, const Ray& ray) const;
    /// Does a hit at `p` on the surface of shape node `leaf` count, seen along `ray`?
    bool counts(uint32_t leaf, const Vec3& p, const Ray& ray) const;

    /// The children of a compound whose textures cutaway_textures looks at: of a difference the first.
    std::span<const uint32_t> looked_at(uint32_t node) const {
        const auto all = children_of(nodes[node]);
        return nodes[node].difference && !all.empty() ? all.first(1) : all;
    }

    /// Computes `region` and, for compounds of many, crowds of the node and all below, its clips and bounds.
    void set_regions(uint32_t node);
    /// `box` of the surface of shape node `leaf`, cut down to the regions in which its hits can count.
    Bounds cut(uint32_t leaf, const Bounds& box) const;

    std::span<const uint32_t> children_of(const SolidNode& node) const {
        return {children.data() + node.first_child, node.child_count};
    }
    const SolidLists& lists_of(const SolidNode& node) const {
        return node.lists == no_node ? no_lists : lists[node.lists];
    }

private:
    /// True if test(child) is true for all children that have a say at `p`.
    template <class Test>
    bool all_at(const SolidNode& node, const Vec3& p, Test&& test) const;
    /// Holds every point inside a shape, whether inverted or not.
    Bounds hull_of(const SolidNode& shape) const;
    void add_crowd(SolidNode& node);
    bool in_all(std::span<const uint32_t> list, const Vec3& p) const;
    Bounds cut_by_others(uint32_t leaf, Bounds box) const;
    /// `box` cut down to what shapes among `limits`, which must all hold, leave of it together with it.
    Bounds within(std::span<const uint32_t> limits, uint32_t without, Bounds box) const;
    bool met_by(uint32_t node, const Vec3& p, const Ray& ray) const;
    bool crosses(uint32_t node, const Ray& ray) const;

    static const SolidLists no_lists;
};

}  // namespace rb
