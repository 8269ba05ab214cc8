// quadric { <A,B,C>, <D,E,F>, <G,H,I>, J }   (manual 3.5.3.4):
// A x^2 + B y^2 + C z^2 + D xy + E xz + F yz + G x + H y + I z + J = 0
#include "math/interval.h"
#include "math/roots.h"
#include "shapes/ray_shape.h"
#include "shapes/registry.h"
#include "shapes/revolve.h"

#include <algorithm>
#include <span>

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

/// The least value of q y^2 + g y for y from lo to hi.
double least_of(double q, double g, double lo, double hi) {
    double least = std::min((q * lo + g) * lo, (q * hi + g) * hi);
    if (q > 0.0) {
        const double bottom = -0.5 * g / q;
        if (bottom > lo && bottom < hi) least = std::min(least, -0.25 * g * g / q);
    }
    return least;
}

/// The form at its least along an axis where it is convex: one of the two other coordinates.
Form least_along(const Form& f, int axis) {
    const auto k = static_cast<size_t>(axis);
    Form out = f;
    for (size_t i = 0; i < 3; ++i) out.q[i] -= f.q[k] * (f.q[k][static_cast<int>(i)] / f.q[k][axis]);
    out.g -= f.q[k] * (f.g[axis] / f.q[k][axis]);
    out.j -= 0.25 * f.g[axis] * f.g[axis] / f.q[k][axis];
    return out;
}

/// From where to where `a x^2 + b x + constant` can be at most zero for a given and some b of `linear`.
Interval reach_of(double a, const Interval& linear, double constant) {
    Interval reach{infinity, -infinity};
    for (const double b : {linear.lo, linear.hi}) {
        const double root = std::sqrt(std::max(b * b - 4.0 * a * constant, 0.0));
        // A double root is known to half the digits.
        constexpr double loose = 1e-7;
        const double pad = loose * (std::abs(b) + root);
        reach.lo = std::min(reach.lo, 0.5 * (-b - root - pad) / a);
        reach.hi = std::max(reach.hi, 0.5 * (-b + root + pad) / a);
    }
    return reach;
}

/// The same for a = 0.
Interval linear_reach(const Interval& linear, double constant) {
    Interval reach{-infinity, infinity};
    if (linear.lo > 0.0) reach.hi = std::max(-constant / linear.lo, -constant / linear.hi);
    if (linear.hi < 0.0) reach.lo = std::min(-constant / linear.lo, -constant / linear.hi);
    return reach;
}

/// From where to where along `axis` the form can be at most zero while the other coordinates lie in `region`,
/// which may leave those open along which the form is convex: an inequality with the least that they make of
/// its lower terms.
Interval reach_along(Form f, int axis, const Bounds& region) {
    constexpr Interval unknown{-infinity, infinity};
    const double largest =
        std::max({largest_magnitude(f.q[0]), largest_magnitude(f.q[1]), largest_magnitude(f.q[2])});
    constexpr double rounding = 1e-12;
    const auto square = [&](int i) { return f.q[static_cast<size_t>(i)][i]; };
    const std::array<int, 2> others{(axis + 1) % 3, (axis + 2) % 3};
    const auto is_open = [&](int i) { return !std::isfinite(region.lo[i]) || !std::isfinite(region.hi[i]); };
    double terms = std::abs(f.j);
    for (const int k : others) {
        if (!is_open(k)) continue;
        if (!(square(k) > rounding * largest)) return unknown;
        f = least_along(f, k);
        terms += std::abs(f.j);
    }
    const Vec3 far = glm::max(glm::abs(region.lo), glm::abs(region.hi));
    Interval linear{f.g[axis], f.g[axis]};
    double constant = f.j;
    double mixed = 2.0 * std::abs(f.q[static_cast<size_t>(others[0])][others[1]]);
    for (const int k : others) {
        if (is_open(k)) {
            mixed = 0.0;
            continue;
        }
        const double slope = 2.0 * f.q[static_cast<size_t>(axis)][k];
        linear.lo += std::min(slope * region.lo[k], slope * region.hi[k]);
        linear.hi += std::max(slope * region.lo[k], slope * region.hi[k]);
        constant += least_of(square(k), f.g[k], region.lo[k], region.hi[k]);
        terms += (std::abs(square(k)) * far[k] + std::abs(f.g[k])) * far[k];
        mixed *= far[k];
    }
    constant -= mixed + rounding * (terms + mixed);
    if (square(axis) == 0.0) return linear_reach(linear, constant);
    return square(axis) > rounding * largest ? reach_of(square(axis), linear, constant) : unknown;
}

/// The part of `region` in which the form can be at most zero, along axes on which the region is open.
Bounds part_within(const Form& f, const Bounds& region) {
    Bounds out = region;
    // What bounds one axis may help on another.
    constexpr int passes = 2;
    for (int i = 0; i < 3 * passes; ++i) {
        const int axis = i % 3;
        if (std::isfinite(out.lo[axis]) && std::isfinite(out.hi[axis])) continue;
        const Interval reach = reach_along(f, axis, out);
        out.lo[axis] = std::max(out.lo[axis], reach.lo);
        out.hi[axis] = std::min(out.hi[axis], reach.hi);
    }
    return out;
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
    Bounds bounds_within(const Bounds& region) const override {
        return part_within(form_.negated(), part_within(form_, intersection(box_, region)));
    }
    Bounds solid_bounds_within(const Bounds& region) const override {
        return part_within(form_, intersection(solid_bounds(), region));
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
