#include "scene/shape.h"

namespace rb {

std::optional<Vec2> Shape::uv(const Vec3&, const Crossing&) const { return std::nullopt; }

std::shared_ptr<const Shape> Shape::transformed(const Transform&) const { return nullptr; }

}  // namespace rb
