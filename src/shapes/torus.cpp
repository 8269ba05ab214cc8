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

    /// In units of the outer radius, with the parameter's zero at the closest approach to the centre, or at
    /// the origin where the ray starts on the surface and that root is divided out.
    template <class Sink>
    void each_crossing(const ShapeRay& query, Sink&& sink) const {
        const double size = major_ + minor_;
        if (!(size > 0.0)) return;
        const Vec3 o = frame_.local_point(query.ray.origin) / size;
        Vec3 d = frame_.local_direction(query.ray.direction);
        const double length = glm::length(d);
        d /= length;
        const double t_of_u = size / length;
        const double R = major_ / size;
        const double r = minor_ / size;
        const bool starts = starts_here(query, o, R, r);
        const double middle = starts ? 0.0 : -glm::dot(o, d);
        const Vec3 q = o + middle * d;
        double lo = query.t_min / t_of_u - middle;
        double hi = query.t_max / t_of_u - middle;
        if (!narrow(q, d, r, lo, hi)) return;

        const double rho = std::sqrt(q.x * q.x + q.z * q.z);
        const double k = glm::dot(q, q) + R * R - r * r;
        const double b = glm::dot(q, d);
        const double f = 4.0 * R * R;
        const double c2 = 4.0 * b * b + 2.0 * k - f * (d.x * d.x + d.z * d.z);
        const double c1 = 4.0 * b * k - 2.0 * f * (q.x * d.x + q.z * d.z);
        const double across = rho - R;
        const double c0 = (across * across + q.y * q.y - r * r) * (k + 2.0 * R * rho);
        std::array<double, 4> roots{};
        int n = 0;
        if (starts) {
            n = solve_cubic({1.0, 4.0 * b, c2, c1}, lo, hi, std::span<double, 3>(roots.data(), 3));
        } else {
            n = solve_quartic({1.0, 4.0 * b, c2, c1, c0}, lo, hi, roots);
        }
        for (int i = 0; i < n; ++i) sink((roots[static_cast<size_t>(i)] + middle) * t_of_u, 0u, Vec2{0.0});
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
    bool starts_here(const ShapeRay& query, const Vec3& o, double R, double r) const {
        if (query.starts_on_surface) return true;
        if (!(query.origin_error > 0.0)) return false;
        const double error =
            query.origin_error * std::max(frame_.radial_stretch, frame_.axial_stretch) / (major_ + minor_);
        const double rho = std::sqrt(o.x * o.x + o.z * o.z);
        return std::abs(std::hypot(rho - R, o.y) - r) <= error ||
               std::abs(std::hypot(rho + R, o.y) - r) <= error;
    }

    /// Cuts the interval to where the ray is in the outer sphere and between the planes y = -r and y = r, a
    /// little enlarged, since the surface touches both.
    static bool narrow(const Vec3& q, const Vec3& d, double r, double& lo, double& hi) {
        constexpr double margin = 1.0 + 1e-6;
        const double b = glm::dot(q, d);
        const Vec3 foot = q - b * d;
        const double chord = margin - glm::dot(foot, foot);
        if (!(chord > 0.0)) return false;
        const double half = std::sqrt(chord);
        lo = std::max(lo, -b - half);
        hi = std::min(hi, -b + half);
        const double reach = r * margin;
        if (d.y != 0.0) {
            const double a = (-reach - q.y) / d.y;
            const double c = (reach - q.y) / d.y;
            lo = std::max(lo, std::min(a, c));
            hi = std::min(hi, std::max(a, c));
        } else if (std::abs(q.y) > reach) {
            return false;
        }
        return lo < hi;
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
