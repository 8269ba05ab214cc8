#pragma once
#include "block/reader.h"
#include "math/bounds.h"
#include "math/ray.h"

namespace rb {

/// `contained_by { box { ... } | sphere { ... } }`.
struct Container {
    Bounds box{Vec3{-1.0}, Vec3{1.0}};  ///< around the sphere, if it is one
    std::optional<double> radius;       ///< of a sphere

    /// True for a point within, not nearer to the rim than `margin`.
    bool holds(const Vec3& p, double margin) const;

    /// Narrows [from, to] to the ray's way within; false if nothing is left.
    bool clip(const Ray& ray, double& from, double& to) const;
};

/// Takes the block, which must be next.
Container take_container(BlockReader& in);

}  // namespace rb
