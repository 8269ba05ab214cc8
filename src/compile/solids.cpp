#include "compile/solids.h"

#include <algorithm>

namespace rb {

const SolidLists SolidForest::no_lists;

bool SolidForest::in_all(std::span<const uint32_t> list, const Vec3& p) const {
    for (const uint32_t node : list) {
        if (!inside(node, p)) return false;
    }
    return true;
}

template <class Test>
bool SolidForest::all_at(const SolidNode& node, const Vec3& p, Test&& test) const {
    if (node.crowd == no_node) return std::ranges::all_of(children_of(node), test);
    const SolidCrowd& crowd = crowds[node.crowd];
    return std::ranges::all_of(crowd.everywhere, test) && !crowd.tree.walk_at(p, 1, [&](uint32_t element) {
        return !test(crowd.local[crowd.tree.order()[element]]);
    });
}

bool SolidForest::inside(uint32_t index, const Vec3& p) const {
    const SolidNode& node = nodes[index];
    return node.region.contains(p) && inside_unclipped(index, p) && in_all(lists_of(node).clips, p);
}

bool SolidForest::inside_unclipped(uint32_t index, const Vec3& p) const {
    const SolidNode& node = nodes[index];
    switch (node.kind) {
        case SolidNode::Kind::shape: {
            const PlacedShape& placed = shapes[node.placed];
            // A surface without inside has no outside either.
            if (placed.shape->is_patch()) return false;
            const bool in =
                placed.shape->inside(placed.in_world_space ? p : placed.object_from_world.point(p));
            return in != node.inverted;
        }
        case SolidNode::Kind::union_:
        case SolidNode::Kind::merge:
            return !all_at(node, p, [&](uint32_t child) { return !inside(child, p); });
        case SolidNode::Kind::intersection:
            return all_at(node, p, [&](uint32_t child) { return inside(child, p); });
    }
    return false;
}

bool SolidForest::touches(uint32_t index, const Vec3& p, const Ray& ray) const {
    if (inside(index, p)) return true;
    // Coincident surfaces: the crossing's own rounding must not decide. Infinite siblings (planes and
    // quadrics, complements) are many, far from p, and not worth two more tests.
    if (!nodes[index].region.is_finite()) return false;
    constexpr double rounding = 1e-12;
    const double size = largest_magnitude(p) + largest_magnitude(p - ray.origin);
    const Vec3 step = (rounding * size / largest_magnitude(ray.direction)) * ray.direction;
    return inside(index, p - step) || inside(index, p + step);
}

bool SolidForest::counts(uint32_t leaf, const Vec3& p, const Ray& ray) const {
    for (uint32_t from = no_node, at = leaf; at != no_node; from = at, at = nodes[at].parent) {
        const SolidNode& node = nodes[at];
        if (!node.tests_hits) return true;
        if (node.kind == SolidNode::Kind::merge) {
            const auto is_outside = [&](uint32_t child) { return child == from || !inside(child, p); };
            if (!all_at(node, p, is_outside)) return false;
        } else if (node.kind == SolidNode::Kind::intersection) {
            const auto holds = [&](uint32_t child) { return child == from || touches(child, p, ray); };
            if (!all_at(node, p, holds)) return false;
        }
        if (!in_all(lists_of(node).clips, p)) return false;
        for (const uint32_t bound : lists_of(node).bounds) {
            if (!met_by(bound, p, ray)) return false;
        }
    }
    return true;
}

bool SolidForest::met_by(uint32_t node, const Vec3& p, const Ray& ray) const {
    return inside(node, p) || inside(node, ray.origin) || crosses(node, ray);
}

bool SolidForest::crosses(uint32_t index, const Ray& ray) const {
    const SolidNode& node = nodes[index];
    if (node.kind != SolidNode::Kind::shape) {
        for (const uint32_t child : children_of(node)) {
            if (crosses(child, ray)) return true;
        }
        return false;
    }
    const PlacedShape& placed = shapes[node.placed];
    const Ray moved = placed.in_world_space ? ray
                                            : Ray{placed.object_from_world.point(ray.origin),
                                                  placed.object_from_world.direction(ray.direction)};
    Crossings all;
    placed.shape->crossings(ShapeRay{moved}, all);
    for (size_t i = 0; i < all.size(); ++i) {
        if (counts(index, ray.at(all[i].t), ray)) return true;
    }
    return false;
}

Bounds SolidForest::hull_of(const SolidNode& shape) const {
    const PlacedShape& placed = shapes[shape.placed];
    if (placed.shape->is_patch()) return {};
    const Bounds hull = placed.shape->solid_bounds();
    if (placed.in_world_space) return hull;
    const auto forward = inverse_of(placed.object_from_world);
    return forward ? transformed(hull, *forward) : Bounds::everything();
}

void SolidForest::add_crowd(SolidNode& node) {
    constexpr size_t few = 16;
    if (node.child_count <= few) return;
    SolidCrowd crowd;
    std::vector<BoxTree::Item> items;
    for (const uint32_t child : children_of(node)) {
        const SolidNode& c = nodes[child];
        Bounds box = c.region;
        if (node.kind == SolidNode::Kind::intersection) {
            const bool is_complement = c.kind == SolidNode::Kind::shape && c.inverted && c.lists == no_node;
            box = is_complement ? hull_of(c) : Bounds::everything();
        }
        if (box.is_finite() && !box.is_empty()) {
            // Points in a shape may lie outside of its box by rounding.
            const Vec3 margin = 1e-9 * (glm::abs(box.lo) + glm::abs(box.hi));
            items.push_back({{box.lo - margin, box.hi + margin}, 1});
            crowd.local.push_back(child);
        } else {
            crowd.everywhere.push_back(child);
        }
    }
    if (items.size() <= few) return;
    crowd.tree = BoxTree(items);
    node.crowd = static_cast<uint32_t>(crowds.size());
    crowds.push_back(std::move(crowd));
}

void SolidForest::set_regions(uint32_t index) {
    SolidNode& node = nodes[index];
    Bounds region;
    if (node.kind == SolidNode::Kind::shape) {
        const bool is_complement = node.inverted && !shapes[node.placed].shape->is_patch();
        region = is_complement ? Bounds::everything() : hull_of(node);
    } else {
        if (node.kind == SolidNode::Kind::intersection) region = Bounds::everything();
        for (const uint32_t child : children_of(node)) {
            set_regions(child);
            if (node.kind == SolidNode::Kind::intersection) {
                region = intersection(region, nodes[child].region);
            } else if (!nodes[child].region.is_empty()) {
                region.include(nodes[child].region);
            }
        }
        add_crowd(node);
    }
    for (const uint32_t clip : lists_of(node).clips) {
        set_regions(clip);
        region = intersection(region, nodes[clip].region);
    }
    if (node.kind == SolidNode::Kind::intersection) region = within(children_of(node), no_node, region);
    region = within(lists_of(node).clips, no_node, region);
    for (const uint32_t bound : lists_of(node).bounds) set_regions(bound);
    node.region = region;
}

Bounds SolidForest::within(std::span<const uint32_t> limits, uint32_t without, Bounds box) const {
    for (const uint32_t limit : limits) {
        const SolidNode& node = nodes[limit];
        if (limit == without || node.kind != SolidNode::Kind::shape || node.inverted) continue;
        const PlacedShape& placed = shapes[node.placed];
        if (placed.in_world_space && !placed.shape->is_patch()) box = placed.shape->solid_bounds_within(box);
    }
    return box;
}

Bounds SolidForest::cut(uint32_t leaf, const Bounds& box) const {
    const Bounds loose = cut_by_others(leaf, box);
    const PlacedShape& own = shapes[nodes[leaf].placed];
    if (loose.is_finite() || !own.in_world_space) return loose;
    // What stays infinite is a half-space, perhaps, and its box one that must hold the inside.
    const Bounds tight = own.shape->bounds_within(cut_by_others(leaf, own.shape->bounds_within(box)));
    return tight.is_finite() ? tight : loose;
}

Bounds SolidForest::cut_by_others(uint32_t leaf, Bounds box) const {
    for (uint32_t from = no_node, at = leaf; at != no_node; from = at, at = nodes[at].parent) {
        const SolidNode& node = nodes[at];
        if (!node.tests_hits) break;
        if (node.kind == SolidNode::Kind::intersection) {
            for (const uint32_t child : children_of(node)) {
                if (child != from) box = intersection(box, nodes[child].region);
            }
            box = within(children_of(node), from, box);
        }
        for (const uint32_t clip : lists_of(node).clips) box = intersection(box, nodes[clip].region);
        box = within(lists_of(node).clips, no_node, box);
    }
    return box;
}

}  // namespace rb
