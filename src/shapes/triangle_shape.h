#pragma once
#include "block/reader.h"
#include "scene/shape.h"

namespace rb {

/// The arguments of triangle (three points) and smooth_triangle (three points, each with its normal).
ShapePtr read_triangle(BlockReader& in, bool smooth);

}  // namespace rb
