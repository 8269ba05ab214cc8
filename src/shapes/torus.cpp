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
        Equation equation;
        if (!set_up(query, equation)) return;
        std::array<double, 4> roots{};
        const int n = equation.roots(roots);
        for (size_t i = 0; i < static_cast<size_t>(n); ++i)
            sink((roots[i] + equation.middle) * equation.t_of_u, 0u, Vec2{0.0});
    }

    bool closest(const ShapeRay& ray, const CrossingFilter* filter, Crossing& nearest) const override {
        Equation equation;
        if (!set_up(ray, equation)) return false;
        // Mostly the first root is the one, and the others need not be found.
        std::array<double, 4> roots{};
        for (const int most : {1, 4}) {
            const int n = equation.roots(roots, most);
            for (int i = 0; i < n; ++i) {
                const double t = (roots[static_cast<size_t>(i)] + equation.middle) * equation.t_of_u;
                if (t > ray.t_max) return false;
                if (!(t > ray.t_min)) continue;
                nearest = {t, 0u, Vec2{0.0}};
                if (!filter || filter->counts(nearest)) return true;
            }
            if (n < most) return false;
        }
        return false;
    }

    bool any(const ShapeRay& ray, const CrossingFilter* filter, Crossing& found) const override {
        if (filter) return closest(ray, filter, found);
        Equation equation;
        found = {ray.t_max, 0u, Vec2{0.0}};
        return set_up(ray, equation) && equation.has_root_before(ray.t_max);
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
        double lo = 0;
        double hi = 0;
    };

    /// Where a ray crosses: roots of a polynomial in u, of the fourth degree, or of the third where the root
    /// at the ray's origin is divided out. t = (u + middle) * t_of_u.
    struct Equation {
        std::array<double, 5> quartic{};
        bool at_origin = false;
        Interval in;  ///< all roots beyond t_min lie here
        double middle = 0;
        double t_of_u = 1;

        std::array<double, 4> cubic() const { return {quartic[0], quartic[1], quartic[2], quartic[3]}; }
        int roots(std::array<double, 4>& out, int most = 4) const {
            return at_origin ? solve_cubic(cubic(), in.lo, in.hi, std::span<double, 3>(out.data(), 3), most)
                             : solve_quartic(quartic, in.lo, in.hi, out, most);
        }
        bool has_root_before(double t_max) const {
            const double hi = std::min(in.hi, t_max / t_of_u - middle);
            if (!(in.lo < hi)) return false;
            return at_origin ? changes_sign(cubic(), in.lo, hi) : changes_sign(quartic, in.lo, hi);
        }
    };

    /// False if the ray misses. In units of the outer radius, with the parameter's zero at the closest
    /// approach to the centre, or at the origin where the ray starts on the surface.
    bool set_up(const ShapeRay& query, Equation& e) const {
        const double size = major_ + minor_;
        if (!(size > 0.0)) return false;
        const double unit = 1.0 / size;
        const Vec3 o = frame_.local_point(query.ray.origin) * unit;
        Vec3 d = frame_.local_direction(query.ray.direction);
        const double speed = 1.0 / glm::length(d);
        d *= speed;
        e.t_of_u = size * speed;
        const double major = major_ * unit;
        const double r = minor_ * unit;
        e.middle = -glm::dot(o, d);
        Vec3 q = o + e.middle * d;
        const double u_of_t = 1.0 / e.t_of_u;
        e.in = {query.t_min * u_of_t - e.middle, std::numeric_limits<double>::infinity()};
        // The end of the query only rejects, so that a root does not depend on it.
        if (!narrow(q, d, r, e.in) ||
            passes_hole(q, d, major - r, {e.in.lo, std::min(e.in.hi, query.t_max * u_of_t - e.middle)}))
            return false;

        e.at_origin = starts_here(query, o, major, r);
        if (e.at_origin) {
            e.in.lo = std::max(e.in.lo + e.middle, query.t_min * u_of_t);
            e.in.hi += e.middle;
            q = o;
            e.middle = 0.0;
        }
        const double rho = std::sqrt(q.x * q.x + q.z * q.z);
        const double k = glm::dot(q, q) + major * major - r * r;
        const double b = glm::dot(q, d);
        const double f = 4.0 * major * major;
        const double c2 = 4.0 * b * b + 2.0 * k - f * (d.x * d.x + d.z * d.z);
        const double c1 = 4.0 * b * k - 2.0 * f * (q.x * d.x + q.z * d.z);
        const double across = rho - major;
        const double c0 = (across * across + q.y * q.y - r * r) * (k + 2.0 * major * rho);
        e.quartic = {1.0, 4.0 * b, c2, c1, c0};
        return true;
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
