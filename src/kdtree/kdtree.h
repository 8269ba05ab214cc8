#pragma once
#include "base/huge_pages.h"
#include "kdtree/box_f.h"
#include "kdtree/box_ray.h"
#include "kdtree/walk_stack.h"
#include "math/ray.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace rb {

struct KdOptions {
    double traversal_cost = 1.5;   ///< of one inner node, in units of one leaf block
    double element_cost = 1.0;     ///< of one leaf block of `block` elements
    int block = 4;                 ///< elements that are tested at once; leaves hold whole blocks
    double most_references = 3.0;  ///< hard bound on references per element
    int depth = -1;                ///< most levels; -1: 8 + 1.3 log2(n)
};

/// Eight boxes, each around what the cell of a node of the tree holds. A child is another such node, or
/// (leaf_bit) blocks of elements: how many, and the first one; boxes without child are never met.
struct alignas(32) KdNode {
    float planes[3][2][8];  ///< by axis, low or high, child
    uint32_t child[8];

    static constexpr uint32_t leaf_bit = 1u << 31;
    static constexpr uint32_t most_blocks = 15;
    static constexpr int count_shift = 27;
    static uint32_t first_block(uint32_t leaf) { return leaf & ((1u << count_shift) - 1); }
    static uint32_t block_count(uint32_t leaf) { return leaf >> count_shift & most_blocks; }
};

/// A kD-tree over numbered elements, stored as the boxes around what its cells hold: in single precision,
/// rounded outward. The test of a ray allows for every rounding error (BoxRay), so no element is missed that
/// the ray may meet (docs/architecture.md, "kD-tree").
class KdTree {
public:
    /// The part of an element inside a cell, as a box; may be tighter than its box cut by the cell. Empty
    /// only if the element has no point there.
    using Clip = std::function<Bounds(uint32_t element, const Bounds& cell)>;

    KdTree() = default;
    /// The box of each element, asked once. Left out is an element with lo > hi, and one that single
    /// precision cannot hold (infinite, or not a number).
    using BoxOf = std::function<BoxF(uint32_t element)>;

    /// `clip` may be empty; several threads may call it.
    KdTree(uint32_t count, const BoxOf& box_of, const KdOptions& options, const Clip& clip = {});
    KdTree(const std::vector<BoxF>& boxes, const KdOptions& options, const Clip& clip = {});

    bool is_empty() const { return nodes_.empty(); }
    const Bounds& bounds() const { return bounds_; }
    size_t node_count() const { return nodes_.size(); }
    /// The elements of all cells, block by block.
    std::span<const uint32_t> references() const { return references_; }
    size_t memory() const { return nodes_.size() * sizeof(KdNode) + references_.size() * sizeof(uint32_t); }

    /// Walks the cells that the ray meets between `t_min` and `t_max`, near to far, and calls
    /// `leaf(const uint32_t* elements, uint32_t count)` for each; `t_max` is read again after every call, so
    /// the leaf lowers it when it finds a hit. The walk ends early when the leaf returns true. Hits must be
    /// accepted wherever in the ray's interval they lie, also outside the cell. A leaf's last element is
    /// repeated until its block is full.
    template <class Leaf>
    bool walk(const Ray& ray, double t_min, const double& t_max, Leaf&& leaf) const;

    /// The same with all boxes of a node at once (kdtree/wide_walk.h).
    template <class Leaf>
    bool walk_wide(const Ray& ray, double t_min, const double& t_max, Leaf&& leaf) const;

private:
    friend class KdPacker;
    class Walk;
    static constexpr int most_depth = 60;

    std::vector<KdNode, HugePages<KdNode>> nodes_;
    std::vector<uint32_t> references_;
    uint32_t block_ = 1;
    Bounds bounds_;
    float reach_ = 0;  ///< largest coordinate
};

/// A walk between two tests of a node's boxes.
class KdTree::Walk {
public:
    Walk(const KdTree& tree, const Ray& ray, double t_min, const double& t_max)
        : slabs(ray, Vec3{0.0}, tree.reach_),
          near(slabs.scaled_down(t_min)),
          tree_(tree),
          t_max_(t_max),
          far_(slabs.scaled_up(t_max)) {}

    const KdNode& node() const { return tree_.nodes_[at_]; }
    float far() const { return far_; }

    /// To the next node, through the leaves before it. Empty if there is one, else whether a leaf ended the
    /// walk.
    template <class Leaf>
    inline __attribute__((always_inline)) std::optional<bool> go_on(unsigned met, const float* near_of,
                                                                    Leaf& leaf) {
        if (met != 0) {
            at_ = stack_.push(node().child, met, near_of);
        } else if (!stack_.pop(far_, at_)) {
            return false;
        }
        const uint32_t block = tree_.block_;
        while ((at_ & KdNode::leaf_bit) != 0) {
            if (leaf(tree_.references_.data() + size_t{block} * KdNode::first_block(at_),
                     block * KdNode::block_count(at_)))
                return true;
            far_ = slabs.scaled_up(t_max_);
            if (!stack_.pop(far_, at_)) return false;
        }
        return std::nullopt;
    }

    const BoxRay slabs;
    const float near;

private:
    const KdTree& tree_;
    const double& t_max_;
    float far_;
    uint32_t at_ = 0;
    WalkStack<size_t{7} * (most_depth + 12)> stack_;
};

template <class Leaf>
bool KdTree::walk(const Ray& ray, double t_min, const double& t_max, Leaf&& leaf) const {
    if (nodes_.empty()) return false;
    Walk walk(*this, ray, t_min, t_max);
    for (;;) {
        const auto& planes = walk.node().planes;
        alignas(16) float near_of[8];
        const unsigned met = walk.slabs.meets(planes, walk.near, walk.far(), near_of) |
                             walk.slabs.meets(planes, walk.near, walk.far(), near_of + 4, 4) << 4;
        if (const auto end = walk.go_on(met, near_of, leaf)) return *end;
    }
}

}  // namespace rb
