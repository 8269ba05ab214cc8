// torus { major_radius, minor_radius }   (manual 3.5.1.13); the axis is y
#include "math/roots.h"
#include "shapes/frame.h"
#include "shapes/ray_shape.h"
#include "shapes/registry.h"
#include "shapes/revolve.h"

#include <algorithm>

#include <fmt/format.h>

namespace rb {

namespace {

class Torus final : public RayShape<Torus> {
public:
    Torus(const Frame& frame, double major, double minor)
        : frame_(frame), major_(std::abs(major)), minor_(std::abs(minor)) {}

    std::string_view keyword() const override { return "torus"; }

    Bounds bounds() const override {
        // Support of circle plus ball along each object axis.
        const auto& r = frame_.object_from_local.forward.row;
        Vec3 half;
        for (int i = 0; i < 3; ++i) {
            half[i] = major_ * std::hypot(r[0][i], r[2][i]) + minor_ * std::hypot(r[0][i], r[1][i], r[2][i]);
        }
        const Vec3 pad = 8.0 * std::numeric_limits<double>::epsilon() * (half + glm::abs(r[3]));
        return {r[3] - half - pad, r[3] + half + pad};
    }
    Bounds language_extent() const override {
        const double r = major_ + minor_;
        return rb::transformed(Bounds{{-r, -minor_, -r}, {r, minor_, r}}, frame_.object_from_local.forward);
    }

    bool inside(const Vec3& p) const override {
        const Vec3 q = frame_.local_point(p);
        const double across = std::hypot(q.x, q.z) - major_;
        return q.y * q.y + across * across <= minor_ * minor_;
    }

    template <class Sink>
    void each_crossing(const ShapeRay& query, Sink&& sink) const {
        std::array<double, 4> roots{};
        const int n = crossings_of(query, roots, 4);
        for (int i = 0; i < n; ++i) sink(roots[static_cast<size_t>(i)], 0u, Vec2{0.0});
    }

    bool any(const ShapeRay& ray, const CrossingFilter* filter, Crossing& found) const override {
        if (filter) return closest(ray, filter, found);
        std::array<double, 4> roots{};
        if (crossings_of(ray, roots, 1) == 0) return false;
        found = {roots[0], 0u, Vec2{0.0}};
        return (roots[0] > ray.t_min && roots[0] <= ray.t_max) || closest(ray, filter, found);
    }

    Vec3 normal(const Vec3& p, const Crossing&) const override {
        Vec3 q = frame_.local_point(p);
        const double rho = std::sqrt(q.x * q.x + q.z * q.z);
        if (rho > 0.0) {
            q.x -= major_ * q.x / rho;
            q.z -= major_ * q.z / rho;
        }
        return frame_.normal(q);
    }

    std::optional<Vec2> uv(const Vec3& p, const Crossing&) const override {
        const Vec3 q = frame_.local_point(p);
        const double across = std::hypot(q.x, q.z) - major_;
        return Vec2{1.0 - (std::atan2(q.z, q.x) + pi) / (2.0 * pi),
                    (std::atan2(q.y, across) + pi) / (2.0 * pi)};
    }

    ShapePtr transformed(const Transform& map) const override {
        return std::make_shared<Torus>(Frame(then(frame_.object_from_local, map)), major_, minor_);
    }

    std::optional<TriangleMesh> tessellate(double tolerance) const override {
        if (!(minor_ > 0.0)) return TriangleMesh{};
        const Affine upright{{Vec3{1, 0, 0}, Vec3{0, 0, 1}, Vec3{0, 1, 0}, Vec3{0.0}}};
        return round_mesh({major_, minor_, tolerance}, then(upright, frame_.object_from_local.forward));
    }

    std::string describe() const override {
        const Vec3 c = frame_.object_from_local.forward.row[3];
        return fmt::format("center <{},{},{}> radii {} {}", c.x, c.y, c.z, major_, minor_);
    }

private:
    struct Interval {
        double lo;
        double hi;
    };

    /// The first `most` crossings from about t_min on, ascending. In units of the outer radius, with the
    /// parameter's zero at the closest approach to the centre, or at the origin where the ray starts on the
    /// surface and that root is divided out.
    int crossings_of(const ShapeRay& query, std::array<double, 4>& roots, int most) const {
        const double size = major_ + minor_;
        if (!(size > 0.0)) return 0;
        const double unit = 1.0 / size;
        const Vec3 o = frame_.local_point(query.ray.origin) * unit;
        Vec3 d = frame_.local_direction(query.ray.direction);
        const double speed = 1.0 / glm::length(d);
        d *= speed;
        const double t_of_u = size * speed;
        const double major = major_ * unit;
        const double r = minor_ * unit;
        double middle = -glm::dot(o, d);
        Vec3 q = o + middle * d;
        const double u_of_t = 1.0 / t_of_u;
        Interval in{query.t_min * u_of_t - middle, std::numeric_limits<double>::infinity()};
        // The end of the query only rejects, so that a root does not depend on it.
        if (!narrow(q, d, r, in) ||
            passes_hole(q, d, major - r, {in.lo, std::min(in.hi, query.t_max * u_of_t - middle)}))
            return 0;

        const bool starts = starts_here(query, o, major, r);
        if (starts) {
            in.lo = std::max(in.lo + middle, query.t_min * u_of_t);
            in.hi += middle;
            q = o;
            middle = 0.0;
        }
        const double rho = std::sqrt(q.x * q.x + q.z * q.z);
        const double k = glm::dot(q, q) + major * major - r * r;
        const double b = glm::dot(q, d);
        const double f = 4.0 * major * major;
        const double c2 = 4.0 * b * b + 2.0 * k - f * (d.x * d.x + d.z * d.z);
        const double c1 = 4.0 * b * k - 2.0 * f * (q.x * d.x + q.z * d.z);
        int n = 0;
        if (starts) {
            n = solve_cubic({1.0, 4.0 * b, c2, c1}, in.lo, in.hi, std::span<double, 3>(roots.data(), 3),
                            std::min(most, 3));
        } else {
            const double across = rho - major;
            const double c0 = (across * across + q.y * q.y - r * r) * (k + 2.0 * major * rho);
            n = solve_quartic({1.0, 4.0 * b, c2, c1, c0}, in.lo, in.hi, roots, most);
        }
        for (int i = 0; i < n; ++i)
            roots[static_cast<size_t>(i)] = (roots[static_cast<size_t>(i)] + middle) * t_of_u;
        return n;
    }

    bool starts_here(const ShapeRay& query, const Vec3& o, double major, double r) const {
        if (query.starts_on_surface) return true;
        if (!(query.origin_error > 0.0)) return false;
        const double error =
            query.origin_error * std::max(frame_.radial_stretch, frame_.axial_stretch) / (major_ + minor_);
        const double rho = std::sqrt(o.x * o.x + o.z * o.z);
        const auto is_near = [&](double across) {
            return std::abs(std::sqrt(across * across + o.y * o.y) - r) <= error;
        };
        return is_near(rho - major) || is_near(rho + major);
    }

    /// Cuts the interval to where the ray, which passes the centre nearest at `q`, is in the outer sphere and
    /// between the planes y = -r and y = r, a little enlarged, since the surface touches both.
    static bool narrow(const Vec3& q, const Vec3& d, double r, Interval& in) {
        constexpr double margin = 1.0 + 1e-6;
        const double chord = margin - glm::dot(q, q);
        if (!(chord > 0.0)) return false;
        const double half = std::sqrt(chord);
        in = {std::max(in.lo, -half), std::min(in.hi, half)};
        const double reach = r * margin;
        if (d.y != 0.0) {
            const double inverse = 1.0 / d.y;
            const double a = (-reach - q.y) * inverse;
            const double c = (reach - q.y) * inverse;
            in = {std::max(in.lo, std::min(a, c)), std::min(in.hi, std::max(a, c))};
        } else if (std::abs(q.y) > reach) {
            return false;
        }
        return in.lo < in.hi;
    }

    /// True if the interval is empty or all in the hole: the distance from the axis is largest at an end.
    static bool passes_hole(const Vec3& q, const Vec3& d, double hole, const Interval& in) {
        if (!(in.lo < in.hi)) return true;
        if (!(hole > 0.0)) return false;
        const auto is_in = [&](double u) {
            const double x = q.x + u * d.x;
            const double z = q.z + u * d.z;
            constexpr double margin = 1.0 - 1e-6;
            return x * x + z * z < hole * hole * margin;
        };
        return is_in(in.lo) && is_in(in.hi);
    }

    Frame frame_;
    double major_;
    double minor_;
};

ShapePtr read(BlockReader& in) {
    const double major = in.number();
    return std::make_shared<Torus>(Frame(Transform{}), major, in.number());
}

}  // namespace

namespace shapes {
extern const ShapeKind torus;
const ShapeKind torus{"torus", read, "torus { 0.7, 0.25 }"};
}  // namespace shapes

}  // namespace rb
