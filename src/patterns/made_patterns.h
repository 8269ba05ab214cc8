#pragma once
#include "scene/function.h"
#include "scene/texture.h"

#include <functional>

namespace rb {

// Patterns whose argument is something that only the whole language can read, so they have no row in
// patterns.def; the front end makes them.

/// `function { expression }` (manual 3.4.7.1.16): f(x, y, z), folded above 1.
PatternPtr function_pattern(FunctionPtr function);

/// `pigment_pattern { PIGMENT }` (manual 3.4.7.1.25): the grey value of a pigment.
PatternPtr pigment_pattern(PigmentPtr pigment);

/// `object { OBJECT }` (manual 3.4.7.1.23): 1 inside, 0 outside; a list pattern of two with frequency 0.
using InsideTest = std::function<bool(const Vec3&)>;
PatternPtr object_pattern(InsideTest inside);

}  // namespace rb
