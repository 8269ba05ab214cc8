#pragma once
#include "patterns/image_field.h"

namespace rb {

/// The pattern of a `material_map` (manual 3.4.6.5): which of `count` textures a pixel's index or red names,
/// from 0 on.
PatternPtr material_map_pattern(ImageField field, size_t count);

}  // namespace rb
