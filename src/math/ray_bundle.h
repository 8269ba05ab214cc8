#pragma once
#include "math/bounds.h"
#include "math/ray.h"

namespace rb {

/// Rays that run side by side. At parameter s, from 0 to `far`, each is within the box between
/// `origins.lo + s * lower` and `origins.hi + s * upper`.
struct RayBundle {
    Bounds origins;
    Vec3 lower{0.0};
    Vec3 upper{0.0};
    double far = 0;

    /// Endless rays with directions within a box.
    static RayBundle along(const Bounds& origins, const Bounds& directions) {
        return {origins, directions.lo, directions.hi, std::numeric_limits<double>::infinity()};
    }
    /// Line segments from one box to another.
    static RayBundle between(const Bounds& origins, const Bounds& ends) {
        return {origins, ends.lo - origins.lo, ends.hi - origins.hi, 1.0};
    }

    /// True if all rays stay for sure on one side of the plane, or are parallel to it outside.
    bool misses_plane(const Vec3& normal, double distance) const;
};

}  // namespace rb
