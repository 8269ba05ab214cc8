#pragma once
#include "math/vec.h"

namespace rb {

/// Kinds of rays, one bit each: what a thing can be met by, and what a ray asks for.
using RayMask = uint16_t;

/// A half-line. `direction` is unit length in world space; in object space it keeps the length that the
/// transform gave it, so that `t` means the same point in both spaces.
struct Ray {
    Vec3 origin{0.0};
    Vec3 direction{0.0, 0.0, 1.0};

    Vec3 at(double t) const { return origin + t * direction; }
};

}  // namespace rb
