#include "compile/geometry_parts.h"

#include <algorithm>
#include <cmath>

namespace rb {

namespace {

ElementError error_of(const Leaf& leaf) {
    const Bounds box = leaf.shape->bounds();
    const double size = box.is_finite() && !box.is_empty()
                            ? std::max(largest_magnitude(box.lo), largest_magnitude(box.hi))
                            : 0.0;
    if (leaf.in_world_space) return {1.0, size};
    const auto world_from_object = inverse_of(leaf.object_from_world);
    if (!world_from_object) return {1.0, size};
    const double out = stretch(*world_from_object);
    return {1.0 + out * stretch(leaf.object_from_world),
            out * (size + largest_magnitude(leaf.object_from_world->row[3]))};
}

Element element_of(const Leaf& leaf, uint32_t index, const SolidForest& solids) {
    Element e;
    e.shape = leaf.shape.get();
    e.leaf = index;
    e.mask = leaf.mask;
    e.in_world_space = leaf.in_world_space;
    e.tests_hits = solids.nodes[leaf.solid].tests_hits;
    e.object_stretch = leaf.in_world_space
                           ? 1.0f
                           : std::nextafter(static_cast<float>(stretch(leaf.object_from_world)), 1e38f);
    return e;
}

/// Many rays that meet a sphere's box miss the sphere: a ball answers before the shape is asked.
void set_ball(Element& e) {
    if (!e.in_world_space || !e.shape->fills_ball()) return;
    const Bounds box = e.shape->bounds();
    if (!fits_tree(box)) return;
    e.center = Vec3f(box.center());
    const double moved = glm::length(box.center() - Vec3(e.center));
    constexpr double rounding = 1.0 + 1e-6;
    e.radius = static_cast<float>(rounding * (0.5 * max_component(box.size()) + moved));
}

void set_slabs(Geometry::Parts& parts, Element& e) {
    if (!e.tests_hits) return;
    const Slabs slabs = slabs_of(parts.flat, e.leaf);
    if (slabs.empty()) return;
    e.slabs = static_cast<uint32_t>(parts.slabs.size());
    parts.slabs.push_back(slabs);
}

}  // namespace

bool fits_tree(const Bounds& box) {
    constexpr double limit = 1e30;
    return box.is_finite() && largest_magnitude(box.lo) < limit && largest_magnitude(box.hi) < limit;
}

std::shared_ptr<const Geometry> make_geometry(FlatGeometry flat, bool brute_force) {
    auto geometry = std::make_shared<Geometry>();
    Geometry::Parts& p = *geometry->parts;
    p.flat = std::move(flat);
    const auto& leaves = p.flat.leaves;
    p.element_of_leaf.assign(leaves.size(), no_leaf);
    std::vector<BoxTree::Item> items;
    std::vector<uint32_t> treed;
    items.reserve(leaves.size());
    p.errors.reserve(leaves.size());
    p.elements.reserve(leaves.size());
    const auto add = [&](uint32_t i) {
        p.element_of_leaf[i] = static_cast<uint32_t>(p.elements.size());
        p.elements.push_back(element_of(leaves[i], i, p.flat.solids));
        if (brute_force) return;
        set_ball(p.elements.back());
        set_slabs(p, p.elements.back());
        p.elements.back().is_costly = leaves[i].shape->is_costly() && p.flat.boxes[i].is_finite();
    };
    for (uint32_t i = 0; i < leaves.size(); ++i) {
        p.errors.push_back(error_of(leaves[i]));
        p.all_masks |= leaves[i].mask;
        const Bounds& box = p.flat.boxes[i];
        if (box.is_empty() && !brute_force) continue;
        if (!brute_force && fits_tree(box)) {
            const Bounds tight = tight_box(p.flat, i);
            if (tight.is_empty()) continue;
            treed.push_back(i);
            items.push_back({tight, leaves[i].mask});
        } else {
            add(i);
        }
    }
    p.listed = static_cast<uint32_t>(p.elements.size());
    for (const Element& e : p.elements) {
        PlaneTest plane;
        if (!brute_force && e.in_world_space) e.shape->as_plane(plane.normal, plane.distance);
        p.planes.push_back(plane);
    }
    p.tree = BoxTree(items);
    items = {};  // as large as the elements that now follow
    for (const uint32_t item : p.tree.order()) add(treed[item]);
    return geometry;
}

}  // namespace rb
