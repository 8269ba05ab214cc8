#pragma once
#include "base/huge_pages.h"
#include "kdtree/box_f.h"
#include "math/ray.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <vector>

namespace rb {

struct KdOptions {
    double traversal_cost = 1.5;   ///< of one inner node, in units of one leaf block
    double element_cost = 1.0;     ///< of one leaf block of `block` elements
    int block = 4;                 ///< elements that are tested at once; leaves hold whole blocks
    int sweep_below = 1 << 14;     ///< nodes with fewer elements look at every plane instead of bins
    double most_references = 3.0;  ///< hard bound on references per element
    int depth = -1;                ///< most levels; -1: 8 + 1.3 log2(n)
};

/// Up to seven inner nodes of three levels in one cache line, and the eight children below them.
struct alignas(64) KdTreelet {
    /// Of node i, whose low child is 2 i + 1 and high child 2 i + 2; those from 7 on are the children. Infinite
    /// where a leaf stands higher up (all is on its low side), NaN where both sides are to be visited.
    float plane[7];
    uint32_t axes_and_filled;  ///< three bits an axis; from bit 24 on: the children that hold anything
    /// Another treelet, or (leaf_bit) blocks of elements: how many, and the first one.
    uint32_t child[8];

    static constexpr uint32_t leaf_bit = 1u << 31;
    static constexpr uint32_t most_blocks = 15;
    static constexpr int count_shift = 27;
    static uint32_t first_block(uint32_t leaf) { return leaf & ((1u << count_shift) - 1); }
    static uint32_t block_count(uint32_t leaf) { return leaf >> count_shift & most_blocks; }
    int axis(uint32_t node) const { return static_cast<int>(axes_and_filled >> 3 * node & 7u); }
    unsigned filled() const { return axes_and_filled >> 24; }
};
static_assert(sizeof(KdTreelet) == 64);

/// A kD-tree over numbered elements: planes in single precision, rays in double. Boxes are never enlarged;
/// the traversal rules keep every hit (docs/architecture.md, "kD-tree"; algorithms 1.3).
class KdTree {
public:
    /// The part of an element inside a cell, as a box; may be tighter than its box cut by the cell. Empty
    /// only if the element has no point there.
    using Clip = std::function<Bounds(uint32_t element, const Bounds& cell)>;

    KdTree() = default;
    /// The box of each element, asked once. Left out is an element with lo > hi, and one that single
    /// precision cannot hold (infinite, or not a number).
    using BoxOf = std::function<BoxF(uint32_t element)>;

    /// `clip` may be empty.
    KdTree(uint32_t count, const BoxOf& box_of, const KdOptions& options, const Clip& clip = {});
    KdTree(const std::vector<BoxF>& boxes, const KdOptions& options, const Clip& clip = {});

    bool is_empty() const { return treelets_.empty(); }
    const Bounds& bounds() const { return bounds_; }
    size_t treelet_count() const { return treelets_.size(); }
    /// The elements of all cells, block by block.
    std::span<const uint32_t> references() const { return references_; }
    size_t memory() const {
        return treelets_.size() * sizeof(KdTreelet) + references_.size() * sizeof(uint32_t);
    }

    /// Walks the cells that the ray meets between `t_min` and `t_max`, near to far, and calls
    /// `leaf(const uint32_t* elements, uint32_t count)` for each; `t_max` is read again after every call, so
    /// the leaf lowers it when it finds a hit. The walk ends early when the leaf returns true. Hits must be
    /// accepted wherever in the ray's interval they lie, also outside the cell. A leaf's last element is
    /// repeated until its block is full.
    template <class Leaf>
    bool walk(const Ray& ray, double t_min, const double& t_max, Leaf&& leaf) const;

    /// The same by three levels at once (kdtree/wide_walk.h).
    template <class Leaf>
    bool walk_wide(const Ray& ray, double t_min, const double& t_max, Leaf&& leaf) const;

private:
    friend class KdBuilder;
    friend class KdPacker;

    bool clip_ray(const Ray& ray, const Vec3& inverse, double& near, double& far) const;

    static constexpr int most_depth = 60;
    // A hit at t_max itself may lie in a cell that rounding puts just behind it.
    static constexpr double hit_rounding = 1e-13;
    // Three roundings of the distance to a plane, at most 1.5 ulp each. Negative distances need no care: they
    // are before `near`, which never is negative, however they are rounded.
    static constexpr double rounding = 8e-16;

    std::vector<KdTreelet, HugePages<KdTreelet>> treelets_;
    std::vector<uint32_t> references_;
    uint32_t block_ = 1;
    Bounds bounds_;
};

template <class Leaf>
bool KdTree::walk(const Ray& ray, double t_min, const double& t_max, Leaf&& leaf) const {
    if (treelets_.empty()) return false;
    const Vec3 inverse = 1.0 / ray.direction;
    double near = t_min;
    double far = t_max + t_max * hit_rounding;
    if (!clip_ray(ray, inverse, near, far)) return false;
    // Plain arrays: a vector's [] with a variable index costs a branch.
    const double origin[3] = {ray.origin.x, ray.origin.y, ray.origin.z};
    const double slope[3] = {inverse.x, inverse.y, inverse.z};
    const uint32_t high_first[3] = {std::signbit(inverse.x) ? 1u : 0u, std::signbit(inverse.y) ? 1u : 0u,
                                    std::signbit(inverse.z) ? 1u : 0u};
    struct Waiting {
        uint32_t node;
        double near;
        double far;
    };
    Waiting stack[most_depth + 36];
    int waiting = 0;
    // A treelet, and in the low four bits the node in it or (from 7 on) the child below it.
    uint32_t at = 0;
    for (;;) {
        const KdTreelet& treelet = treelets_[at >> 4];
        const uint32_t node = at & 15u;
        if (node < 7) {
            const int axis = treelet.axis(node);
            const double t = (static_cast<double>(treelet.plane[node]) - origin[axis]) * slope[axis];
            const double t_low = t * (1.0 - rounding);
            const double t_high = t * (1.0 + rounding);
            const uint32_t first = at + node + 1 + high_first[axis];
            const uint32_t second = at + node + 2 - high_first[axis];
            // A ray inside the plane gives NaN, which falls through to both children.
            if (t_low > far) {
                at = first;
            } else if (t_high < near) {
                at = second;
            } else {
                stack[waiting++] = {second, t_low > near ? t_low : near, far};
                if (t_high < far) far = t_high;
                at = first;
            }
            continue;
        }
        const uint32_t child = treelet.child[node - 7];
        if ((child & KdTreelet::leaf_bit) == 0) {
            at = child << 4;
            continue;
        }
        const uint32_t count = block_ * KdTreelet::block_count(child);
        if (count > 0 && leaf(references_.data() + block_ * KdTreelet::first_block(child), count)) return true;
        const double limit = t_max + t_max * hit_rounding;
        for (;;) {
            if (waiting == 0) return false;
            const Waiting& next = stack[--waiting];
            if (next.near > limit) continue;
            at = next.node;
            near = next.near;
            far = next.far < limit ? next.far : limit;
            break;
        }
    }
}

}  // namespace rb
