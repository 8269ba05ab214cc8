#include "compile/leaf_order.h"

#include <algorithm>
#include <utility>

namespace rb {

namespace {

/// Shape nodes below `node` in the order in which the reference produces their hits.
void list_shapes(const SolidForest& solids, uint32_t node, bool turned, std::vector<uint32_t>& out) {
    const SolidNode& n = solids.nodes[node];
    if (n.kind == SolidNode::Kind::shape) {
        out.push_back(node);
        return;
    }
    const bool refuses =
        n.kind != SolidNode::Kind::union_ || (n.lists != no_node && !solids.lists[n.lists].clips.empty());
    for (uint32_t k = 0; k < n.child_count; ++k) {
        const uint32_t at = n.first_child + (turned ? n.child_count - 1 - k : k);
        list_shapes(solids, solids.children[at], turned != refuses, out);
    }
}

}  // namespace

void put_seen_first(const SolidForest& solids, uint32_t root, std::span<Leaf> leaves) {
    if (leaves.size() < 2) return;
    std::vector<uint32_t> shapes;
    list_shapes(solids, root, false, shapes);
    // What a light inside looks like stands between the solid's leaves.
    if (shapes.size() != leaves.size()) {
        std::ranges::reverse(leaves);
        return;
    }
    std::vector<Leaf> ordered;
    ordered.reserve(leaves.size());
    for (size_t i = shapes.size(); i-- > 0;) {
        ordered.push_back(std::move(*std::ranges::lower_bound(leaves, shapes[i], {}, &Leaf::solid)));
    }
    std::ranges::move(ordered, leaves.begin());
}

void put_first(const std::vector<bool>& marked, std::span<const uint32_t> ends, std::vector<Leaf>& leaves,
               std::vector<Bounds>& boxes) {
    if (std::ranges::find(marked, true) == marked.end()) return;
    std::vector<Leaf> ordered_leaves;
    std::vector<Bounds> ordered_boxes;
    ordered_leaves.reserve(leaves.size());
    ordered_boxes.reserve(boxes.size());
    for (const bool now : {true, false}) {
        size_t k = 0;
        for (size_t i = 0; i < marked.size(); ++i) {
            for (; k < ends[i]; ++k) {
                if (marked[i] != now) continue;
                ordered_leaves.push_back(std::move(leaves[k]));
                ordered_boxes.push_back(boxes[k]);
            }
        }
    }
    leaves = std::move(ordered_leaves);
    boxes = std::move(ordered_boxes);
}

}  // namespace rb
