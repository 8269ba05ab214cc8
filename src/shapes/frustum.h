#pragma once
#include "shapes/frame.h"
#include "shapes/ray_shape.h"

namespace rb {

/// What cylinder and cone are: between two planes across the local z axis, the points with
/// x^2 + y^2 <= (offset + slope z)^2; open ones have no caps. Handles the double cone (radius changes sign).
class Frustum final : public RayShape<Frustum> {
public:
    struct Profile {
        double z0 = 0;
        double z1 = 1;
        double offset = 1;
        double slope = 0;
    };
    Frustum(std::string_view keyword, const Frame& frame, const Profile& profile, bool open)
        : keyword_(keyword), frame_(frame), profile_(profile), open_(open) {}

    std::string_view keyword() const override { return keyword_; }
    Curvature curvature() const override { return Curvature::convex; }
    bool is_convex_body() const override {
        const double r0 = profile_.offset + profile_.slope * profile_.z0;
        const double r1 = profile_.offset + profile_.slope * profile_.z1;
        return !open_ && r0 * r1 >= 0.0;
    }
    Bounds bounds() const override;
    Bounds solid_bounds() const override;
    Bounds language_extent() const override;
    bool inside(const Vec3& p) const override;

    enum Part : uint32_t { side = 0, cap0 = 1, cap1 = 2 };

    /// The solid is where the line is between the planes and inside the (double) cone: up to two intervals,
    /// so side and caps meet without a gap.
    template <class Sink>
    void each_crossing(const ShapeRay& query, Sink&& sink) const {
        Vec3 o = frame_.local_point(query.ray.origin);
        const Vec3 d = frame_.local_direction(query.ray.direction);
        const bool on_side = (query.starts_on_surface || query.origin_error > 0.0) && put_on_parts(query, o);

        double s_in = -std::numeric_limits<double>::infinity();
        double s_out = -s_in;
        if (d.z != 0.0) {
            s_in = (profile_.z0 - o.z) / d.z;
            s_out = (profile_.z1 - o.z) / d.z;
        } else if (o.z < profile_.z0 || o.z > profile_.z1) {
            return;
        }
        const bool down = d.z < 0.0;
        if (down) std::swap(s_in, s_out);
        const Part in_cap = down ? cap1 : cap0;
        const Part out_cap = down ? cap0 : cap1;
        const auto piece = [&](double t_in, double t_out) {
            const bool cap_in = s_in > t_in;
            const bool cap_out = s_out < t_out;
            const double a = cap_in ? s_in : t_in;
            const double b = cap_out ? s_out : t_out;
            if (!(a <= b)) return;
            if (!cap_in || !open_) sink(a, static_cast<uint32_t>(cap_in ? in_cap : side), Vec2{0.0});
            if (!cap_out || !open_) sink(b, static_cast<uint32_t>(cap_out ? out_cap : side), Vec2{0.0});
        };
        side_intervals(o, d, on_side, piece);
    }

    Vec3 normal(const Vec3& p, const Crossing& at) const override {
        if (at.part == cap0) return frame_.normal({0, 0, -1});
        if (at.part == cap1) return frame_.normal({0, 0, 1});
        const Vec3 q = frame_.local_point(p);
        return frame_.normal({q.x, q.y, -profile_.slope * (profile_.offset + profile_.slope * q.z)});
    }

    void snap(const Crossing& at, Vec3& p) const override;
    ShapePtr transformed(const Transform& map) const override {
        return std::make_shared<Frustum>(keyword_, Frame(then(frame_.object_from_local, map)), profile_,
                                         open_);
    }
    std::optional<TriangleMesh> tessellate(double tolerance) const override;
    std::string describe() const override;

private:
    double radius_at(double z) const { return profile_.offset + profile_.slope * z; }

    /// Calls piece(t_in, t_out) for each interval of the line inside the infinite (double) cone.
    template <class Piece>
    void side_intervals(const Vec3& o, const Vec3& d, bool on_side, Piece&& piece) const {
        constexpr double inf = std::numeric_limits<double>::infinity();
        const double r = radius_at(o.z);
        const double dr = profile_.slope * d.z;
        const double a = d.x * d.x + d.y * d.y - dr * dr;
        const double b = o.x * d.x + o.y * d.y - r * dr;
        const double c = on_side ? 0.0 : o.x * o.x + o.y * o.y - r * r;
        if (a == 0.0) {
            if (b == 0.0) {
                if (c <= 0.0) piece(-inf, inf);
            } else if (b > 0.0) {
                piece(-inf, -0.5 * c / b);
            } else {
                piece(-0.5 * c / b, inf);
            }
            return;
        }
        double t0;
        double t1;
        if (on_side) {
            t0 = std::min(0.0, -2.0 * b / a);
            t1 = std::max(0.0, -2.0 * b / a);
        } else if (dr == 0.0) {
            // Closest approach in the plane across: nothing cancels far away.
            const double middle = -b / a;
            const double x = o.x + middle * d.x;
            const double y = o.y + middle * d.y;
            const double chord = r * r - (x * x + y * y);
            if (!(chord >= 0.0)) return;
            const double half = std::sqrt(chord / a);
            t0 = middle - half;
            t1 = middle + half;
        } else {
            // The same about the point nearest to the cone's mid height keeps the coefficients small.
            const double middle = -(o.x * d.x + o.y * d.y + (o.z - mid()) * d.z) / glm::dot(d, d);
            const Vec3 q = o + middle * d;
            const double rq = radius_at(q.z);
            const double bq = q.x * d.x + q.y * d.y - rq * dr;
            const double cq = q.x * q.x + q.y * q.y - rq * rq;
            const double disc = bq * bq - a * cq;
            if (!(disc >= 0.0)) {
                if (a < 0.0) piece(-inf, inf);
                return;
            }
            const double w = -(bq + std::copysign(std::sqrt(disc), bq));
            const double x = w / a;
            const double y = w == 0.0 ? 0.0 : cq / w;
            t0 = middle + std::min(x, y);
            t1 = middle + std::max(x, y);
        }
        if (a > 0.0) {
            piece(t0, t1);
        } else {
            piece(-inf, t0);
            piece(t1, inf);
        }
    }

    double mid() const { return 0.5 * (profile_.z0 + profile_.z1); }
    /// Moves an origin on a cap exactly onto it; true if the side's own crossing at the origin is to be left
    /// out.
    bool put_on_parts(const ShapeRay& query, Vec3& o) const;

    std::string_view keyword_;
    Frame frame_;
    Profile profile_;
    bool open_;
};

}  // namespace rb
