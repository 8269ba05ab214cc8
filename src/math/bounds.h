#pragma once
#include "math/transform.h"

#include <limits>

namespace rb {

/// An axis-aligned box; empty when lo > hi on an axis, unbounded where a side is infinite.
struct Bounds {
    Vec3 lo{std::numeric_limits<double>::infinity()};
    Vec3 hi{-std::numeric_limits<double>::infinity()};

    static Bounds everything() {
        constexpr double inf = std::numeric_limits<double>::infinity();
        return {Vec3{-inf}, Vec3{inf}};
    }
    bool is_empty() const { return lo.x > hi.x || lo.y > hi.y || lo.z > hi.z; }
    bool is_finite() const;
    Vec3 size() const { return hi - lo; }
    Vec3 center() const { return 0.5 * (lo + hi); }
    /// Half the surface; 0 for an empty box.
    double half_area() const;
    void include(const Vec3& p) {
        lo = glm::min(lo, p);
        hi = glm::max(hi, p);
    }
    void include(const Bounds& b) {
        lo = glm::min(lo, b.lo);
        hi = glm::max(hi, b.hi);
    }
    bool contains(const Vec3& p) const {
        return p.x >= lo.x && p.x <= hi.x && p.y >= lo.y && p.y <= hi.y && p.z >= lo.z && p.z <= hi.z;
    }
};

Bounds intersection(const Bounds& a, const Bounds& b);

/// The box of the eight transformed corners, rounded outward; everything() if `b` is not finite.
Bounds transformed(const Bounds& b, const Affine& map);

}  // namespace rb
