// superellipsoid { <e, n> }   (manual 3.5.1.14): ((|x|^(2/e) + |y|^(2/e))^(e/n) + |z|^(2/n)) = 1
#include "math/p_norm.h"
#include "shapes/convex_ray.h"
#include "shapes/frame.h"
#include "shapes/ray_shape.h"
#include "shapes/registry.h"

#include <algorithm>

#include <fmt/format.h>

namespace rb {

namespace {

/// The exponent of the dual norm; below 1 the hull of the unit ball counts.
double dual(double p) {
    return p > 1.0 ? (std::isinf(p) ? 1.0 : p / (p - 1.0)) : std::numeric_limits<double>::infinity();
}

class Superellipsoid final : public RayShape<Superellipsoid> {
public:
    Superellipsoid(const Frame& frame, double east, double north)
        : frame_(frame),
          east_(east),
          north_(north),
          across_(2.0 / std::abs(east)),
          along_(2.0 / std::abs(north)) {}

    std::string_view keyword() const override { return "superellipsoid"; }
    bool is_always_exact() const override { return true; }
    bool is_convex() const { return across_.p() >= 1.0 && along_.p() >= 1.0; }
    /// Within each octant.
    bool is_concave() const { return across_.p() <= 1.0 && along_.p() <= 1.0; }
    Curvature curvature() const override { return is_convex() ? Curvature::convex : Curvature::any; }

    Bounds bounds() const override {
        const auto& r = frame_.object_from_local.forward.row;
        const PNorm across(dual(across_.p()));
        const PNorm along(dual(along_.p()));
        Vec3 half;
        for (int i = 0; i < 3; ++i) {
            half[i] = along(across(std::abs(r[0][i]), std::abs(r[1][i])), std::abs(r[2][i]));
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
        Line line(o, d, *this);
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
        const auto take = [&](double t) {
            sink(t, 0u, Vec2{0.0});
            return sink.reach();
        };
        const bool here = starts_here(query, o);
        if (here) line.start_on_surface();
        if (is_convex()) {
            // A norm: its value along the ray has one valley.
            convex_roots([&](double t) { return line.value(t); }, [&](double t) { return line.slope(t); }, a,
                         b, here, take);
        } else {
            roots_by_octant(line, a, b, here, take);
        }
    }

    Vec3 normal(const Vec3& p, const Crossing&) const override {
        return frame_.normal(slopes(frame_.local_point(p)).gradient);
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
    struct Slopes {
        double value;
        Vec3 gradient;
    };
    Slopes slopes(const Vec3& p) const {
        const PNorm::Growth across = across_.growth(std::abs(p.x), std::abs(p.y));
        const PNorm::Growth all = along_.growth(across.value, std::abs(p.z));
        // In a crease it has no end.
        const auto finite = [](double v) { return std::min(v, 1e30); };
        const double outer = finite(all.by_a);
        const Vec3 gradient{std::copysign(finite(across.by_a) * outer, p.x),
                            std::copysign(finite(across.by_b) * outer, p.y),
                            std::copysign(finite(all.by_b), p.z)};
        return {all.value - 1.0, gradient};
    }
    double value(const Vec3& p) const {
        return along_(across_(std::abs(p.x), std::abs(p.y)), std::abs(p.z)) - 1.0;
    }

    class Line {
    public:
        Line(const Vec3& origin, const Vec3& direction, const Superellipsoid& shape)
            : o(origin), d(direction), shape_(shape) {}

        /// On the surface its value there counts as zero.
        void start_on_surface() { level_ = shape_.value(o); }
        double value(double t) const {
            if (t != at_) {
                const Slopes slopes = shape_.slopes(o + t * d);
                value_ = slopes.value - level_;
                slope_ = glm::dot(d, slopes.gradient);
                at_ = t;
            }
            return value_;
        }
        /// Hardly costs anything where the value was asked for last.
        double slope(double t) const {
            value(t);
            return slope_;
        }
        /// Within one octant.
        IntervalSlope bound(double from, double to) const {
            std::array<IntervalSlope, 3> size;
            for (int i = 0; i < 3; ++i) {
                const double middle = o[i] + 0.5 * (from + to) * d[i];
                const auto at = [&](double t) {
                    return std::max(std::copysign(1.0, middle) * (o[i] + t * d[i]), 0.0);
                };
                const auto [least, most] = std::minmax({at(from), at(to)});
                size[static_cast<size_t>(i)] = {Interval(least, most), std::copysign(1.0, middle) * d[i]};
            }
            return shape_.along_(shape_.across_(size[0], size[1]), size[2]) - IntervalSlope(1.0 + level_);
        }

        const Vec3 o;
        const Vec3 d;

    private:
        const Superellipsoid& shape_;
        double level_ = 0.0;
        mutable double at_ = std::numeric_limits<double>::quiet_NaN();
        mutable double value_ = 0.0;
        mutable double slope_ = 0.0;
    };

    bool starts_here(const ShapeRay& query, const Vec3& o) const {
        if (query.starts_on_surface) return true;
        if (!(query.origin_error > 0.0)) return false;
        const double error = query.origin_error * std::max(frame_.radial_stretch, frame_.axial_stretch);
        const Slopes at = slopes(o);
        return std::abs(at.value) <= error * glm::length(at.gradient);
    }

    template <class Take>
    void roots_by_octant(const Line& line, double a, double b, bool here, const Take& take) const {
        std::array<double, 5> cuts{a, b};
        size_t n = 2;
        for (int i = 0; i < 3; ++i) {
            if (line.d[i] == 0.0) continue;
            const double t = -line.o[i] / line.d[i];
            if (t > a && t < b) cuts[n++] = t;
        }
        std::sort(cuts.begin(), cuts.begin() + static_cast<std::ptrdiff_t>(n));
        double reach = b;
        const auto note = [&](double t) { return reach = take(t); };
        constexpr double beside = 1e-9;
        if (here) cuts[0] = beside * b;
        double f = line.value(cuts[0]);
        for (size_t i = 0; i + 1 < n; ++i) {
            if (!(cuts[i] < cuts[i + 1])) continue;
            if (cuts[i] > reach) return;
            const double g = line.value(cuts[i + 1]);
            if (is_concave()) {
                convex_roots_between([&](double t) { return -line.value(t); },
                                     [&](double t) { return -line.slope(t); }, cuts[i], -f, cuts[i + 1], -g,
                                     note);
            } else {
                constexpr double finest = 1e-9;
                bounded_roots(line, cuts[i], f, cuts[i + 1], g, finest * (b - a), note);
            }
            f = g;
        }
    }

    /// Halves until bounds tell that there is no root, or one.
    template <class Take>
    static void bounded_roots(const Line& line, double a, double fa, double b, double fb, double finest,
                              const Take& take) {
        const IntervalSlope v = line.bound(a, b);
        if (v.value.lo > 0.0 || v.value.hi < 0.0) return;
        const bool monotone = v.slope.lo > 0.0 || v.slope.hi < 0.0;
        if (monotone || b - a < finest) {
            if ((fa < 0.0) != (fb < 0.0))
                take(bracketed_root([&](double t) { return line.value(t); }, a, fa, b, fb));
            return;
        }
        const double middle = 0.5 * (a + b);
        const double f = line.value(middle);
        bounded_roots(line, a, fa, middle, f, finest, take);
        bounded_roots(line, middle, f, b, fb, finest, take);
    }

    Frame frame_;
    double east_;
    double north_;
    PNorm across_;  ///< of x and y
    PNorm along_;   ///< of that and z
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
