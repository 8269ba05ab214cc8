#include "scene/shape.h"

namespace rb {

bool Shape::closest(const ShapeRay& ray, const CrossingFilter* filter, Crossing& nearest) const {
    Crossings all;
    crossings(ray, all);
    bool found = false;
    for (size_t i = 0; i < all.size(); ++i) {
        if (found && all[i].t > nearest.t) continue;
        if (filter && !filter->counts(all[i])) continue;
        nearest = all[i];
        found = true;
    }
    return found;
}

std::optional<Vec2> Shape::uv(const Vec3&, const Crossing&) const { return std::nullopt; }

Extent Shape::extent(const Vec3& direction) const {
    Bounds box = solid_bounds();
    box.include(bounds());
    if (!box.is_finite() || box.is_empty()) return {};
    const double middle = glm::dot(box.center(), direction);
    const double half = 0.5 * glm::dot(box.size(), glm::abs(direction));
    return {middle - half, middle + half};
}

std::shared_ptr<const Shape> Shape::transformed(const Transform&) const { return nullptr; }

}  // namespace rb
