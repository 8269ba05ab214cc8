// plane { <normal>, distance }   (manual 3.5.4; the distance is measured along the unit normal)
#include "shapes/ray_shape.h"
#include "shapes/registry.h"

#include <fmt/format.h>

namespace rb {

namespace {

class Plane final : public RayShape<Plane> {
public:
    Plane(const Vec3& normal, double distance) : normal_(normal), distance_(distance) {
        for (int i = 0; i < 3; ++i) {
            if (std::abs(normal_[i]) == 1.0) axis_ = i;
        }
    }

    std::string_view keyword() const override { return "plane"; }
    Curvature curvature() const override { return Curvature::flat; }
    Bounds bounds() const override { return Bounds::everything(); }

    Bounds bounds_within(const Bounds& region) const override {
        Bounds flat = region;
        if (axis_ < 0) return flat;
        const double at = distance_ * normal_[axis_];
        const double slack = 4e-12 * std::abs(at);
        flat.lo[axis_] = std::max(flat.lo[axis_], at - slack);
        flat.hi[axis_] = std::min(flat.hi[axis_], at + slack);
        return flat;
    }

    Bounds solid_bounds() const override {
        Bounds half = Bounds::everything();
        if (axis_ < 0) return half;
        // inside() forgives some rounding.
        const double reach = distance_ + 4e-12 * std::abs(distance_);
        (normal_[axis_] > 0.0 ? half.hi : half.lo)[axis_] = reach * normal_[axis_];
        return half;
    }

    bool inside(const Vec3& p) const override {
        // The boundary belongs to the solid, within the rounding of a computed point.
        const Vec3 terms = normal_ * p;
        const double magnitude =
            std::abs(terms.x) + std::abs(terms.y) + std::abs(terms.z) + std::abs(distance_);
        return terms.x + terms.y + terms.z - distance_ <= 1e-12 * magnitude;
    }

    template <class Sink>
    void each_crossing(const ShapeRay& query, Sink&& sink) const {
        if (query.starts_on_surface) return;
        const double height = distance_ - glm::dot(normal_, query.ray.origin);
        if (std::abs(height) <= query.origin_error && query.origin_error > 0.0) return;
        const double slope = glm::dot(normal_, query.ray.direction);
        if (slope == 0.0) return;
        sink(height / slope, 0u, Vec2{0.0});
    }

    Vec3 normal(const Vec3&, const Crossing&) const override { return normal_; }

    void snap(const Crossing&, Vec3& p) const override {
        if (axis_ >= 0) p[axis_] = distance_ * normal_[axis_];
    }

    ShapePtr transformed(const Transform& map) const override {
        const Vec3 normal = glm::normalize(map.normal(normal_));
        return std::make_shared<Plane>(normal, glm::dot(normal, map.point(distance_ * normal_)));
    }

    bool as_plane(Vec3& normal, double& distance) const override {
        normal = normal_;
        distance = distance_;
        return true;
    }

    ShapePtr inverted() const override { return std::make_shared<Plane>(-normal_, -distance_); }

    std::optional<TriangleMesh> tessellate(double) const override { return std::nullopt; }

    std::string describe() const override {
        return fmt::format("normal <{},{},{}> distance {}", normal_.x, normal_.y, normal_.z, distance_);
    }

private:
    Vec3 normal_;  ///< unit
    double distance_;
    int axis_ = -1;  ///< of an axis-parallel normal
};

ShapePtr read(BlockReader& in) {
    const SourceRange at = in.where();
    const Vec3 normal = in.vec3();
    const double length = glm::length(normal);
    if (!(length > 0.0)) in.fail_at(at, "Degenerate plane normal.");
    return std::make_shared<Plane>(normal / length, in.number());
}

}  // namespace

namespace shapes {
extern const ShapeKind plane;
const ShapeKind plane{"plane", read, "plane { <0, 1, 0.2>, -0.4 }"};
}  // namespace shapes

}  // namespace rb
