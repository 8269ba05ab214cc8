// superellipsoid { <e, n> }   (manual 3.5.1.14): ((|x|^(2/e) + |y|^(2/e))^(e/n) + |z|^(2/n)) = 1
#include "shapes/convex_ray.h"
#include "shapes/frame.h"
#include "shapes/ray_shape.h"
#include "shapes/registry.h"

#include <algorithm>

#include <fmt/format.h>

namespace rb {

namespace {

/// (a^p + b^p)^(1/p) for a, b >= 0: the p-norm; the larger of both for an infinite p.
double p_norm(double a, double b, double p) {
    const double most = std::max(a, b);
    if (!(most > 0.0)) return 0.0;
    return most * std::pow(1.0 + std::pow(std::min(a, b) / most, p), 1.0 / p);
}

/// Derivative of the p-norm `norm` by its part `a`.
double p_slope(double a, double norm, double p) { return a > 0.0 ? std::pow(a / norm, p - 1.0) : 0.0; }

/// The exponent of the dual norm; below 1 the hull of the unit ball counts.
double dual(double p) {
    return p > 1.0 ? (std::isinf(p) ? 1.0 : p / (p - 1.0)) : std::numeric_limits<double>::infinity();
}

class Superellipsoid final : public RayShape<Superellipsoid> {
public:
    Superellipsoid(const Frame& frame, double east, double north)
        : frame_(frame), east_(east), north_(north), p_(2.0 / std::abs(east)), q_(2.0 / std::abs(north)) {}

    std::string_view keyword() const override { return "superellipsoid"; }
    bool is_always_exact() const override { return true; }
    bool is_convex() const { return p_ >= 1.0 && q_ >= 1.0; }
    Curvature curvature() const override { return is_convex() ? Curvature::convex : Curvature::any; }

    Bounds bounds() const override {
        const auto& r = frame_.object_from_local.forward.row;
        Vec3 half;
        for (int i = 0; i < 3; ++i) {
            const double across = p_norm(std::abs(r[0][i]), std::abs(r[1][i]), dual(p_));
            half[i] = p_norm(across, std::abs(r[2][i]), dual(q_));
        }
        half += 64.0 * std::numeric_limits<double>::epsilon() * (half + glm::abs(r[3]));
        return {r[3] - half, r[3] + half};
    }
    Bounds language_extent() const override {
        constexpr double r = 1.0001;
        return rb::transformed(Bounds{Vec3{-r}, Vec3{r}}, frame_.object_from_local.forward);
    }
    bool inside(const Vec3& p) const override { return value(frame_.local_point(p)) <= 0.0; }

    template <class Sink>
    void each_crossing(const ShapeRay& query, Sink&& sink) const {
        const Vec3 d = frame_.local_direction(query.ray.direction);
        const Vec3 o = frame_.local_point(query.ray.origin);
        Line line{o, d, *this, 0.0};
        double a = 0.0;
        double b = std::numeric_limits<double>::infinity();
        constexpr double reach = 1.0 + 1e-6;
        for (int i = 0; i < 3; ++i) {
            if (d[i] == 0.0) {
                if (std::abs(o[i]) > reach) return;
                continue;
            }
            const double u = (-reach - o[i]) / d[i];
            const double v = (reach - o[i]) / d[i];
            a = std::max(a, std::min(u, v));
            b = std::min(b, std::max(u, v));
        }
        if (!(a < b)) return;
        const auto take = [&](double t) { sink(t, 0u, Vec2{0.0}); };
        const bool here = starts_here(query, o);
        // On the surface its value there counts as zero.
        if (here) line.level = value(o);
        if (is_convex()) {
            // A norm: its value along the ray has one valley.
            convex_roots([&](double t) { return line.value(t); }, [&](double t) { return line.slope(t); }, a,
                         b, here, take);
        } else {
            piecewise_roots(line, a, b, here, take);
        }
    }

    Vec3 normal(const Vec3& p, const Crossing&) const override {
        return frame_.normal(gradient(frame_.local_point(p)));
    }

    ShapePtr transformed(const Transform& map) const override {
        return std::make_shared<Superellipsoid>(Frame(then(frame_.object_from_local, map)), east_, north_);
    }

    std::optional<TriangleMesh> tessellate(double) const override { return std::nullopt; }

    std::string describe() const override {
        const Vec3 c = frame_.object_from_local.forward.row[3];
        return fmt::format("<{},{}> center <{},{},{}>", east_, north_, c.x, c.y, c.z);
    }

private:
    double value(const Vec3& p) const {
        return p_norm(p_norm(std::abs(p.x), std::abs(p.y), p_), std::abs(p.z), q_) - 1.0;
    }

    Vec3 gradient(const Vec3& p) const {
        const Vec3 a = glm::abs(p);
        const double across = p_norm(a.x, a.y, p_);
        const double all = p_norm(across, a.z, q_);
        const double by_across = p_slope(across, all, q_);
        return {std::copysign(p_slope(a.x, across, p_) * by_across, p.x),
                std::copysign(p_slope(a.y, across, p_) * by_across, p.y),
                std::copysign(p_slope(a.z, all, q_), p.z)};
    }

    struct Line {
        Vec3 o;
        Vec3 d;
        const Superellipsoid& shape;
        double level;

        double value(double t) const { return shape.value(o + t * d) - level; }
        double slope(double t) const { return glm::dot(d, shape.gradient(o + t * d)); }
    };

    bool starts_here(const ShapeRay& query, const Vec3& o) const {
        if (query.starts_on_surface) return true;
        if (!(query.origin_error > 0.0)) return false;
        const double error = query.origin_error * std::max(frame_.radial_stretch, frame_.axial_stretch);
        return std::abs(value(o)) <= error * glm::length(gradient(o));
    }

    /// Between the planes where the formula has its edges it is smooth; each piece is looked at closely.
    template <class Take>
    static void piecewise_roots(const Line& line, double a, double b, bool here, const Take& take) {
        const Vec3& o = line.o;
        const Vec3& d = line.d;
        std::array<double, 11> cuts{a, b};
        size_t n = 2;
        const auto cut = [&](double at, double speed) {
            if (speed == 0.0) return;
            const double t = -at / speed;
            if (t > a && t < b) cuts[n++] = t;
        };
        for (int i = 0; i < 3; ++i) {
            const int k = (i + 1) % 3;
            cut(o[i], d[i]);
            cut(o[i] - o[k], d[i] - d[k]);
            cut(o[i] + o[k], d[i] + d[k]);
        }
        std::sort(cuts.begin(), cuts.begin() + static_cast<std::ptrdiff_t>(n));
        constexpr int parts = 16;
        constexpr double beside = 1e-9;
        double t = here ? beside * b : a;
        double f = line.value(t);
        for (size_t i = 0; i + 1 < n; ++i) {
            for (int k = 1; k <= parts; ++k) {
                const double next = k == parts ? cuts[i + 1] : cuts[i] + (cuts[i + 1] - cuts[i]) * k / parts;
                if (!(next > t)) continue;
                const double g = line.value(next);
                if ((f < 0.0) != (g < 0.0)) {
                    take(bracketed_root([&](double at) { return line.value(at); }, t, f, next, g));
                }
                t = next;
                f = g;
            }
        }
    }

    Frame frame_;
    double east_;
    double north_;
    double p_;
    double q_;
};

ShapePtr read(BlockReader& in) {
    const Vec2 exponents = in.vec2();
    return std::make_shared<Superellipsoid>(Frame(Transform{}), exponents.x, exponents.y);
}

}  // namespace

namespace shapes {
extern const ShapeKind superellipsoid;
const ShapeKind superellipsoid{"superellipsoid", read, "superellipsoid { <0.5, 1.4> }"};
}  // namespace shapes

}  // namespace rb
