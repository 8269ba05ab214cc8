#include "kdtree/kdtree.h"

#include <algorithm>

namespace rb {

BoxF rounded_outward(const Bounds& b) {
    BoxF out{};
    constexpr float inf = std::numeric_limits<float>::infinity();
    for (int i = 0; i < 3; ++i) {
        auto lo = static_cast<float>(b.lo[i]);
        auto hi = static_cast<float>(b.hi[i]);
        if (static_cast<double>(lo) > b.lo[i]) lo = std::nextafter(lo, -inf);
        if (static_cast<double>(hi) < b.hi[i]) hi = std::nextafter(hi, inf);
        out.lo[i] = lo;
        out.hi[i] = hi;
    }
    return out;
}

bool KdTree::clip_ray(const Ray& ray, const Vec3& inverse, double& near, double& far) const {
    constexpr double rounding = 8e-16;
    for (int axis = 0; axis < 3; ++axis) {
        double a = (bounds_.lo[axis] - ray.origin[axis]) * inverse[axis];
        double b = (bounds_.hi[axis] - ray.origin[axis]) * inverse[axis];
        if (std::signbit(inverse[axis])) std::swap(a, b);
        constexpr double most = std::numeric_limits<double>::max();
        a -= std::min(std::abs(a) * rounding, most);
        b += std::min(std::abs(b) * rounding, most);
        // NaN (a ray inside a face plane) leaves the interval as it is.
        if (a > near) near = a;
        if (b < far) far = b;
        if (near > far) return false;
    }
    return true;
}

std::vector<uint32_t> KdTree::renumber() {
    uint32_t count = 0;
    for (const uint32_t element : references_) count = std::max(count, element + 1);
    constexpr uint32_t unseen = std::numeric_limits<uint32_t>::max();
    std::vector<uint32_t> new_number(count, unseen);
    std::vector<uint32_t> old_number;
    for (uint32_t& element : references_) {
        if (new_number[element] == unseen) {
            new_number[element] = static_cast<uint32_t>(old_number.size());
            old_number.push_back(element);
        }
        element = new_number[element];
    }
    return old_number;
}

std::pair<const uint32_t*, uint32_t> KdTree::cell_of(const Vec3& p) const {
    if (nodes_.empty() || !bounds_.contains(p)) return {nullptr, 0};
    uint32_t at = 0;
    while (!nodes_[at].is_leaf()) {
        const Node& node = nodes_[at];
        at = node.value() + (p[node.axis()] > static_cast<double>(node.plane()) ? 1u : 0u);
    }
    return {references_.data() + nodes_[at].plane_or_first, nodes_[at].value()};
}

}  // namespace rb
