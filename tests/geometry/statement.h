#pragma once
#include "base/diagnostics.h"
#include "block/block.h"
#include "scene/object.h"

#include <string_view>

namespace rb {

/// Reads one object statement through the shapes' readers: numbers, vectors, nested blocks, CSG,
/// transformations, `inverse`, `clipped_by`, `bounded_by`. The language itself is not needed for it (and not
/// used).
ObjectPtr object_from(std::string_view text);

/// The same text as a block.
std::shared_ptr<const Block> block_from(std::string_view text);

/// One plain opaque texture.
TexturePtr plain_texture();

}  // namespace rb
