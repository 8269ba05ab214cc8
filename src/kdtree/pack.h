#pragma once
#include "kdtree/kdtree.h"

namespace rb {

/// Inner: plane, and index of the low child (the high one follows); leaf: first reference, and count.
struct KdNode {
    uint32_t plane_or_first;
    uint32_t link;  ///< axis (3: leaf) in the low two bits, child or count above
    bool is_leaf() const { return (link & 3u) == 3u; }
    uint32_t axis() const { return link & 3u; }
    uint32_t value() const { return link >> 2; }
    float plane() const { return std::bit_cast<float>(plane_or_first); }
};

/// Lays a binary tree out in treelets, and the elements of its leaves in blocks.
class KdPacker {
public:
    KdPacker(KdTree& tree, const std::vector<KdNode>& nodes, const std::vector<uint32_t>& references)
        : tree_(tree), nodes_(nodes), references_(references) {
        tree_.treelets_.reserve(nodes.size() / 4);
        tree_.references_.reserve(references.size() + nodes.size() / 2 * (tree.block_ - 1));
        pack(0);
        tree_.treelets_.shrink_to_fit();
        tree_.references_.shrink_to_fit();
    }

private:
    uint32_t new_treelet(float plane) {
        KdTreelet& treelet = tree_.treelets_.emplace_back();
        for (float& p : treelet.plane) p = plane;
        treelet.axes_and_filled = 0;
        for (uint32_t& child : treelet.child) child = KdTreelet::leaf_bit;
        return static_cast<uint32_t>(tree_.treelets_.size() - 1);
    }

    uint32_t pack(uint32_t root) {
        const uint32_t at = new_treelet(std::numeric_limits<float>::infinity());
        uint32_t inner[8];
        for (uint32_t& child : inner) child = no_node;
        place(at, root, 0, inner);
        for (size_t i = 0; i < 8; ++i) {
            if (inner[i] == no_node) continue;
            const uint32_t child = pack(inner[i]);
            tree_.treelets_[at].child[i] = child;
        }
        return at;
    }

    /// A node and all below it in the treelet; those that begin treelets of their own go to `inner`.
    void place(uint32_t at, uint32_t node, uint32_t slot, uint32_t inner[8]) {
        const KdNode& n = nodes_[node];
        if (!n.is_leaf() && slot < 7) {
            tree_.treelets_[at].plane[slot] = n.plane();
            tree_.treelets_[at].axes_and_filled |= n.axis() << 3 * slot;
            place(at, n.value(), 2 * slot + 1, inner);
            place(at, n.value() + 1, 2 * slot + 2, inner);
            return;
        }
        while (slot < 7) slot = 2 * slot + 1;
        const uint32_t lane = slot - 7;
        if (!n.is_leaf()) {
            inner[lane] = node;
        } else if (n.value() > 0) {
            const uint32_t child = add_leaf(n.plane_or_first, n.value());
            tree_.treelets_[at].child[lane] = child;
        } else {
            return;
        }
        tree_.treelets_[at].axes_and_filled |= 1u << (24 + lane);
    }

    uint32_t add_leaf(uint32_t first, uint32_t count) {
        const auto block = static_cast<uint32_t>(tree_.references_.size() / tree_.block_);
        for (uint32_t i = 0; i < count; ++i) tree_.references_.push_back(references_[first + i]);
        while (tree_.references_.size() % tree_.block_ != 0)
            tree_.references_.push_back(references_[first + count - 1]);
        return leaf_of(block, static_cast<uint32_t>(tree_.references_.size() / tree_.block_) - block);
    }

    /// Where there are more blocks than a leaf can name, a treelet all of whose children are visited.
    uint32_t leaf_of(uint32_t first, uint32_t count) {
        if (count <= KdTreelet::most_blocks)
            return KdTreelet::leaf_bit | count << KdTreelet::count_shift | first;
        const uint32_t at = new_treelet(std::numeric_limits<float>::quiet_NaN());
        for (uint32_t i = 0; i < 8; ++i) {
            const auto begin = static_cast<uint32_t>(uint64_t{count} * i / 8);
            const auto end = static_cast<uint32_t>(uint64_t{count} * (i + 1) / 8);
            const uint32_t child = leaf_of(first + begin, end - begin);
            tree_.treelets_[at].child[i] = child;
        }
        tree_.treelets_[at].axes_and_filled = 0xffu << 24;
        return at;
    }

    static constexpr uint32_t no_node = std::numeric_limits<uint32_t>::max();

    KdTree& tree_;
    const std::vector<KdNode>& nodes_;
    const std::vector<uint32_t>& references_;
};

}  // namespace rb
