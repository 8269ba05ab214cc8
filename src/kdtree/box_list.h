#pragma once
#include "kdtree/box_tree.h"
#include "math/ray_bundle.h"

#include <array>

namespace rb {

/// The elements of a box tree that a bundle of rays may meet, if they are few: its rays try these one by one
/// instead of walking the tree.
class BoxList {
public:
    static constexpr size_t most = 16;

    static constexpr uint32_t no_element = BoxTree::element_bit - 1;

    /// Lists the elements but `without`. False (and the list is useless) if there are more than `most`, or if
    /// they lie all over the tree.
    bool gather(const BoxTree& tree, const RayBundle& bundle, RayMask mask, uint32_t without);

    /// Keeps of another list what a narrower bundle may meet.
    void gather(const BoxList& wider, const RayBundle& bundle, uint32_t without);

    bool is_empty() const { return count_ == 0; }

    /// As BoxTree::walk(), for a ray of the bundle; one or two elements are visited whatever their boxes.
    template <class Visit>
    bool walk(const Ray& ray, RayMask mask, double t_min, const double& t_max, Visit&& visit) const;

private:
    using Node = BoxTree::Node;
    void add(const Node& node, size_t lane, float near);
    void close();

    Vec3 center_{0.0};
    float reach_ = 0;
    size_t count_ = 0;
    std::array<Node, most / 4> nodes_;  ///< filled lane by lane, about from near to far
    std::array<float, most> near_;
};

template <class Visit>
bool BoxList::walk(const Ray& ray, RayMask mask, double t_min, const double& t_max, Visit&& visit) const {
    if (count_ <= 2) {
        for (size_t i = 0; i < count_; ++i) {
            if ((nodes_[0].mask[i] & mask) != 0 && visit(nodes_[0].child[i] & ~BoxTree::element_bit))
                return true;
        }
        return false;
    }
    const BoxRay slabs(ray, center_, reach_);
    const float near = slabs.scaled_down(t_min);
    for (size_t k = 0; 4 * k < count_; ++k) {
        const Node& node = nodes_[k];
        alignas(16) float near_of[4];
        unsigned met = slabs.meets(node.planes, near, slabs.scaled_up(t_max), near_of);
        for (; met != 0; met &= met - 1) {
            const int i = std::countr_zero(met);
            if ((node.mask[i] & mask) == 0 || near_of[i] > slabs.scaled_up(t_max)) continue;
            if (visit(node.child[i] & ~BoxTree::element_bit)) return true;
        }
    }
    return false;
}

}  // namespace rb
