#include "compile/cutaway.h"

#include <algorithm>

namespace rb {

namespace {

using Kind = SolidNode::Kind;

void collect(const SolidForest& solids, const Cutaway& cut, uint32_t node, const Vec3& p,
             std::vector<SurfaceWeight>& out) {
    for (const uint32_t child : solids.looked_at(node)) {
        if (!solids.inside(child, p)) continue;
        if (solids.nodes[child].kind != Kind::shape) {
            collect(solids, cut, child, p, out);
            continue;
        }
        const auto worn =
            std::ranges::lower_bound(cut.worn, child, {}, &std::pair<uint32_t, uint32_t>::first);
        if (worn != cut.worn.end() && worn->first == child) out.push_back({worn->second, 1.0f});
    }
}

}  // namespace

void cut_surfaces_at(const SolidForest& solids, const Cutaway& cut, const Vec3& p,
                     std::vector<SurfaceWeight>& out) {
    const size_t before = out.size();
    collect(solids, cut, cut.root, p, out);
    if (out.size() == before) out.push_back({cut.nothing, 1.0f});
    const float share = 1.0f / static_cast<float>(out.size() - before);
    for (size_t i = before; i < out.size(); ++i) out[i].weight = share;
}

uint32_t deciding_root(const SolidForest& solids, uint32_t node) {
    uint32_t root = node;
    for (uint32_t up = solids.nodes[node].parent; up != no_node; up = solids.nodes[up].parent) {
        const SolidNode& compound = solids.nodes[up];
        if (compound.kind != Kind::union_ || compound.lists != no_node) root = up;
    }
    return root;
}

bool is_looked_at(const SolidForest& solids, uint32_t node, uint32_t root) {
    while (node != root) {
        const uint32_t up = solids.nodes[node].parent;
        if (up == no_node) return false;
        const auto seen = solids.looked_at(up);
        if (std::ranges::find(seen, node) == seen.end()) return false;
        node = up;
    }
    return true;
}

}  // namespace rb
