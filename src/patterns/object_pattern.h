#pragma once
#include "scene/pattern.h"

#include <functional>

namespace rb {

/// `object { OBJECT }` (manual 3.4.7.1.23): 1 inside, 0 outside; a list pattern of two with frequency 0. The
/// front end makes it, which alone can read objects, so it has no row in patterns.def.
using InsideTest = std::function<bool(const Vec3&)>;
PatternPtr object_pattern(InsideTest inside);

}  // namespace rb
