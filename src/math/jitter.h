#pragma once
#include "math/vec.h"

namespace rb {

/// The reference's repeatable jitter at a picture position: both components in [-0.5, 0.5) (shading
/// spec 12.2).
Vec2 position_jitter(double x, double y);

}  // namespace rb
