#pragma once
#include "scene/shape.h"

#include <functional>

namespace rb {

/// The closed mesh of the zeros within `box` of a function that is positive outside, by marching tetrahedra
/// on a grid of cubes with sides of `cell`. Nothing is known of its error.
TriangleMesh marched_mesh(const std::function<double(const Vec3&)>& value, const Bounds& box, double cell);

}  // namespace rb
