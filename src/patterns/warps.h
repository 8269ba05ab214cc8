#pragma once
#include "scene/pattern.h"

#include <span>

namespace rb {

/// Carries points through one element of a warp chain (manual 3.4.7.3); the last step of evaluating a chain
/// is `limit_coordinates`.
void warp_points(const Warp& warp, std::span<Vec3> points);

/// Coordinates are kept within it after a chain, as the reference does.
inline constexpr double coordinate_limit = 1e17;
void limit_coordinates(std::span<Vec3> points);

}  // namespace rb
