#pragma once
#include "kdtree/kdtree.h"

#include <array>

namespace rb {

/// A node of the binary tree, with the box around what its cell holds. Of an inner one the low child is
/// `first`, and the high one follows; of a leaf `first` is its first reference.
struct BinaryNode {
    static constexpr uint32_t inner = std::numeric_limits<uint32_t>::max();
    BoxF hull;
    uint32_t first;
    uint32_t count;  ///< of references, or `inner`
};

/// Lays a binary tree out in nodes of eight boxes, and the elements of its leaves in blocks.
class KdPacker {
public:
    KdPacker(KdTree& tree, const std::vector<BinaryNode>& nodes, const std::vector<uint32_t>& references)
        : tree_(tree), binary_(nodes), references_(references) {
        tree_.references_.reserve(references.size() + nodes.size() / 2 * (tree.block_ - 1));
        pack(0);
        tree_.nodes_.shrink_to_fit();
        tree_.references_.shrink_to_fit();
    }

private:
    uint32_t new_node() {
        KdNode& node = tree_.nodes_.emplace_back();
        for (auto& axis : node.planes) {
            for (size_t i = 0; i < 8; ++i) {
                axis[0][i] = std::numeric_limits<float>::infinity();
                axis[1][i] = -std::numeric_limits<float>::infinity();
            }
        }
        for (uint32_t& child : node.child) child = KdNode::leaf_bit;
        return static_cast<uint32_t>(tree_.nodes_.size() - 1);
    }

    void set_child(uint32_t at, size_t i, const BoxF& box, uint32_t child) {
        KdNode& node = tree_.nodes_[at];
        for (size_t axis = 0; axis < 3; ++axis) {
            node.planes[axis][0][i] = box.lo[axis];
            node.planes[axis][1][i] = box.hi[axis];
        }
        node.child[i] = child;
    }

    /// The largest of up to eight nodes are replaced by their children as long as there is room.
    uint32_t pack(uint32_t root) {
        std::array<uint32_t, 8> parts;
        size_t count = 0;
        const auto add = [&](uint32_t node) {
            if (binary_[node].count != 0) parts[count++] = node;
        };
        add(root);
        while (count < 8) {
            size_t widest = 8;
            double most = -1.0;
            for (size_t i = 0; i < count; ++i) {
                const BinaryNode& node = binary_[parts[i]];
                if (node.count != BinaryNode::inner || half_area(node.hull) <= most) continue;
                widest = i;
                most = half_area(node.hull);
            }
            if (widest == 8) break;
            const uint32_t low = binary_[parts[widest]].first;
            parts[widest] = parts[--count];
            add(low);
            add(low + 1);
        }
        const uint32_t at = new_node();
        for (size_t i = 0; i < count; ++i) {
            const BinaryNode& node = binary_[parts[i]];
            set_child(at, i, node.hull, node.count == BinaryNode::inner ? pack(parts[i]) : add_leaf(node));
        }
        return at;
    }

    uint32_t add_leaf(const BinaryNode& leaf) {
        const auto block = static_cast<uint32_t>(tree_.references_.size() / tree_.block_);
        for (uint32_t i = 0; i < leaf.count; ++i) tree_.references_.push_back(references_[leaf.first + i]);
        while (tree_.references_.size() % tree_.block_ != 0)
            tree_.references_.push_back(references_[leaf.first + leaf.count - 1]);
        const auto end = static_cast<uint32_t>(tree_.references_.size() / tree_.block_);
        return leaf_of(leaf.hull, block, end - block);
    }

    /// Where there are more blocks than a leaf can name, a node all of whose children have the same box.
    uint32_t leaf_of(const BoxF& hull, uint32_t first, uint32_t count) {
        if (count <= KdNode::most_blocks) return KdNode::leaf_bit | count << KdNode::count_shift | first;
        const uint32_t at = new_node();
        for (uint32_t i = 0; i < 8; ++i) {
            const auto begin = static_cast<uint32_t>(uint64_t{count} * i / 8);
            const auto end = static_cast<uint32_t>(uint64_t{count} * (i + 1) / 8);
            set_child(at, i, hull, leaf_of(hull, first + begin, end - begin));
        }
        return at;
    }

    KdTree& tree_;
    const std::vector<BinaryNode>& binary_;
    const std::vector<uint32_t>& references_;
};

}  // namespace rb
