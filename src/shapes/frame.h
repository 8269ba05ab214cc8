#pragma once
#include "math/bounds.h"
#include "math/transform.h"

#include <cmath>

namespace rb {

/// Where a shape that is simple in its own frame stands in the object: it takes any affine map on top into
/// its own numbers.
struct Frame {
    Transform object_from_local;
    double radial_stretch =
        1;  ///< bounds on how lengths grow from object to local, across and along the z axis
    double axial_stretch = 1;

    explicit Frame(const Transform& map) : object_from_local(map) {
        const auto& r = map.backward.row;
        const auto column = [&](int i) { return std::hypot(r[0][i], r[1][i], r[2][i]); };
        radial_stretch = std::hypot(column(0), column(1));
        axial_stretch = column(2);
    }

    Vec3 local_point(const Vec3& p) const { return object_from_local.inverse_point(p); }
    Vec3 local_direction(const Vec3& d) const { return object_from_local.inverse_direction(d); }
    Vec3 normal(const Vec3& local) const { return object_from_local.normal(local); }

    /// The tight box of the circle of `radius` at height z.
    Bounds circle_bounds(double radius, double z) const {
        const auto& r = object_from_local.forward.row;
        const Vec3 center = r[3] + z * r[2];
        Vec3 half;
        for (int i = 0; i < 3; ++i) half[i] = std::abs(radius) * std::hypot(r[0][i], r[1][i]);
        return {center - half, center + half};
    }
};

/// Unit vectors x, y so that (x, y, z) is orthogonal, for a unit z.
inline void orthogonal_axes(const Vec3& z, Vec3& x, Vec3& y) {
    const Vec3 other = std::abs(z.x) < 0.5 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
    x = glm::normalize(glm::cross(z, other));
    y = glm::cross(z, x);
}

/// The frame with its z axis from `origin` along `axis` (|axis| = one local unit) and `radius` across.
inline Frame axial_frame(const Vec3& origin, const Vec3& axis, double radius) {
    Vec3 x;
    Vec3 y;
    const double length = glm::length(axis);
    orthogonal_axes(axis / length, x, y);
    Transform map;
    map.forward.row = {radius * x, radius * y, axis, origin};
    // The axes are orthogonal, so the inverse is the transpose over the squared lengths.
    const Vec3 bx = x / radius;
    const Vec3 by = y / radius;
    const Vec3 bz = axis / (length * length);
    map.backward.row = {Vec3{bx.x, by.x, bz.x}, Vec3{bx.y, by.y, bz.y}, Vec3{bx.z, by.z, bz.z}, Vec3{0.0}};
    map.backward.row[3] = -map.backward.direction(origin);
    return Frame(map);
}

}  // namespace rb
