// disc { <center>, <normal>, radius [, hole radius] }   (manual 3.5.2.3)
#include "shapes/frame.h"
#include "shapes/ray_shape.h"
#include "shapes/registry.h"
#include "shapes/revolve.h"

#include <fmt/format.h>

namespace rb {

namespace {

class Disc final : public RayShape<Disc> {
public:
    Disc(const Frame& frame, double radius, double hole)
        : frame_(frame), radius_(std::abs(radius)), hole_(std::abs(hole)) {}

    std::string_view keyword() const override { return "disc"; }
    Curvature curvature() const override { return Curvature::flat; }
    Bounds bounds() const override {
        const Bounds box = frame_.circle_bounds(radius_, 0.0);
        const Vec3 pad = 4.0 * std::numeric_limits<double>::epsilon() * (glm::abs(box.lo) + glm::abs(box.hi));
        return {box.lo - pad, box.hi + pad};
    }
    Bounds solid_bounds() const override { return Bounds::everything(); }
    Bounds language_extent() const override {
        constexpr double half_thickness = 0.001;
        return rb::transformed(
            Bounds{{-radius_, -radius_, -half_thickness}, {radius_, radius_, half_thickness}},
            frame_.object_from_local.forward);
    }
    bool inside(const Vec3& p) const override { return frame_.local_point(p).z < 0.0; }

    template <class Sink>
    void each_crossing(const ShapeRay& query, Sink&& sink) const {
        if (query.starts_on_surface) return;
        const Vec3 o = frame_.local_point(query.ray.origin);
        if (query.origin_error > 0.0 && std::abs(o.z) <= query.origin_error * frame_.axial_stretch) return;
        const Vec3 d = frame_.local_direction(query.ray.direction);
        if (d.z == 0.0) return;
        const double t = -o.z / d.z;
        const double x = o.x + t * d.x;
        const double y = o.y + t * d.y;
        const double rr = x * x + y * y;
        if (rr <= radius_ * radius_ && rr >= hole_ * hole_) sink(t, 0u, Vec2{0.0});
    }

    Vec3 normal(const Vec3&, const Crossing&) const override { return frame_.normal({0, 0, 1}); }

    ShapePtr transformed(const Transform& map) const override {
        return std::make_shared<Disc>(Frame(then(frame_.object_from_local, map)), radius_, hole_);
    }

    std::optional<TriangleMesh> tessellate(double tolerance) const override {
        if (!(radius_ > hole_)) return TriangleMesh{};
        const double scale = stretch(frame_.object_from_local.forward);
        const int turns = turn_segments(radius_, tolerance / scale);
        TriangleMesh mesh =
            revolve({{radius_, 0.0}, {hole_, 0.0}}, false, turns, frame_.object_from_local.forward);
        mesh.error += scale * radius_ * (1.0 - std::cos(pi / turns));
        return mesh;
    }

    std::string describe() const override {
        const Vec3 c = frame_.object_from_local.forward.row[3];
        return fmt::format("center <{},{},{}> radius {} hole {}", c.x, c.y, c.z, radius_, hole_);
    }

private:
    Frame frame_;
    double radius_;
    double hole_;
};

ShapePtr read(BlockReader& in) {
    const Vec3 center = in.vec3();
    const SourceRange at = in.where();
    const Vec3 normal = in.vec3();
    const double length = glm::length(normal);
    if (!(length > 0.0)) in.fail_at(at, "Degenerate disc normal.");
    const double radius = in.number();
    const double hole = in.at_number() ? in.number() : 0.0;
    return std::make_shared<Disc>(axial_frame(center, normal / length, 1.0), radius, hole);
}

}  // namespace

namespace shapes {
extern const ShapeKind disc;
const ShapeKind disc{"disc", read, "disc { <0.1, 0.2, -0.1>, <0.3, 1, 0.2>, 0.8, 0.3 }"};
}  // namespace shapes

}  // namespace rb
