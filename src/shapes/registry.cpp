#include "shapes/registry.h"

#include <array>

namespace rb {

namespace shapes {
#define RB_SHAPE(name) extern const ShapeKind name;
#include "shapes/shapes.def"
#undef RB_SHAPE
}  // namespace shapes

std::span<const ShapeKind* const> all_shapes() {
    static constexpr std::array kinds{
#define RB_SHAPE(name) &shapes::name,
#include "shapes/shapes.def"
#undef RB_SHAPE
    };
    return kinds;
}

const ShapeKind* find_shape(std::string_view keyword) {
    for (const ShapeKind* kind : all_shapes()) {
        if (kind->keyword == keyword) return kind;
    }
    return nullptr;
}

}  // namespace rb
