// polygon { n, <p1>, ... }   (manual 3.5.2.5)
#include "shapes/outline.h"
#include "shapes/ray_shape.h"
#include "shapes/region_mesh.h"
#include "shapes/registry.h"

#include <cmath>

#include <fmt/format.h>

namespace rb {

namespace {

/// What the language's box is: the hull, thickened where it is flat.
Bounds thickened(Bounds box) {
    constexpr double least = 0.001;
    for (int axis = 0; axis < 3; ++axis) {
        if (box.hi[axis] - box.lo[axis] >= least) continue;
        box.lo[axis] -= least;
        box.hi[axis] += least;
    }
    return box;
}

/// A region of the plane z = 0 of its frame. Without an outline it is degenerate: never hit.
class Polygon final : public RayShape<Polygon> {
public:
    Polygon(std::shared_ptr<const Outline> outline, const Transform& object_from_local, const Bounds& extent)
        : outline_(std::move(outline)), object_from_local_(object_from_local), extent_(extent) {
        const auto& r = object_from_local_.backward.row;
        steepness_ = std::hypot(r[0].z, r[1].z, r[2].z);
        if (!outline_) return;
        for (const CurvePiece& piece : outline_->pieces()) {
            const Vec2& p = piece.start();
            box_.include(object_from_local_.point({p.x, p.y, 0.0}));
        }
        const Vec3 pad =
            8.0 * std::numeric_limits<double>::epsilon() * (glm::abs(box_.lo) + glm::abs(box_.hi));
        box_ = {box_.lo - pad, box_.hi + pad};
    }

    std::string_view keyword() const override { return "polygon"; }
    Curvature curvature() const override { return Curvature::flat; }
    Bounds bounds() const override { return box_; }
    Bounds language_extent() const override { return extent_; }
    bool inside(const Vec3&) const override { return false; }
    bool is_patch() const override { return true; }

    template <class Sink>
    void each_crossing(const ShapeRay& query, Sink&& sink) const {
        if (query.starts_on_surface || !outline_) return;
        const Vec3 o = object_from_local_.inverse_point(query.ray.origin);
        if (query.origin_error > 0.0 && std::abs(o.z) <= query.origin_error * steepness_) return;
        const Vec3 d = object_from_local_.inverse_direction(query.ray.direction);
        if (d.z == 0.0) return;
        const double t = -o.z / d.z;
        if (!(t > query.t_min && t <= sink.reach())) return;
        if (outline_->contains({o.x + t * d.x, o.y + t * d.y})) sink(t, 0u, Vec2{0.0});
    }

    Vec3 normal(const Vec3&, const Crossing&) const override { return object_from_local_.normal({0, 0, 1}); }

    ShapePtr transformed(const Transform& map) const override {
        return std::make_shared<Polygon>(outline_, then(object_from_local_, map),
                                         rb::transformed(extent_, map.forward));
    }

    std::optional<TriangleMesh> tessellate(double) const override {
        TriangleMesh mesh;
        if (!outline_) return mesh;
        const RegionMesh region = triangulate(outline_->flattened(1.0));
        double largest = 0;
        for (const Vec2& p : region.points) {
            const Vec3 v = object_from_local_.point({p.x, p.y, 0.0});
            largest = std::max(largest, max_component(glm::abs(v)));
            mesh.vertices.emplace_back(v);
        }
        const Vec3 n = normal({}, {});
        for (const auto& t : region.triangles) {
            const Vec3 a(mesh.vertices[t[0]]), b(mesh.vertices[t[1]]), c(mesh.vertices[t[2]]);
            const bool turned = glm::dot(glm::cross(c - a, b - a), n) < 0.0;
            mesh.faces.push_back(turned ? std::array<uint32_t, 3>{t[0], t[2], t[1]} : t);
        }
        constexpr double rounding = 2.5e-7;
        mesh.error = rounding * largest;
        return mesh;
    }

    std::string describe() const override {
        return fmt::format("{} corners", outline_ ? outline_->pieces().size() : 0);
    }

private:
    std::shared_ptr<const Outline> outline_;
    Transform object_from_local_;
    Bounds extent_;
    Bounds box_;
    double steepness_;  ///< how far local z changes along one unit of the object at most
};

bool same(const Vec3& a, const Vec3& b) {
    constexpr double tolerance = 1e-10;
    return max_component(glm::abs(a - b)) < tolerance;
}

/// The polygon's own frame; empty if the points lie on a line.
std::optional<Transform> frame_of(const std::vector<Vec3>& points) {
    const Vec3 origin = points[0];
    constexpr double apart = 1e-5;
    Vec3 u{0.0};
    Vec3 w{0.0};
    for (const Vec3& p : points) {
        const Vec3 v = p - origin;
        if (glm::length(v) < apart) continue;
        if (u == Vec3{0.0}) {
            u = glm::normalize(v);
            continue;
        }
        w = glm::cross(u, glm::normalize(v));
        if (glm::dot(w, w) >= apart * apart) break;
        w = Vec3{0.0};
    }
    if (w == Vec3{0.0}) return std::nullopt;
    const Vec3 z = glm::normalize(w);
    const Vec3 y = glm::cross(z, u);
    Transform frame;
    frame.forward.row = {u, y, z, origin};
    frame.backward.row = {Vec3{u.x, y.x, z.x}, Vec3{u.y, y.y, z.y}, Vec3{u.z, y.z, z.z}, Vec3{0.0}};
    frame.backward.row[3] = -frame.backward.direction(origin);
    return frame;
}

std::shared_ptr<const Outline> outline_of(const std::vector<Vec3>& points, const Transform& frame,
                                          bool& closed) {
    std::vector<Vec2> flat;
    for (const Vec3& p : points) {
        const Vec3 q = frame.inverse_point(p);
        // The language takes a polygon that leaves its plane by more for none.
        constexpr double tolerance = 1e-10;
        if (std::abs(q.z) > tolerance) return nullptr;
        flat.emplace_back(q.x, q.y);
    }
    std::vector<CurvePiece> pieces;
    size_t first = 0;
    closed = false;
    for (size_t i = 1; i < points.size(); ++i) {
        closed = i > first && same(points[i], points[first]);
        pieces.push_back({{flat[i - 1], closed ? flat[first] : flat[i]}, 1});
        if (closed) first = ++i;
    }
    if (!closed && first + 1 < points.size()) pieces.push_back({{flat.back(), flat[first]}, 1});
    return std::make_shared<Outline>(std::move(pieces));
}

ShapePtr read(BlockReader& in) {
    const SourceRange at = in.where();
    const int count = in.integer();
    if (count < 3) in.fail_at(at, "Polygon needs at least three points.");
    std::vector<Vec3> points;
    Bounds hull;
    for (int i = 0; i < count; ++i) {
        points.push_back(in.vec3());
        hull.include(points.back());
    }
    bool closed = true;
    std::shared_ptr<const Outline> outline;
    const auto frame = frame_of(points);
    if (frame) outline = outline_of(points, *frame, closed);
    if (!closed) in.diagnostics().warning(in.block_where(), "Polygon not closed. Closing it.");
    return std::make_shared<Polygon>(std::move(outline), frame.value_or(Transform{}), thickened(hull));
}

}  // namespace

namespace shapes {
extern const ShapeKind polygon;
const ShapeKind polygon{"polygon", read,
                        "polygon { 9, <-0.6,-0.5>, <0.6,-0.5>, <0.5,0.6>, <-0.6,0.6>, <-0.6,-0.5>, "
                        "<-0.2,-0.2>, <0.3,-0.1>, <0,0.3>, <-0.2,-0.2> }"};
}  // namespace shapes

}  // namespace rb
