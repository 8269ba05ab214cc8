// quadric { <A,B,C>, <D,E,F>, <G,H,I>, J }   (manual 3.5.3.4):
// A x^2 + B y^2 + C z^2 + D xy + E xz + F yz + G x + H y + I z + J = 0
#include "math/roots.h"
#include "shapes/ray_shape.h"
#include "shapes/registry.h"
#include "shapes/revolve.h"

#include <algorithm>

#include <fmt/format.h>

namespace rb {

namespace {

/// p Q p + g p + j with a symmetric Q (rows).
struct Form {
    std::array<Vec3, 3> q;
    Vec3 g{0.0};
    double j = 0;

    Vec3 times(const Vec3& p) const { return {glm::dot(q[0], p), glm::dot(q[1], p), glm::dot(q[2], p)}; }
    double at(const Vec3& p) const { return glm::dot(p, times(p)) + glm::dot(g, p) + j; }
    Vec3 gradient(const Vec3& p) const { return 2.0 * times(p) + g; }
    Form negated() const { return {{-q[0], -q[1], -q[2]}, -g, -j}; }
};

/// Of the quadratic part; absent where an eigenvalue is 0 up to rounding, as that of a turned paraboloid is.
std::optional<Affine> inverse_of_squares(const Form& f) {
    const auto& q = f.q;
    const Vec3 minors = glm::cross(q[1], q[2]);
    const double determinant = glm::dot(q[0], minors);
    const double pairs = minors.x + (q[0].x * q[2].z - q[0].z * q[2].x) + (q[0].x * q[1].y - q[0].y * q[1].x);
    const double largest =
        std::max({largest_magnitude(q[0]), largest_magnitude(q[1]), largest_magnitude(q[2])});
    // Where two eigenvalues are larger than the third, this compares the third with the rounding errors.
    constexpr double rounding = 1e-13;
    if (!(std::abs(determinant) > rounding * largest * std::abs(pairs))) return std::nullopt;
    return inverse_of({{q[0], q[1], q[2], Vec3{0.0}}});
}

/// A positive definite form below zero somewhere: an ellipsoid, as an image of the unit sphere.
std::optional<Affine> ellipsoid_of(const Form& f) {
    if (!(f.q[0].x > 0.0) || !(f.q[0].x * f.q[1].y - f.q[0].y * f.q[1].x > 0.0)) return std::nullopt;
    const auto inverse = inverse_of_squares(f);
    if (!inverse || !(glm::dot(f.q[0], glm::cross(f.q[1], f.q[2])) > 0.0)) return std::nullopt;
    const Vec3 center = -0.5 * inverse->direction(f.g);
    const double depth = -f.at(center);
    if (!(depth > 0.0)) return std::nullopt;
    // Cholesky of the inverse: its columns are the images of the unit axes.
    const auto& m = inverse->row;
    const double a = std::sqrt(m[0].x);
    const double b = m[0].y / a;
    const double c = m[0].z / a;
    const double d = std::sqrt(m[1].y - b * b);
    const double e = (m[1].z - b * c) / d;
    const double h = std::sqrt(m[2].z - c * c - e * e);
    const double s = std::sqrt(depth);
    return Affine{{s * Vec3{a, b, c}, s * Vec3{0, d, e}, s * Vec3{0, 0, h}, center}};
}

/// The box of an axis-parallel form that is nowhere concave: infinite along axes that it does not bound.
Bounds axis_parallel_box(const Form& f) {
    Bounds box = Bounds::everything();
    if (f.q[0].y != 0.0 || f.q[0].z != 0.0 || f.q[1].z != 0.0) return box;
    double lowest = f.j;
    for (int i = 0; i < 3; ++i) {
        const double q = f.q[static_cast<size_t>(i)][i];
        if (q < 0.0 || (q == 0.0 && f.g[i] != 0.0)) return box;
        if (q > 0.0) lowest -= f.g[i] * f.g[i] / (4.0 * q);
    }
    for (int i = 0; i < 3; ++i) {
        const double q = f.q[static_cast<size_t>(i)][i];
        if (q == 0.0) continue;
        const double center = -0.5 * f.g[i] / q;
        const double half = std::sqrt(std::max(-lowest / q, 0.0));
        const double pad = 1e-14 * (std::abs(center) + half);
        box.lo[i] = center - half - pad;
        box.hi[i] = center + half + pad;
    }
    return box;
}

Bounds surface_box(const Form& form) {
    for (const Form& f : {form, form.negated()}) {
        Bounds box = axis_parallel_box(f);
        if (box.is_finite()) return box;
        if (const auto place = ellipsoid_of(f)) {
            const auto& r = place->row;
            Vec3 half;
            for (int i = 0; i < 3; ++i) half[i] = std::hypot(r[0][i], r[1][i], r[2][i]);
            half += 1e-13 * (half + glm::abs(r[3]));
            return {r[3] - half, r[3] + half};
        }
        for (int i = 0; i < 3; ++i) {
            if (std::isfinite(box.lo[i])) return box;
        }
    }
    return Bounds::everything();
}

class Quadric final : public RayShape<Quadric> {
public:
    /// `turned`: normals are minus the gradient. The language's inverted quadric keeps its normals.
    explicit Quadric(const Form& form, bool turned = false)
        : form_(form), turned_(turned), box_(surface_box(form)) {
        const auto inverse = inverse_of_squares(form);
        if (inverse) center_ = -0.5 * inverse->direction(form.g);
    }

    std::string_view keyword() const override { return "quadric"; }
    Bounds bounds() const override { return box_; }
    Bounds solid_bounds() const override {
        // Inside the box only if far away is outside.
        for (int i = 0; i < 3; ++i) {
            const double q = form_.q[static_cast<size_t>(i)][i];
            if (std::isfinite(box_.lo[i]) && q > 0.0) return box_;
        }
        return Bounds::everything();
    }
    bool inside(const Vec3& p) const override { return form_.at(p) <= 0.0; }

    template <class Sink>
    void each_crossing(const ShapeRay& query, Sink&& sink) const {
        const Vec3& d = query.ray.direction;
        const Vec3& o = query.ray.origin;
        const double a = glm::dot(d, form_.times(d));
        if (starts_here(query)) {
            const double slope = glm::dot(d, form_.gradient(o));
            if (a != 0.0) sink(-slope / a, 0u, Vec2{0.0});
            return;
        }
        // From the point nearest to the centre, so that far origins do not cancel.
        const double middle = -glm::dot(o - center_, d) / glm::dot(d, d);
        const Vec3 q = o + middle * d;
        std::array<double, 2> roots{};
        const int n = solve_quadratic(a, 0.5 * glm::dot(d, form_.gradient(q)), form_.at(q), roots);
        if (n == 1 && a != 0.0) return;
        for (int i = 0; i < n; ++i) sink(middle + roots[static_cast<size_t>(i)], 0u, Vec2{0.0});
    }

    Vec3 normal(const Vec3& p, const Crossing&) const override {
        const Vec3 n = form_.gradient(p);
        if (n == Vec3{0.0}) return {1, 0, 0};
        return turned_ ? -n : n;
    }

    ShapePtr transformed(const Transform& map) const override {
        // With p = M p' + m the form becomes p' (M^T Q M) p' + (M^T (2 Q m + g)) p' + F(m).
        const auto& r = map.backward.row;
        const std::array<Vec3, 3> axes{r[0], r[1], r[2]};
        Form moved;
        for (size_t i = 0; i < 3; ++i) {
            for (int k = 0; k < 3; ++k)
                moved.q[i][k] = glm::dot(axes[i], form_.times(axes[static_cast<size_t>(k)]));
        }
        const Vec3 gradient = form_.gradient(r[3]);
        moved.g = {glm::dot(axes[0], gradient), glm::dot(axes[1], gradient), glm::dot(axes[2], gradient)};
        moved.j = form_.at(r[3]);
        return std::make_shared<Quadric>(moved, turned_);
    }

    ShapePtr inverted() const override { return std::make_shared<Quadric>(form_.negated(), !turned_); }

    std::optional<TriangleMesh> tessellate(double tolerance) const override {
        const auto place = ellipsoid_of(form_);
        if (!place) return std::nullopt;
        return round_mesh({0.0, 1.0, tolerance}, *place);
    }

    std::string describe() const override {
        const Form& f = form_;
        return fmt::format("<{},{},{}> <{},{},{}> <{},{},{}> {}", f.q[0].x, f.q[1].y, f.q[2].z, 2 * f.q[0].y,
                           2 * f.q[0].z, 2 * f.q[1].z, f.g.x, f.g.y, f.g.z, f.j);
    }

private:
    bool starts_here(const ShapeRay& query) const {
        if (query.starts_on_surface) return true;
        if (!(query.origin_error > 0.0)) return false;
        const Vec3 n = form_.gradient(query.ray.origin);
        const double value = form_.at(query.ray.origin);
        return value * value <= query.origin_error * query.origin_error * glm::dot(n, n);
    }

    Form form_;
    bool turned_;
    Bounds box_;
    Vec3 center_{0.0};
};

ShapePtr read(BlockReader& in) {
    const Vec3 squares = in.vec3();
    const Vec3 mixed = 0.5 * in.vec3();
    Form form;
    form.q = {Vec3{squares.x, mixed.x, mixed.y}, Vec3{mixed.x, squares.y, mixed.z},
              Vec3{mixed.y, mixed.z, squares.z}};
    form.g = in.vec3();
    form.j = in.number();
    return std::make_shared<Quadric>(form);
}

}  // namespace

namespace shapes {
extern const ShapeKind quadric;
const ShapeKind quadric{"quadric", read, "quadric { <1, 2, 1.5>, <0.2, -0.1, 0.3>, <0.1, 0, -0.2>, -0.5 }"};
}  // namespace shapes

}  // namespace rb
