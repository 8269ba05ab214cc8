// sphere { <center>, radius }   (manual 3.5.1.1)
#include "shapes/ray_shape.h"
#include "shapes/registry.h"
#include "shapes/revolve.h"

#include <fmt/format.h>

namespace rb {

namespace {

class Sphere final : public RayShape<Sphere> {
public:
    Sphere(const Vec3& center, double radius, std::shared_ptr<const Affine> local_from_object = nullptr)
        : center_(center), radius_(std::abs(radius)), local_(std::move(local_from_object)) {}

    std::string_view keyword() const override { return "sphere"; }
    Curvature curvature() const override { return Curvature::convex; }
    bool is_convex_body() const override { return true; }
    Bounds bounds() const override { return {center_ - radius_, center_ + radius_}; }

    bool fills_ball() const override { return true; }

    bool inside(const Vec3& p) const override {
        const Vec3 q = p - center_;
        return glm::dot(q, q) < radius_ * radius_;
    }

    template <class Sink>
    void each_crossing(const ShapeRay& query, Sink&& sink) const {
        // Closest approach form: nothing cancels however far the origin is.
        const Vec3& d = query.ray.direction;
        const double inverse_dd = 1.0 / glm::dot(d, d);
        const Vec3 from = query.ray.origin - center_;
        const double middle = -glm::dot(from, d) * inverse_dd;
        const Vec3 foot = from + middle * d;
        const double chord = radius_ * radius_ - glm::dot(foot, foot);
        if (starts_here(query, from)) {
            // One root is 0, so the other is their sum.
            sink(2.0 * middle, 0u, Vec2{0.0});
            return;
        }
        if (!(chord > 0.0)) return;
        const double half = std::sqrt(chord * inverse_dd);
        sink(middle - half, 0u, Vec2{0.0});
        sink(middle + half, 0u, Vec2{0.0});
    }

    Vec3 normal(const Vec3& p, const Crossing&) const override { return p - center_; }

    std::optional<Vec2> uv(const Vec3& p, const Crossing&) const override {
        Vec3 q = p - center_;
        if (local_) q = local_->direction(q);
        q = glm::normalize(q);
        const double v = 0.5 + std::asin(glm::clamp(q.y, -1.0, 1.0)) / pi;
        if (q.x * q.x + q.z * q.z <= 1e-10) return Vec2{0.0, v};
        if (q.z == 0.0) return Vec2{q.x > 0.0 ? 0.0 : 0.5, v};
        return Vec2{turn_share(q.x, q.z), v};
    }

    ShapePtr transformed(const Transform& map) const override {
        const double scale = similarity_scale(map.forward);
        if (scale == 0.0) return nullptr;
        const bool turned = map.forward.row[0] != Vec3{scale, 0, 0} ||
                            map.forward.row[1] != Vec3{0, scale, 0} ||
                            map.forward.row[2] != Vec3{0, 0, scale};
        std::shared_ptr<const Affine> local = local_;
        if (turned) local = std::make_shared<Affine>(then(map.backward, local_ ? *local_ : Affine{}));
        return std::make_shared<Sphere>(map.point(center_), radius_ * scale, std::move(local));
    }

    std::optional<TriangleMesh> tessellate(double tolerance) const override {
        if (!(radius_ > 0.0)) return TriangleMesh{};
        Affine place;
        place.row[3] = center_;
        return round_mesh({0.0, radius_, tolerance}, place);
    }

    std::string describe() const override {
        return fmt::format("center <{},{},{}> radius {}", center_.x, center_.y, center_.z, radius_);
    }

private:
    bool starts_here(const ShapeRay& query, const Vec3& from) const {
        if (query.starts_on_surface) return true;
        return query.origin_error > 0.0 && std::abs(glm::length(from) - radius_) <= query.origin_error;
    }

    Vec3 center_;
    double radius_;
    std::shared_ptr<const Affine> local_;  ///< turns back what transformations turned: uv only
};

ShapePtr read(BlockReader& in) {
    const Vec3 center = in.vec3();
    const double radius = in.number();
    return std::make_shared<Sphere>(center, radius);
}

}  // namespace

namespace shapes {
extern const ShapeKind sphere;
const ShapeKind sphere{"sphere", read, "sphere { <0.3, -0.2, 0.1>, 0.7 }"};
}  // namespace shapes

}  // namespace rb
