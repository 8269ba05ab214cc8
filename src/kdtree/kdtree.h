#pragma once
#include "kdtree/box_f.h"
#include "math/ray.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <vector>

namespace rb {

struct KdOptions {
    double traversal_cost = 1.5;   ///< of one inner node, in units of one leaf block
    double element_cost = 1.0;     ///< of one leaf block of `block` elements
    int block = 4;                 ///< elements that cost as much as one (SIMD width, or cache lines)
    int sweep_below = 1 << 14;     ///< nodes with fewer elements look at every plane instead of bins
    double most_references = 3.0;  ///< hard bound on references per element
    int depth = -1;                ///< most levels; -1: 8 + 1.3 log2(n)
};

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

    /// Renumbers the elements in the order in which the cells hold them, so that neighbours lie together in
    /// memory; returns the old number of each new one (elements in no cell are gone).
    std::vector<uint32_t> renumber();

    bool is_empty() const { return nodes_.empty(); }
    const Bounds& bounds() const { return bounds_; }
    size_t node_count() const { return nodes_.size(); }
    size_t reference_count() const { return references_.size(); }
    size_t memory() const { return nodes_.size() * sizeof(Node) + references_.size() * sizeof(uint32_t); }

    /// Walks the cells that the ray meets between `t_min` and `t_max`, near to far, and calls
    /// `leaf(const uint32_t* elements, uint32_t count)` for each; `t_max` is read again after every call, so
    /// the leaf lowers it when it finds a hit. The walk ends early when the leaf returns true. Hits must be
    /// accepted wherever in the ray's interval they lie, also outside the cell.
    template <class Leaf>
    bool walk(const Ray& ray, double t_min, const double& t_max, Leaf&& leaf) const;

    /// Elements of the cell that holds `p`.
    std::pair<const uint32_t*, uint32_t> cell_of(const Vec3& p) const;

private:
    friend class KdBuilder;
    /// Inner: plane, and index of the low child (the high one follows); leaf: first reference, and count.
    struct Node {
        uint32_t plane_or_first;
        uint32_t link;  ///< axis (3: leaf) in the low two bits, child or count above
        bool is_leaf() const { return (link & 3u) == 3u; }
        int axis() const { return static_cast<int>(link & 3u); }
        uint32_t value() const { return link >> 2; }
        float plane() const { return std::bit_cast<float>(plane_or_first); }
    };

    bool clip_ray(const Ray& ray, const Vec3& inverse, double& near, double& far) const;

    std::vector<Node> nodes_;
    std::vector<uint32_t> references_;
    Bounds bounds_;
};

template <class Leaf>
bool KdTree::walk(const Ray& ray, double t_min, const double& t_max, Leaf&& leaf) const {
    if (nodes_.empty()) return false;
    const Vec3 inverse = 1.0 / ray.direction;
    // A hit at t_max itself may lie in a cell that rounding puts just behind it.
    constexpr double hit_rounding = 1e-13;
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
    Waiting stack[64];
    int waiting = 0;
    uint32_t at = 0;
    // Three roundings of the distance to a plane, at most 1.5 ulp each. Negative distances need no care: they
    // are before `near`, which never is negative, however they are rounded.
    constexpr double rounding = 8e-16;
    constexpr double down = 1.0 - rounding;
    constexpr double up = 1.0 + rounding;
    for (;;) {
        const Node node = nodes_[at];
        if (!node.is_leaf()) {
            const int axis = node.axis();
            const double t = (static_cast<double>(node.plane()) - origin[axis]) * slope[axis];
            const double t_low = t * down;
            const double t_high = t * up;
            const uint32_t low = node.value();
            const uint32_t first = low + high_first[axis];
            const uint32_t second = low + 1 - high_first[axis];
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
        if (node.value() > 0 && leaf(references_.data() + node.plane_or_first, node.value())) return true;
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
