#pragma once
#include "math/vec.h"

#include <cmath>

namespace rb {

/// 0 to 2: the axis of the largest of three lengths; of equal ones the first.
inline int longest_axis(const Vec3& lengths) {
    if (lengths.x >= lengths.y && lengths.x >= lengths.z) return 0;
    return lengths.y >= lengths.z ? 1 : 2;
}

/// Two unit vectors that stand on a unit vector and on each other (Frisvad 2012, revised by Duff et al. 2017,
/// "Building an Orthonormal Basis, Revisited").
struct Across {
    explicit Across(const Vec3& axis) {
        const double sign = std::copysign(1.0, axis.z);
        const double a = -1.0 / (sign + axis.z);
        const double b = axis.x * axis.y * a;
        first = {1.0 + sign * axis.x * axis.x * a, sign * b, -sign * axis.x};
        second = {b, sign + axis.y * axis.y * a, -axis.y};
    }
    /// From the first by an angle toward the second.
    Vec3 at(double turn) const { return std::cos(turn) * first + std::sin(turn) * second; }

    Vec3 first;
    Vec3 second;
};

}  // namespace rb
