#include "shapes/triangle_shape.h"

#include "shapes/ray_shape.h"
#include "shapes/woop.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

namespace rb {

namespace {

using Corners = std::array<Vec3, 3>;

Vec3 face_normal(const Corners& p) { return glm::cross(p[2] - p[0], p[1] - p[0]); }

int dominant_axis(const Vec3& n) {
    const Vec3 a = glm::abs(n);
    return a.x > a.y ? (a.x > a.z ? 0 : 2) : (a.y > a.z ? 1 : 2);
}

/// One triangle; with normals the smooth kind. The face normal follows the order of the vertices as they were
/// written, but every transformation takes it from the language's inner order again (spec: geometry 10.1).
class Triangle final : public RayShape<Triangle> {
public:
    Triangle(const Corners& points, const Vec3& normal, const std::optional<Corners>& normals)
        : points_(points), normals_(normals), normal_(normal) {
        // Inner order: the dominant component of the vertices' own normal is -x, +y or -z.
        const Vec3 own = face_normal(points_);
        const int axis = dominant_axis(own);
        const bool swapped = axis == 1 ? own.y < 0.0 : own[axis] > 0.0;
        if (swapped) {
            std::swap(points_[0], points_[1]);
            if (normals_) std::swap((*normals_)[0], (*normals_)[1]);
        }
        degenerate_ = own == Vec3{0.0} || (normals_ && !same_side());
    }

    std::string_view keyword() const override { return normals_ ? "smooth_triangle" : "triangle"; }
    Curvature curvature() const override { return Curvature::flat; }
    NormalRule normal_rule() const override {
        return normals_ ? NormalRule::interpolated : NormalRule::of_surface;
    }
    Bounds bounds() const override {
        Bounds box;
        if (degenerate_) return box;
        for (const Vec3& p : points_) box.include(p);
        return box;
    }
    bool inside(const Vec3&) const override { return false; }
    bool is_patch() const override { return true; }
    bool is_faceted() const override { return true; }
    bool is_degenerate() const { return degenerate_; }

    template <class Sink>
    void each_crossing(const ShapeRay& query, Sink&& sink) const {
        if (query.starts_on_surface || degenerate_) return;
        TriangleHit hit;
        if (!WoopRay(query.ray).hits(points_[0], points_[1], points_[2], hit)) return;
        if (query.origin_error > 0.0 &&
            in_plane(query.ray.origin, points_[0], points_[1], points_[2], query.origin_error)) {
            return;
        }
        sink(hit.t, 0u, hit.at);
    }

    Vec3 normal(const Vec3&, const Crossing& at) const override {
        if (!normals_) return normal_;
        const Corners& n = *normals_;
        return n[0] * (1.0 - at.at.x - at.at.y) + n[1] * at.at.x + n[2] * at.at.y;
    }

    ShapePtr transformed(const Transform& map) const override {
        Corners points;
        std::optional<Corners> normals;
        if (normals_) normals.emplace();
        for (size_t i = 0; i < 3; ++i) {
            points[i] = map.point(points_[i]);
            if (normals_) (*normals)[i] = glm::normalize(map.normal((*normals_)[i]));
        }
        auto moved = std::make_shared<Triangle>(points, face_normal(points), normals);
        moved->degenerate_ = moved->degenerate_ || degenerate_;
        return moved;
    }

    std::optional<TriangleMesh> tessellate(double) const override {
        TriangleMesh mesh;
        if (degenerate_) return mesh;
        double largest = 0;
        for (const Vec3& p : points_) {
            mesh.vertices.emplace_back(p);
            largest = std::max(largest, max_component(glm::abs(p)));
        }
        const bool turned = glm::dot(face_normal(points_), normal_) < 0.0;
        mesh.faces.push_back(turned ? std::array<uint32_t, 3>{0, 2, 1} : std::array<uint32_t, 3>{0, 1, 2});
        mesh.error = 1.1e-7 * largest;
        return mesh;
    }

    std::string describe() const override {
        return fmt::format("<{},{},{}> <{},{},{}> <{},{},{}>", points_[0].x, points_[0].y, points_[0].z,
                           points_[1].x, points_[1].y, points_[1].z, points_[2].x, points_[2].y,
                           points_[2].z);
    }

private:
    /// The vertex normals must all point to one side of the face, or the language drops the triangle.
    bool same_side() const {
        const Vec3 n = face_normal(points_);
        const auto side = [&](size_t i) { return glm::dot(n, (*normals_)[i]); };
        return (side(0) > 0.0 && side(1) > 0.0 && side(2) > 0.0) ||
               (side(0) < 0.0 && side(1) < 0.0 && side(2) < 0.0);
    }

    Corners points_;
    std::optional<Corners> normals_;
    Vec3 normal_;
    bool degenerate_ = false;
};

}  // namespace

ShapePtr read_triangle(BlockReader& in, bool smooth) {
    Corners points;
    Corners normals;
    bool zero = false;
    for (size_t i = 0; i < 3; ++i) {
        points[i] = in.vec3();
        if (!smooth) continue;
        normals[i] = in.vec3();
        const double length = glm::length(normals[i]);
        zero = zero || !(length > 0.0);
        if (length > 0.0) normals[i] /= length;
    }
    auto triangle = std::make_shared<Triangle>(points, face_normal(points),
                                               smooth ? std::optional<Corners>(normals) : std::nullopt);
    if (triangle->is_degenerate() || zero) {
        in.diagnostics().warning(in.block_where(), "Degenerate triangle. Please remove.");
    }
    return triangle;
}

}  // namespace rb
