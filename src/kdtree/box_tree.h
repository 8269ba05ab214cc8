#pragma once
#include "kdtree/box_ray.h"
#include "kdtree/walk_stack.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

namespace rb {

/// A hierarchy of boxes, four to a node; elements are its leaves, so every element's own box is tested.
class BoxTree {
public:
    struct Item {
        Bounds box;  ///< finite and not empty
        RayMask mask = 0;
    };

    BoxTree() = default;
    explicit BoxTree(std::span<const Item> items);

    bool is_empty() const { return nodes_.empty(); }
    /// The item of each element: elements are numbered so that neighbours lie together in memory.
    const std::vector<uint32_t>& order() const { return order_; }

    /// Calls `visit(element)` for the elements with a bit of `mask` whose boxes the ray may meet between
    /// `t_min` (not negative) and `t_max`, about from near to far; `t_max` is read again after every call.
    /// Ends early when `visit` returns true.
    template <class Visit>
    bool walk(const Ray& ray, RayMask mask, double t_min, const double& t_max, Visit&& visit) const;
    /// The same for the elements whose boxes may hold a point.
    template <class Visit>
    bool walk_at(const Vec3& p, RayMask mask, Visit&& visit) const {
        constexpr double here = 0.0;
        return walk({p, Vec3{1, 0, 0}}, mask, here, here, visit);
    }

private:
    friend class BoxTreeBuilder;
    friend class BoxList;
    static constexpr uint32_t element_bit = 1u << 31;
    struct alignas(64) Node {
        float planes[3][2][4];
        uint32_t child[4];  ///< a node, or with `element_bit` an element
        RayMask mask[4];    ///< of all below

        unsigned lanes_with(RayMask wanted) const {
            unsigned lanes = 0;
            for (unsigned i = 0; i < 4; ++i) lanes |= static_cast<unsigned>((mask[i] & wanted) != 0) << i;
            return lanes;
        }
    };

    std::vector<Node> nodes_;
    std::vector<uint32_t> order_;
    Vec3 center_{0.0};
    float reach_ = 0;
    RayMask common_mask_ = 0xffff;  ///< bits that every element has
};

template <class Visit>
bool BoxTree::walk(const Ray& ray, RayMask mask, double t_min, const double& t_max, Visit&& visit) const {
    if (nodes_.empty()) return false;
    const BoxRay slabs(ray, center_, reach_);
    const float near = slabs.scaled_down(t_min);
    float far = slabs.scaled_up(t_max);
    const bool selects = (common_mask_ & mask) == 0;
    WalkStack<256> stack;
    uint32_t at = 0;
    for (;;) {
        const Node& node = nodes_[at];
        alignas(16) float near_of[4];
        unsigned met = slabs.meets(node.planes, near, far, near_of);
        if (selects) met &= node.lanes_with(mask);
        if (met != 0) {
            at = stack.push(node.child, met, near_of);
        } else if (!stack.pop(far, at)) {
            return false;
        }
        while (at & element_bit) {
            if (visit(at & ~element_bit)) return true;
            far = slabs.scaled_up(t_max);
            if (!stack.pop(far, at)) return false;
        }
    }
}

}  // namespace rb
