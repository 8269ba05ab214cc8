// superellipsoid { <e, n> }   (manual 3.5.1.14): ((|x|^(2/e) + |y|^(2/e))^(e/n) + |z|^(2/n)) = 1
#include "math/p_norm.h"
#include "shapes/convex_ray.h"
#include "shapes/frame.h"
#include "shapes/mesh_refinement.h"
#include "shapes/ray_shape.h"
#include "shapes/registry.h"

#include <algorithm>
#include <numeric>

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

    std::optional<TriangleMesh> tessellate(double tolerance) const override;

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
        /// Whether the value's sign is more than rounding makes it.
        bool is_told(double t) const {
            const Vec3 moves = glm::abs(o) + std::abs(t) * glm::abs(d);
            const double rounding = 4.0 * std::numeric_limits<double>::epsilon() *
                                    (1.0 + glm::dot(glm::abs(shape_.slopes(o + t * d).gradient), moves));
            return std::abs(value(t)) > rounding;
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
        if (here) {
            // A ray along the surface would go in and out of it with every last bit.
            cuts[0] = beside * b;
            while (cuts[0] < cuts[1] && !line.is_told(cuts[0])) cuts[0] = std::min(2.0 * cuts[0], cuts[1]);
        }
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

    class Facets;

    Frame frame_;
    double east_;
    double north_;
    PNorm across_;  ///< of x and y
    PNorm along_;   ///< of that and z
};

/// Values at a triangle's corners of two affine functions that a function runs between.
struct AffineBounds {
    std::array<double, 3> lo, hi;

    static AffineBounds exactly(double a, double b, double c) { return {{a, b, c}, {a, b, c}}; }
    double middle() const {
        return std::reduce(lo.begin(), lo.end(), std::reduce(hi.begin(), hi.end())) / 6.0;
    }
};

/// A norm lies above its tangent plane anywhere and below the plane through its values at the corners; where
/// it is concave the other way round.
AffineBounds bounds_of(const PNorm& norm, const AffineBounds& a, const AffineBounds& b) {
    const PNorm::Growth growth = norm.growth(a.middle(), b.middle());
    AffineBounds out;
    for (size_t k = 0; k < 3; ++k) {
        const bool is_convex = norm.p() >= 1.0;
        const auto tangent = [&](double u, double v) { return growth.by_a * u + growth.by_b * v; };
        out.lo[k] = is_convex ? tangent(a.lo[k], b.lo[k]) : norm(a.lo[k], b.lo[k]);
        out.hi[k] = is_convex ? norm(a.hi[k], b.hi[k]) : tangent(a.hi[k], b.hi[k]);
    }
    return out;
}

/// The mesh: an octahedron, refined. Its vertices keep their octant.
class Superellipsoid::Facets {
public:
    Facets(const Superellipsoid& shape, double within) : shape_(shape), within_(within) {
        for (int i = 0; i < 6; ++i) {
            Vec3 tip{0.0};
            tip[i / 2] = i % 2 == 0 ? 1.0 : -1.0;
            add(tip);
        }
    }

    std::vector<MeshFace> octahedron() const {
        const bool is_mirrored = glm::dot(glm::cross(rows()[0], rows()[1]), rows()[2]) < 0.0;
        std::vector<MeshFace> faces;
        for (uint32_t octant = 0; octant < 8; ++octant) {
            const uint32_t x = octant & 1;
            const uint32_t y = octant >> 1 & 1;
            const uint32_t z = octant >> 2;
            MeshFace face{x, 4 + z, 2 + y};
            if (((x + y + z) % 2 == 1) != is_mirrored) std::swap(face[1], face[2]);
            faces.push_back(face);
        }
        return faces;
    }

    Vec3 point(uint32_t i) const { return points_[i]; }

    uint32_t between(uint32_t a, uint32_t b, const Vec3&) {
        const Vec3 middle = 0.5 * (local_[a] + local_[b]);
        add(middle / (1.0 + shape_.value(middle)));
        return static_cast<uint32_t>(local_.size() - 1);
    }

    bool is_near(const MeshFace& face) const {
        // Every point of a triangle is as near to a corner.
        if (enclosing_radius(points_[face[0]], points_[face[1]], points_[face[2]]) <= within_) return true;
        std::array<AffineBounds, 3> size;
        for (int axis = 0; axis < 3; ++axis) {
            const auto at = [&](size_t k) { return std::abs(local_[face[k]][axis]); };
            size[static_cast<size_t>(axis)] = AffineBounds::exactly(at(0), at(1), at(2));
        }
        const AffineBounds norm =
            bounds_of(shape_.along_, bounds_of(shape_.across_, size[0], size[1]), size[2]);
        const double least = *std::ranges::min_element(norm.lo);
        const double most = *std::ranges::max_element(norm.hi);
        // Along the way to the center the norm is a share of the way.
        double way = 0.0;
        for (const uint32_t k : face) way = std::max(way, glm::length(points_[k] - rows()[3]));
        return way * std::max(1.0 / least - 1.0, 1.0 - 1.0 / most) <= within_;
    }

private:
    const std::array<Vec3, 4>& rows() const { return shape_.frame_.object_from_local.forward.row; }

    void add(const Vec3& local) {
        local_.push_back(local);
        points_.push_back(shape_.frame_.object_from_local.point(local));
    }

    const Superellipsoid& shape_;
    double within_;
    std::vector<Vec3> local_;
    std::vector<Vec3> points_;
};

std::optional<TriangleMesh> Superellipsoid::tessellate(double tolerance) const {
    Facets facets(*this, tolerance - float_rounding(bounds()));
    MeshRefinement refinement(facets, facets.octahedron());
    if (!refinement.run(most_mesh_faces)) return std::nullopt;
    TriangleMesh mesh = refinement.take_mesh();
    mesh.error = tolerance;
    return mesh;
}

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
