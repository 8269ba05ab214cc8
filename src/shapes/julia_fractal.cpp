// julia_fractal { <C> [quaternion|hypercomplex] [sqr|cube|exp|...|pwr(X,Y)] [max_iteration N] [precision F]
//   [slice <N>, D] }        (manual 3.5.1.8)
#include "shapes/convex_ray.h"
#include "shapes/julia_orbit.h"
#include "shapes/mesh_refinement.h"
#include "shapes/registry.h"
#include "shapes/solid_mesh.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace rb {

namespace {

/// The three dimensional slice through four dimensional space: w = (distance - n . p) / n_w.
struct Slice {
    Quaternion normal{0, 0, 0, 1};  ///< unit
    double distance = 0;

    Quaternion at(const Vec3& p) const {
        return {p.x, p.y, p.z, (distance - glm::dot(Vec3{normal}, p)) / normal.w};
    }
    /// How much longer a way may be in four dimensions.
    double stretch() const { return 1.0 / std::abs(normal.w); }
};

/// The solid of points that do not escape, within the ball outside of which all do. A ray's way is left out
/// where reach() proves that nothing changes, and else gone through in small steps.
class JuliaFractal final : public Shape, private PointSolid {
public:
    JuliaFractal(const JuliaFormula& formula, Slice slice, double precision)
        : formula_(formula), slice_(slice), resolution_(1.0 / (steps_per_precision * precision)) {
        const double r = formula_.radius();
        if (!formula_.has_reach()) {
            bounds_ = {Vec3{-r}, Vec3{r}};
            return;
        }
        constexpr int levels = 5;
        add_cells(Vec3{0.0}, r, levels);
    }

    std::string_view keyword() const override { return "julia_fractal"; }
    NormalRule normal_rule() const override { return NormalRule::of_iterate; }
    Bounds bounds() const override { return bounds_; }
    Bounds language_extent() const override { return {Vec3{-formula_.radius()}, Vec3{formula_.radius()}}; }
    bool inside(const Vec3& p) const override { return formula_.stays(slice_.at(p)); }
    void crossings(const ShapeRay& ray, Crossings& out) const override {
        each_crossing(ray, [&](double t) {
            if (t > ray.t_max) return false;
            if (t > ray.t_min) out.add({t, 0, Vec2{0.0}});
            return true;
        });
    }
    bool closest(const ShapeRay& ray, const CrossingFilter* filter, Crossing& nearest) const override {
        bool found = false;
        each_crossing(ray, [&](double t) {
            if (t > ray.t_max) return false;
            const Crossing crossing{t, 0, Vec2{0.0}};
            if (!(t > ray.t_min) || (filter && !filter->counts(crossing))) return true;
            nearest = crossing;
            found = true;
            return false;
        });
        return found;
    }
    Vec3 normal(const Vec3& p, const Crossing&) const override { return formula_.normal(slice_.at(p)); }
    std::optional<TriangleMesh> tessellate(double tolerance) const override {
        // Every face has to be as small as the tolerance.
        if (!(bounds_.half_area() < most_mesh_faces * tolerance * tolerance)) return std::nullopt;
        return solid_mesh(*this, bounds_, tolerance);
    }
    std::string describe() const override {
        const Quaternion& c = formula_.c;
        return fmt::format("<{},{},{},{}> {} max_iteration {}", c.x, c.y, c.z, c.w,
                           formula_.algebra == JuliaAlgebra::quaternion ? "quaternion" : "hypercomplex",
                           formula_.steps);
    }

private:
    static constexpr double steps_per_precision = 4.0;

    /// A fractal has none.
    std::optional<Slopes> slopes(const Bounds&) const override { return std::nullopt; }

    /// Widens the bounds by the cells that may hold a part of the solid.
    void add_cells(const Vec3& middle, double half, int levels) {
        const Bounds cell{middle - half, middle + half};
        if (bounds_.contains(cell.lo) && bounds_.contains(cell.hi)) return;
        const auto reach = formula_.reach(slice_.at(middle), 0.01 * half);
        if (!reach.stays && reach.distance > std::sqrt(3.0) * half * slice_.stretch()) return;
        if (levels == 0) {
            bounds_.include(cell);
            return;
        }
        for (int k = 0; k < 8; ++k) {
            const Vec3 side{k & 1 ? 1.0 : -1.0, k & 2 ? 1.0 : -1.0, k & 4 ? 1.0 : -1.0};
            add_cells(middle + 0.5 * half * side, 0.5 * half, levels - 1);
        }
    }

    /// The ray's way within ball and box, after what lies too near to a surface at its origin to be told.
    bool enters(const ShapeRay& query, double& from, double& to) const {
        const Vec3& o = query.ray.origin;
        const Vec3& d = query.ray.direction;
        const double dd = glm::dot(d, d);
        const double middle = -glm::dot(o, d) / dd;
        const Vec3 foot = o + middle * d;
        // The ball itself is no surface.
        const double r = formula_.radius() * (1.0 - 1e-9);
        const double chord = r * r - glm::dot(foot, foot);
        if (!(chord > 0.0)) return false;
        const double half = std::sqrt(chord / dd);
        from = std::max(middle - half, 0.0);
        to = middle + half;
        for (int i = 0; i < 3; ++i) {
            if (d[i] == 0.0) {
                if (o[i] < bounds_.lo[i] || o[i] > bounds_.hi[i]) return false;
                continue;
            }
            const double a = (bounds_.lo[i] - o[i]) / d[i];
            const double b = (bounds_.hi[i] - o[i]) / d[i];
            from = std::max(from, std::min(a, b));
            to = std::min(to, std::max(a, b));
        }
        if (query.starts_on_surface || query.origin_error > 0.0) {
            const double least = std::max(1e-7 * formula_.radius(), 100.0 * query.origin_error);
            from = std::max(from, least / std::sqrt(dd));
        }
        return from < to;
    }

    /// Between a and b, where it changes: to the last bits.
    double change_between(const Ray& ray, double a, double b, bool stays_at_a) const {
        const auto at = [&](double t) { return slice_.at(ray.at(t)); };
        // Several tests may change within: halving comes to where the first one to fail does alone.
        constexpr int halvings = 14;
        for (int i = 0; i < halvings; ++i) {
            const double t = 0.5 * (a + b);
            (formula_.stays(at(t)) == stays_at_a ? a : b) = t;
        }
        const size_t step = formula_.escape_step(at(stays_at_a ? b : a));
        const auto excess = [&](double t) { return formula_.excess(at(t), step); };
        return bracketed_root(excess, a, excess(a), b, excess(b));
    }

    template <class Take>
    void each_crossing(const ShapeRay& query, Take&& take) const {
        double from = 0.0;
        double to = 0.0;
        if (!enters(query, from, to)) return;
        const double length = glm::length(query.ray.direction);
        const double least = resolution_ / length;
        const double to_t = 1.0 / (length * slice_.stretch());
        double t = from;
        JuliaFormula::Reach here = look(query.ray, t);
        while (t < to && t <= query.t_max) {
            const double next = std::min(t + std::max(least, here.distance * to_t), to);
            const JuliaFormula::Reach there = look(query.ray, next);
            if (there.stays != here.stays && !take(change_between(query.ray, t, next, here.stays))) return;
            t = next;
            here = there;
        }
    }

    JuliaFormula::Reach look(const Ray& ray, double t) const {
        const Quaternion q = slice_.at(ray.at(t));
        return formula_.has_reach() ? formula_.reach(q, resolution_ * slice_.stretch())
                                    : JuliaFormula::Reach{formula_.stays(q), 0.0};
    }

    JuliaFormula formula_;
    Slice slice_;
    double resolution_;  ///< what is thinner may be missed
    Bounds bounds_;
};

/// A float spreads, a short vector is filled with 0.
Quaternion take_quaternion(BlockReader& in) {
    const SourceRange at = in.where();
    const Terms terms = in.terms();
    if (terms.count > 4) in.fail_at(at, "Vector of four terms expected but color expression found.");
    if (terms.count == 1) return Quaternion{terms.v[0]};
    return {terms.v[0], terms.v[1], terms.v[2], terms.v[3]};
}

bool take_function(BlockReader& in, JuliaFormula& formula) {
    constexpr std::array<std::string_view, 17> words{"sqr",   "cube", "exp",   "ln",   "reciprocal", "sin",
                                                     "asin",  "sinh", "asinh", "cos",  "acos",       "cosh",
                                                     "acosh", "tan",  "atan",  "tanh", "atanh"};
    for (size_t i = 0; i < words.size(); ++i) {
        if (!in.take_word(words[i])) continue;
        formula.function = static_cast<JuliaFunction>(i);
        return true;
    }
    if (!in.take_word("pwr")) return false;
    formula.function = JuliaFunction::pwr;
    const Vec2 exponent = in.vec2();
    formula.exponent = {exponent.x, exponent.y};
    return true;
}

ShapePtr read(BlockReader& in) {
    JuliaFormula formula;
    Slice slice;
    double iterations = 20;
    double precision = 20;
    formula.c = take_quaternion(in);
    SourceRange function_at = in.where();
    for (;;) {
        const SourceRange at = in.where();
        if (in.take_word("quaternion")) {
            formula.algebra = JuliaAlgebra::quaternion;
        } else if (in.take_word("hypercomplex")) {
            formula.algebra = JuliaAlgebra::hypercomplex;
        } else if (in.take_word("max_iteration")) {
            iterations = std::max(std::floor(in.number()), 1.0);
            constexpr double most = 10000.0;
            if (!(iterations <= most)) in.fail_at(at, "max_iteration must be 10000 at most.");
        } else if (in.take_word("precision")) {
            precision = std::max(in.number(), 1.0);
            constexpr double most = 1e6;
            if (!(precision <= most)) in.fail_at(at, "precision must be 1000000 at most.");
        } else if (in.take_word("slice")) {
            const Quaternion n = take_quaternion(in);
            slice.distance = in.number();
            const double length = glm::length(n);
            if (!(length > 0.0)) in.fail_at(at, "Slice vector is zero.");
            slice.normal = n / length;
            if (std::abs(slice.normal.w) < 1e-10) in.fail_at(at, "Slice t component is zero.");
        } else if (take_function(in, formula)) {
            function_at = at;
        } else {
            break;
        }
    }
    if (formula.algebra == JuliaAlgebra::quaternion && !formula.has_reach()) {
        in.fail_at(function_at, "Illegal function: quaternion only supports sqr and cube.");
    }
    formula.steps = static_cast<size_t>(iterations);
    return std::make_shared<JuliaFractal>(formula, slice, precision);
}

}  // namespace

namespace shapes {
extern const ShapeKind julia_fractal;
const ShapeKind julia_fractal{"julia_fractal", read,
                              "julia_fractal { <-0.083, 0, -0.83, -0.025> quaternion sqr max_iteration 4 "
                              "precision 50 }"};
}  // namespace shapes

}  // namespace rb
