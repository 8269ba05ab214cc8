#pragma once
#include "block/reader.h"
#include "scene/shape.h"

#include <span>
#include <string_view>

namespace rb {

/// One shape of the language. Adding a shape: `shapes/<keyword>.cpp` with its ShapeKind, one row in
/// shapes.def, one scene.
struct ShapeKind {
    std::string_view keyword;
    /// Reads the shape's own arguments; object modifiers follow and are not its business.
    ShapePtr (*read)(BlockReader& in);
    /// A small valid statement; every property test runs on it.
    std::string_view example;
};

std::span<const ShapeKind* const> all_shapes();

/// Null if the keyword is no shape.
const ShapeKind* find_shape(std::string_view keyword);

}  // namespace rb
