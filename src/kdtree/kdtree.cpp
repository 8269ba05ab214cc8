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

}  // namespace rb
