// julia_fractal { <C> [quaternion|hypercomplex] [sqr|cube|exp|...|pwr(X,Y)] [max_iteration N] [precision F]
//   [slice <N>, D] }        (manual 3.5.1.8)
#include "shapes/convex_ray.h"
#include "shapes/julia_orbit.h"
#include "shapes/mesh_refinement.h"
#include "shapes/registry.h"
#include "shapes/solid_mesh.h"

#include <algorithm>
#include <bit>
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
        : formula_(formula), slice_(slice), resolution_(1.0 / (steps_per_precision(formula) * precision)) {
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
    /// Where many are taken at once they may be smaller.
    static double steps_per_precision(const JuliaRule& rule) { return rule.has_reach() ? 7.0 : 4.0; }

    /// A fractal has none.
    std::optional<GradientBound> slopes(const Bounds&) const override { return std::nullopt; }

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

    /// To a ninth of the way, where it changes first.
    void narrow(const Ray& ray, double& a, double& b, bool stays_at_a) const {
        constexpr size_t count = JuliaFormula::places_at_once;
        const double share = (b - a) / static_cast<double>(count + 1);
        std::array<Quaternion, count> places;
        const auto place = [&](size_t k) { return a + static_cast<double>(k + 1) * share; };
        for (size_t k = 0; k < count; ++k) places[k] = slice_.at(ray.at(place(k)));
        const uint32_t staying = formula_.orbits_of(places).staying;
        const uint32_t changed = (stays_at_a ? ~staying : staying) & ((1u << count) - 1);
        const auto first = static_cast<size_t>(std::countr_zero(changed));
        const double end = changed != 0 ? place(first) : b;
        a = changed == 0 ? place(count - 1) : first > 0 ? place(first - 1) : a;
        b = end;
    }

    /// Between a and b, where it changes: to the last bits.
    double change_between(const Ray& ray, double a, double b, bool stays_at_a) const {
        const auto at = [&](double t) { return slice_.at(ray.at(t)); };
        // Several tests may change within: narrowing comes to where the first one to fail does alone.
        if (formula_.has_reach()) {
            constexpr int rounds = 4;
            for (int i = 0; i < rounds; ++i) narrow(ray, a, b, stays_at_a);
        } else {
            constexpr int halvings = 14;
            for (int i = 0; i < halvings; ++i) {
                const double t = 0.5 * (a + b);
                (formula_.stays(at(t)) == stays_at_a ? a : b) = t;
            }
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
        // Small steps many at once are quicker than one that is hardly longer.
        const double worth = JuliaFormula::places_at_once * least;
        Place place = place_at(query.ray, from);
        while (place.here.t < to && place.here.t <= query.t_max) {
            const double known = place.known * to_t;
            const bool goes_on = formula_.has_reach() && known < worth
                                     ? take_steps(query.ray, place, least, to, take)
                                     : take_step(query.ray, place, std::max(least, known), to, take);
            if (!goes_on) return;
        }
    }

    struct Sample {
        double t = 0;
        bool stays = false;
        double largest = std::numeric_limits<double>::quiet_NaN();  ///< of its orbit; nan: not known
    };
    /// The last two samples of a ray, and how far from the last all is proven to do the same.
    struct Place {
        Sample before;
        Sample here;
        double known = 0;
    };

    template <class Take>
    bool take_step(const Ray& ray, Place& place, double step, double to, const Take& take) const {
        const Sample last = place.here;
        place = place_at(ray, std::min(last.t + step, to));
        return take_change(ray, last, place.here, take);
    }

    /// Several of the least length, where nothing is known of the way.
    template <class Take>
    bool take_steps(const Ray& ray, Place& place, double step, double to, const Take& take) const {
        for (const Sample& next : samples(ray, place.here.t, step, to)) {
            if (may_touch(place.before, place.here, next) && !look_closely(ray, place.before, next, take))
                return false;
            if (!take_change(ray, place.here, next, take)) return false;
            place.before = place.here;
            place.here = next;
        }
        place.known = reach(ray, place.here.t).distance;
        return true;
    }

    template <class Take>
    bool take_change(const Ray& ray, const Sample& a, const Sample& b, const Take& take) const {
        return a.stays == b.stays || take(change_between(ray, a.t, b.t, a.stays));
    }

    /// Between samples that do the same orbits come so near to doing otherwise that they may in between.
    bool may_touch(const Sample& a, const Sample& b, const Sample& c) const {
        if (a.stays != b.stays || b.stays != c.stays) return false;
        const double limit = formula_.escape();
        const auto gap = [&](const Sample& s) { return s.stays ? limit - s.largest : s.largest - limit; };
        const double least = gap(b);
        // A parabola would come nearer by an eighth of that rise at most.
        return least < gap(a) && least <= gap(c) && 4.0 * least < std::max(gap(a), gap(c)) - least;
    }

    /// In smaller steps.
    template <class Take>
    bool look_closely(const Ray& ray, Sample from, const Sample& to, const Take& take) const {
        constexpr size_t count = JuliaFormula::places_at_once;
        for (const Sample& next :
             samples(ray, from.t, (to.t - from.t) / static_cast<double>(count + 1), to.t)) {
            if (!take_change(ray, from, next, take)) return false;
            from = next;
        }
        return take_change(ray, from, to, take);
    }

    std::array<Sample, JuliaFormula::places_at_once> samples(const Ray& ray, double from, double step,
                                                             double to) const {
        constexpr size_t count = JuliaFormula::places_at_once;
        std::array<Sample, count> out;
        std::array<Quaternion, count> places;
        for (size_t k = 0; k < count; ++k) {
            out[k].t = std::min(from + static_cast<double>(k + 1) * step, to);
            places[k] = slice_.at(ray.at(out[k].t));
        }
        const JuliaFormula::Orbits orbits = formula_.orbits_of(places);
        for (size_t k = 0; k < count; ++k) {
            out[k].stays = (orbits.staying >> k & 1) != 0;
            out[k].largest = orbits.largest[k];
        }
        return out;
    }

    /// What happens at a place, and in its neighbourhood.
    JuliaFormula::Reach reach(const Ray& ray, double t) const {
        const Quaternion q = slice_.at(ray.at(t));
        if (!formula_.has_reach()) return {formula_.stays(q), 0.0};
        const double worth = JuliaFormula::places_at_once * resolution_ * slice_.stretch();
        return formula_.reach(q, worth);
    }
    /// A place that nothing is known before.
    Place place_at(const Ray& ray, double t) const {
        const JuliaFormula::Reach around = reach(ray, t);
        Place place;
        place.here.t = t;
        place.here.stays = around.stays;
        place.known = around.distance;
        return place;
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

bool take_function(BlockReader& in, JuliaRule& rule) {
    constexpr std::array<std::string_view, 17> words{"sqr",   "cube", "exp",   "ln",   "reciprocal", "sin",
                                                     "asin",  "sinh", "asinh", "cos",  "acos",       "cosh",
                                                     "acosh", "tan",  "atan",  "tanh", "atanh"};
    for (size_t i = 0; i < words.size(); ++i) {
        if (!in.take_word(words[i])) continue;
        rule.function = static_cast<JuliaFunction>(i);
        return true;
    }
    if (!in.take_word("pwr")) return false;
    rule.function = JuliaFunction::pwr;
    const Vec2 exponent = in.vec2();
    rule.exponent = {exponent.x, exponent.y};
    return true;
}

ShapePtr read(BlockReader& in) {
    JuliaRule rule;
    Slice slice;
    double iterations = 20;
    double precision = 20;
    rule.c = take_quaternion(in);
    SourceRange function_at = in.where();
    for (;;) {
        const SourceRange at = in.where();
        if (in.take_word("quaternion")) {
            rule.algebra = JuliaAlgebra::quaternion;
        } else if (in.take_word("hypercomplex")) {
            rule.algebra = JuliaAlgebra::hypercomplex;
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
        } else if (take_function(in, rule)) {
            function_at = at;
        } else {
            break;
        }
    }
    if (rule.algebra == JuliaAlgebra::quaternion && !rule.has_reach()) {
        in.fail_at(function_at, "Illegal function: quaternion only supports sqr and cube.");
    }
    rule.steps = static_cast<size_t>(iterations);
    return std::make_shared<JuliaFractal>(JuliaFormula(rule), slice, precision);
}

}  // namespace

namespace shapes {
extern const ShapeKind julia_fractal;
const ShapeKind julia_fractal{"julia_fractal", read,
                              "julia_fractal { <-0.083, 0, -0.83, -0.025> quaternion sqr max_iteration 4 "
                              "precision 50 }"};
}  // namespace shapes

}  // namespace rb
