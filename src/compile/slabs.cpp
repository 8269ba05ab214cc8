#include "compile/slabs.h"

#include "compile/flatten.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace rb {

namespace {

/// True if the normals are the same, or opposite, up to rounding.
bool are_parallel(const Vec3& a, const Vec3& b) { return std::abs(glm::dot(a, b)) > 1.0 - 1e-12; }

/// A box does as well.
bool is_along_axis(const Vec3& normal) { return largest_magnitude(normal) > 1.0 - 1e-12; }

/// What slabs and boxes are widened by, as a share of the coordinates: more than rounding moves crossings,
/// and than solids forgive them.
constexpr double slack = 1e-7;

/// The plane that a node is.
bool plane_of(const SolidForest& solids, uint32_t node, Vec3& normal, double& distance) {
    const SolidNode& n = solids.nodes[node];
    if (n.kind != SolidNode::Kind::shape || n.inverted) return false;
    const PlacedShape& placed = solids.shapes[n.placed];
    return placed.in_world_space && placed.shape->as_plane(normal, distance);
}

/// Calls `take` with what limits the leaf's crossings, itself aside.
template <class Take>
void each_limit(const SolidForest& solids, uint32_t leaf, Take&& take) {
    for (uint32_t from = no_node, at = leaf; at != no_node; from = at, at = solids.nodes[at].parent) {
        const SolidNode& node = solids.nodes[at];
        if (!node.tests_hits) return;
        if (node.kind == SolidNode::Kind::intersection) {
            for (const uint32_t child : solids.children_of(node)) {
                if (child != from) take(child);
            }
        }
        for (const uint32_t clip : solids.lists_of(node).clips) take(clip);
    }
}

Extent extent_of(const PlacedShape& placed, const Vec3& normal) {
    if (placed.in_world_space) return placed.shape->extent(normal);
    const auto forward = inverse_of(placed.object_from_world);
    if (!forward) return {};
    const Extent there = placed.shape->extent(forward->transposed_direction(normal));
    const double moved = glm::dot(forward->row[3], normal);
    return {there.lo + moved, there.hi + moved};
}

/// Of the inside of a node.
Extent extent_of(const SolidForest& solids, uint32_t index, const Vec3& normal) {
    const SolidNode& node = solids.nodes[index];
    Vec3 own_normal;
    double distance = 0;
    if (plane_of(solids, index, own_normal, distance)) {
        if (!are_parallel(own_normal, normal)) return {};
        Extent half;
        if (glm::dot(own_normal, normal) > 0.0) {
            half.hi = distance;
        } else {
            half.lo = -distance;
        }
        return half;
    }
    if (node.kind == SolidNode::Kind::shape) {
        const PlacedShape& placed = solids.shapes[node.placed];
        return node.inverted || placed.shape->is_patch() ? Extent{} : extent_of(placed, normal);
    }
    if (node.child_count == 0) return {};
    const bool cuts = node.kind == SolidNode::Kind::intersection;
    Extent all = cuts ? Extent{} : Extent::nothing();
    for (const uint32_t child : solids.children_of(node)) {
        const Extent part = extent_of(solids, child, normal);
        all.lo = cuts ? std::max(all.lo, part.lo) : std::min(all.lo, part.lo);
        all.hi = cuts ? std::min(all.hi, part.hi) : std::max(all.hi, part.hi);
    }
    return all;
}

Extent extent_of_surface(const SolidForest& solids, uint32_t node, const Vec3& normal) {
    Vec3 own_normal;
    double distance = 0;
    if (!plane_of(solids, node, own_normal, distance)) {
        return extent_of(solids.shapes[solids.nodes[node].placed], normal);
    }
    if (!are_parallel(own_normal, normal)) return {};
    const double at = glm::dot(own_normal, normal) > 0.0 ? distance : -distance;
    return {at, at};
}

/// Where crossings of a leaf can count along a direction.
Extent extent_of_crossings(const SolidForest& solids, uint32_t leaf, const Vec3& normal) {
    Extent extent = extent_of_surface(solids, leaf, normal);
    each_limit(solids, leaf, [&](uint32_t limit) {
        const Extent part = extent_of(solids, limit, normal);
        extent = {std::max(extent.lo, part.lo), std::min(extent.hi, part.hi)};
    });
    return extent;
}

/// Limits are looked at leaf by leaf: not worth it where there are many.
bool has_few_limits(const SolidForest& solids, uint32_t leaf) {
    constexpr size_t most = 64;
    size_t count = 0;
    for (uint32_t at = leaf; at != no_node && solids.nodes[at].tests_hits; at = solids.nodes[at].parent) {
        const SolidNode& node = solids.nodes[at];
        if (node.kind == SolidNode::Kind::intersection) count += node.child_count;
        count += solids.lists_of(node).clips.size();
    }
    return count <= most;
}

/// The box of the leaf, if more can be said about where its crossings count.
const Bounds* box_to_cut(const FlatGeometry& flat, uint32_t index) {
    const Leaf& leaf = flat.leaves[index];
    const Bounds& box = flat.boxes[index];
    if (leaf.instance != no_surface || !box.is_finite() || box.is_empty()) return nullptr;
    // Facets reach beyond the surface.
    const SolidForest& solids = flat.solids;
    if (leaf.shape != solids.shapes[solids.nodes[leaf.solid].placed].shape) return nullptr;
    return has_few_limits(solids, leaf.solid) ? &box : nullptr;
}

double size_of(const Bounds& box) { return std::max(largest_magnitude(box.lo), largest_magnitude(box.hi)); }

}  // namespace

void Slabs::add(const Vec3& normal, const Extent& extent, double size) {
    const double margin = slack * size;
    slabs_[count_++] = {normal, {extent.lo - margin, extent.hi + margin}};
}

bool Slabs::are_missed(const Ray& ray, double t_min, double t_max) const {
    constexpr double rounding = 1e-9;
    const double error = rounding * largest_magnitude(ray.origin);
    for (size_t i = 0; i < count_; ++i) {
        const Slab& slab = slabs_[i];
        const double slope = glm::dot(slab.normal, ray.direction);
        const double height = glm::dot(slab.normal, ray.origin);
        if (slope == 0.0) continue;
        const double inverse = 1.0 / slope;
        const double a = (slab.extent.lo - error - height) * inverse;
        const double b = (slab.extent.hi + error - height) * inverse;
        t_min = std::max(t_min, std::min(a, b));
        t_max = std::min(t_max, std::max(a, b));
    }
    // The slabs' margins are far wider than what rounding does to these.
    return t_min > t_max;
}

Slabs slabs_of(const FlatGeometry& flat, uint32_t index) {
    Slabs slabs;
    const SolidForest& solids = flat.solids;
    const uint32_t leaf = flat.leaves[index].solid;
    const Bounds* box = box_to_cut(flat, index);
    if (!box) return slabs;
    std::vector<Vec3> normals;
    const auto take_normal = [&](uint32_t node) {
        Vec3 normal;
        double distance = 0;
        if (!plane_of(solids, node, normal, distance) || is_along_axis(normal)) return;
        const auto is_known = [&](const Vec3& n) { return are_parallel(n, normal); };
        if (!std::ranges::any_of(normals, is_known)) normals.push_back(normal);
    };
    take_normal(leaf);
    each_limit(solids, leaf, take_normal);
    for (size_t i = 0; i < std::min(normals.size(), Slabs::most); ++i) {
        slabs.add(normals[i], extent_of_crossings(solids, leaf, normals[i]), size_of(*box));
    }
    return slabs;
}

Bounds tight_box(const FlatGeometry& flat, uint32_t index) {
    const SolidForest& solids = flat.solids;
    const uint32_t leaf = flat.leaves[index].solid;
    const Bounds* box = box_to_cut(flat, index);
    if (!box) return flat.boxes[index];
    bool knows_more = flat.leaves[index].shape->has_tight_extent();
    each_limit(solids, leaf, [&](uint32_t limit) {
        const SolidNode& node = solids.nodes[limit];
        knows_more = knows_more || (node.kind == SolidNode::Kind::shape && !node.inverted &&
                                    solids.shapes[node.placed].shape->has_tight_extent());
    });
    if (!knows_more) return *box;
    const double margin = slack * size_of(*box);
    Bounds tight = *box;
    for (int axis = 0; axis < 3; ++axis) {
        Vec3 normal{0.0};
        normal[axis] = 1.0;
        const Extent extent = extent_of_crossings(solids, leaf, normal);
        tight.lo[axis] = std::max(tight.lo[axis], extent.lo - margin);
        tight.hi[axis] = std::min(tight.hi[axis], extent.hi + margin);
    }
    return tight;
}

}  // namespace rb
