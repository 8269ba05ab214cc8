// box { <corner>, <corner> }   (manual 3.5.1.1)
#include "shapes/ray_shape.h"
#include "shapes/registry.h"

#include <algorithm>
#include <emmintrin.h>

#include <fmt/format.h>

namespace rb {

namespace {

class Box final : public RayShape<Box> {
public:
    Box(const Vec3& a, const Vec3& b) : lo_(glm::min(a, b)), hi_(glm::max(a, b)) {}

    std::string_view keyword() const override { return "box"; }
    Curvature curvature() const override { return Curvature::convex; }
    bool is_convex_body() const override { return true; }
    Bounds bounds() const override { return {lo_, hi_}; }
    bool inside(const Vec3& p) const override { return Bounds{lo_, hi_}.contains(p); }

    /// Part 2 * axis is the low face, 2 * axis + 1 the high one.
    template <class Sink>
    void each_crossing(const ShapeRay& query, Sink&& sink) const {
        const Vec3& d = query.ray.direction;
        Vec3 o = query.ray.origin;
        if (query.starts_on_surface || query.origin_error > 0.0) put_on_faces(query, o);
        double t_in = -std::numeric_limits<double>::infinity();
        double t_out = -t_in;
        int axis_in = -1;
        int axis_out = -1;
        for (int axis = 0; axis < 3; ++axis) {
            if (d[axis] == 0.0) {
                if (o[axis] < lo_[axis] || o[axis] > hi_[axis]) return;
                continue;
            }
            // No reciprocals: a plane in a face of the box is to be met at the very same t. Both divisions at
            // once take as long as one.
            const __m128d faces = _mm_setr_pd(lo_[axis], hi_[axis]);
            const __m128d t = _mm_div_pd(_mm_sub_pd(faces, _mm_set1_pd(o[axis])), _mm_set1_pd(d[axis]));
            const __m128d turned = _mm_unpackhi_pd(t, t);
            const double near = _mm_cvtsd_f64(_mm_min_sd(t, turned));
            const double far = _mm_cvtsd_f64(_mm_max_sd(t, turned));
            if (near > t_in || replaces(near, t_in, axis, axis_in, d)) axis_in = axis;
            t_in = std::max(t_in, near);
            if (far < t_out || replaces(far, t_out, axis, axis_out, d)) axis_out = axis;
            t_out = std::min(t_out, far);
        }
        if (!(t_in <= t_out) || axis_in < 0) return;
        sink(t_in, face(axis_in, d[axis_in] < 0.0), Vec2{0.0});
        sink(t_out, face(axis_out, !(d[axis_out] < 0.0)), Vec2{0.0});
    }

    Vec3 normal(const Vec3&, const Crossing& at) const override {
        Vec3 n{0.0};
        n[static_cast<int>(at.part / 2)] = at.part % 2 == 1 ? 1.0 : -1.0;
        return n;
    }

    void snap(const Crossing& at, Vec3& p) const override {
        const int axis = static_cast<int>(at.part / 2);
        p[axis] = (at.part % 2 == 1 ? hi_ : lo_)[axis];
    }

    std::optional<Vec2> uv(const Vec3& point, const Crossing& at) const override {
        const Vec3 p = (point - lo_) / (hi_ - lo_);
        switch (at.part) {
            case 0:
                return Vec2{p.z / 4, 1.0 / 3 + p.y / 3};
            case 1:
                return Vec2{0.75 - p.z / 4, 1.0 / 3 + p.y / 3};
            case 2:
                return Vec2{0.25 + p.x / 4, p.z / 3};
            case 3:
                return Vec2{0.25 + p.x / 4, 1.0 - p.z / 3};
            case 4:
                return Vec2{1.0 - p.x / 4, 1.0 / 3 + p.y / 3};
            default:
                return Vec2{0.25 + p.x / 4, 1.0 / 3 + p.y / 3};
        }
    }

    ShapePtr transformed(const Transform& map) const override {
        for (int i = 0; i < 3; ++i) {
            for (int j = 0; j < 3; ++j) {
                if (i != j && map.forward.row[static_cast<size_t>(i)][j] != 0.0) return nullptr;
            }
        }
        return std::make_shared<Box>(map.point(lo_), map.point(hi_));
    }

    std::optional<TriangleMesh> tessellate(double) const override {
        TriangleMesh mesh;
        for (int i = 0; i < 8; ++i) {
            mesh.vertices.emplace_back((i & 1 ? hi_ : lo_).x, (i & 2 ? hi_ : lo_).y, (i & 4 ? hi_ : lo_).z);
        }
        mesh.faces = {{0, 2, 4}, {2, 6, 4}, {1, 5, 3}, {3, 5, 7}, {0, 4, 1}, {1, 4, 5},
                      {2, 3, 6}, {3, 7, 6}, {0, 1, 2}, {1, 3, 2}, {4, 6, 5}, {5, 6, 7}};
        mesh.error = 1.1e-7 * std::max(max_component(glm::abs(lo_)), max_component(glm::abs(hi_)));
        return mesh;
    }

    std::string describe() const override {
        return fmt::format("from <{},{},{}> to <{},{},{}>", lo_.x, lo_.y, lo_.z, hi_.x, hi_.y, hi_.z);
    }

private:
    static uint32_t face(int axis, bool high) { return static_cast<uint32_t>(2 * axis) + (high ? 1u : 0u); }

    /// Which face an edge hit belongs to: the one that the ray meets more squarely (spec: geometry 9.2).
    static bool replaces(double t, double best, int axis, int best_axis, const Vec3& d) {
        constexpr double rounding = 1e-14;
        return best_axis >= 0 && std::abs(t - best) <= rounding * std::abs(best) &&
               std::abs(d[axis]) > std::abs(d[best_axis]);
    }

    /// Moves an origin that lies on faces exactly onto them: their crossing is then at t = 0 and does not
    /// count.
    void put_on_faces(const ShapeRay& query, Vec3& o) const {
        uint32_t part = 6;
        if (query.starts_on_surface) part = query.origin_part < 6 ? query.origin_part : nearest_face(o);
        for (int axis = 0; axis < 3; ++axis) {
            const double at = o[axis];
            const double not_high = std::abs(at - lo_[axis]) <= query.origin_error ? lo_[axis] : at;
            o[axis] = std::abs(at - hi_[axis]) <= query.origin_error ? hi_[axis] : not_high;
        }
        if (part == 6) return;
        const int axis = static_cast<int>(part / 2);
        o[axis] = (part % 2 == 1 ? hi_ : lo_)[axis];
    }

    uint32_t nearest_face(const Vec3& p) const {
        double nearest = std::numeric_limits<double>::infinity();
        uint32_t part = 0;
        for (int axis = 0; axis < 3; ++axis) {
            for (const bool high : {false, true}) {
                const double distance = std::abs(p[axis] - (high ? hi_ : lo_)[axis]);
                if (distance >= nearest) continue;
                nearest = distance;
                part = face(axis, high);
            }
        }
        return part;
    }

    Vec3 lo_;
    Vec3 hi_;
};

ShapePtr read(BlockReader& in) {
    const Vec3 a = in.vec3();
    return std::make_shared<Box>(a, in.vec3());
}

}  // namespace

namespace shapes {
extern const ShapeKind box;
const ShapeKind box{"box", read, "box { <-0.7, -0.3, -0.5>, <0.4, 0.6, 0.2> }"};
}  // namespace shapes

}  // namespace rb
