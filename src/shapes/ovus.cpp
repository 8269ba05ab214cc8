// ovus { B, T }   (manual 3.5.1.11): an egg about the y axis: a sphere of radius B around the origin, one of
// radius T around <0, B, 0>, and an arc turned about the axis that touches both
#include "shapes/frame.h"
#include "shapes/ray_shape.h"
#include "shapes/registry.h"
#include "shapes/revolve.h"

#include <algorithm>

#include <fmt/format.h>

namespace rb {

namespace {

/// The outline as (distance from the axis, height): three arcs.
class Egg {
public:
    Egg(double b, double t) : b_(b), t_(t), arc_(2.0 * std::max(b, t)), only_top_(t >= 2.0 * b) {
        if (only_top_) return;
        // spec: geometry 17
        const double v = b > t ? 2.0 * t - b - t * t / (2.0 * b) : b - 2.0 * t + 1.5 * t * t / b;
        const double h = std::sqrt(std::max(b > t ? b * b - v * v : t * t - (v - b) * (v - b), 0.0));
        center_ = {-h, v};
    }

    double bottom() const { return b_; }
    double top() const { return t_; }
    double arc() const { return arc_; }

    /// Signed distance, convex everywhere, and its gradient.
    struct Height {
        double distance;
        Vec2 outward;
    };
    Height height(const Vec2& p) const {
        const Arc a = arc_of(p - center_);
        const Vec2 n = p - a.center;
        const double length = glm::length(n);
        return {length - a.radius, length > 0.0 ? n / length : Vec2{0.0, 1.0}};
    }
    double distance(const Vec2& p) const { return height(p).distance; }
    /// How far the egg reaches along `n`.
    double support(const Vec2& n) const {
        const Arc a = arc_of(n);
        return glm::dot(n, a.center) + a.radius * glm::length(n);
    }
    /// A ball around the point at height middle() on the axis, touched by both poles, holds the egg.
    double middle() const { return only_top_ ? b_ : 0.5 * t_; }
    double reach() const {
        constexpr double rounding = 1e-9;
        return (1.0 + rounding) * (only_top_ ? t_ : b_ + 0.5 * t_);
    }
    /// True if the point of the surface nearest to `p` lies on the lower or upper sphere.
    bool is_on_sphere(const Vec2& p, bool upper) const {
        const Vec2 center = arc_of(p - center_).center;
        return center.x == 0.0 && center.y == (upper ? b_ : 0.0);
    }
    double widest() const { return std::max({arc_ + center_.x, b_, t_}); }

    /// From the lowest point to the highest; the outward normal turns by `step` at most.
    std::vector<Vec2> profile(int steps) const {
        std::vector<Vec2> points;
        for (int i = 0; i <= steps; ++i) {
            const double angle = pi * (static_cast<double>(i) / steps - 0.5);
            const Vec2 n{std::cos(angle), std::sin(angle)};
            const Arc a = arc_of(n);
            points.push_back(a.center + a.radius * n);
        }
        points.front().x = points.back().x = 0.0;
        return points;
    }

private:
    struct Arc {
        Vec2 center;
        double radius;
    };
    /// The arc whose sector, seen from the middle arc's centre, holds the direction.
    Arc arc_of(const Vec2& direction) const {
        const double h = -center_.x;
        if (!only_top_ && direction.y * h < -center_.y * direction.x) return {{0.0, 0.0}, b_};
        if (only_top_ || direction.y * h > (b_ - center_.y) * direction.x) return {{0.0, b_}, t_};
        return {center_, arc_};
    }

    double b_;
    double t_;
    double arc_;
    bool only_top_;
    Vec2 center_{0.0};
};

class Ovus final : public RayShape<Ovus> {
public:
    Ovus(const Frame& frame, const Egg& egg) : frame_(frame), egg_(egg) {}

    std::string_view keyword() const override { return "ovus"; }
    Curvature curvature() const override { return Curvature::convex; }

    Bounds bounds() const override {
        const auto& r = frame_.object_from_local.forward.row;
        Bounds box;
        for (int i = 0; i < 3; ++i) {
            const double across = std::hypot(r[0][i], r[2][i]);
            box.hi[i] = r[3][i] + egg_.support({across, r[1][i]});
            box.lo[i] = r[3][i] - egg_.support({across, -r[1][i]});
        }
        const Vec3 pad = 16.0 * std::numeric_limits<double>::epsilon() * (box.size() + glm::abs(r[3]));
        return {box.lo - pad, box.hi + pad};
    }
    Bounds language_extent() const override {
        const double r = egg_.widest();
        return rb::transformed(Bounds{{-r, -egg_.bottom(), -r}, {r, egg_.bottom() + egg_.top(), r}},
                               frame_.object_from_local.forward);
    }
    bool inside(const Vec3& p) const override { return egg_.distance(flat(frame_.local_point(p))) <= 0.0; }

    template <class Sink>
    void each_crossing(const ShapeRay& query, Sink&& sink) const {
        const Vec3 d = frame_.local_direction(query.ray.direction);
        const Vec3 o = frame_.local_point(query.ray.origin);
        const bool here = starts_here(query, o);
        const double inverse_dd = 1.0 / glm::dot(d, d);
        const Vec3 from = o - Vec3{0.0, egg_.middle(), 0.0};
        const double place = -glm::dot(from, d) * inverse_dd;
        const Vec3 foot = from + place * d;
        const double room = egg_.reach() * egg_.reach() - glm::dot(foot, foot);
        const double half = std::sqrt(std::max(room, 0.0) * inverse_dd);
        if (here) {
            if (!(glm::dot(d, gradient(o)) < 0.0)) return;
            const Line line{o, d, inverse_dd, egg_.distance(flat(o))};
            double out = place + half;
            meets(line, 1.0, out);
            sink(out, 0u, Vec2{0.0});
            return;
        }
        if (!(room > 0.0) || !(half > -place) || place - half > sink.reach()) return;
        const Line line{foot + Vec3{0.0, egg_.middle(), 0.0}, d, inverse_dd, 0.0};
        double in = -half;
        if (!meets(line, -1.0, in)) return;
        sink(place + in, 0u, Vec2{0.0});
        if (sink.reach() <= place + in) return;
        double out = half;
        meets(line, 1.0, out);
        sink(place + out, 0u, Vec2{0.0});
    }

    Vec3 normal(const Vec3& p, const Crossing&) const override {
        return frame_.normal(gradient(frame_.local_point(p)));
    }

    std::optional<Vec2> uv(const Vec3& p, const Crossing&) const override {
        // A sphere's, around the middle of the upper radius.
        const Vec3 q = glm::normalize(frame_.local_point(p) - Vec3{0.0, 0.5 * egg_.top(), 0.0});
        return Vec2{turn_share(q.x, q.z), 0.5 + std::asin(glm::clamp(q.y, -1.0, 1.0)) / pi};
    }

    ShapePtr transformed(const Transform& map) const override {
        return std::make_shared<Ovus>(Frame(then(frame_.object_from_local, map)), egg_);
    }

    std::optional<TriangleMesh> tessellate(double tolerance) const override {
        const Affine upright{{Vec3{1, 0, 0}, Vec3{0, 0, 1}, Vec3{0, 1, 0}, Vec3{0.0}}};
        const Affine place = then(upright, frame_.object_from_local.forward);
        const double scale = stretch(place);
        const double wide = egg_.widest();
        const double arc = std::max(egg_.arc(), egg_.top());
        // Filip's bound as for round_mesh(): no arc is larger than these.
        const double s = std::max(tolerance / scale, 1e-6 * arc);
        constexpr double most = 2000.0;
        const double turns = std::min(std::ceil(2.0 * pi / std::sqrt(s / arc)), most);
        const double steps = std::min(std::ceil(pi / std::sqrt(s / arc)), most);
        TriangleMesh mesh =
            revolve(egg_.profile(static_cast<int>(steps)), false, static_cast<int>(turns), place);
        const double a = 2.0 * pi / turns;
        // A step may pass over the joint of two arcs: each is then shorter.
        const double b = pi / steps;
        mesh.error += scale * (a * a * wide + 2.0 * a * b * arc + b * b * arc) / 8.0;
        return mesh;
    }

    std::string describe() const override {
        const Vec3 c = frame_.object_from_local.forward.row[3];
        return fmt::format("radii {} {} at <{},{},{}>", egg_.bottom(), egg_.top(), c.x, c.y, c.z);
    }

private:
    /// A line in the frame; the egg is `level` larger.
    struct Line {
        Vec3 p;
        Vec3 d;
        double inverse_dd;
        double level;
        Vec3 at(double t) const { return p + t * d; }
    };

    /// Where the line enters (side -1) or leaves (1) the egg; false if it misses it. `t` is given outside.
    bool meets(const Line& line, double side, double& t) const {
        double start = t;
        bool is_inside = false;
        for (const bool upper : {false, true}) {
            const double radius = (upper ? egg_.top() : egg_.bottom()) + line.level;
            const Vec3 from = line.p - Vec3{0.0, upper ? egg_.bottom() : 0.0, 0.0};
            const double middle = -glm::dot(from, line.d) * line.inverse_dd;
            const Vec3 foot = from + middle * line.d;
            const double chord = radius * radius - glm::dot(foot, foot);
            if (!(chord >= 0.0)) continue;
            const double end = middle + side * std::sqrt(chord * line.inverse_dd);
            if (egg_.is_on_sphere(flat(line.at(end)), upper)) {
                t = end;
                return true;
            }
            if (!is_inside || end * side > start * side) start = end;
            is_inside = true;
        }
        return meets_arc(line, side, is_inside, start, t);
    }

    /// On the middle arc, by Newton's method: on a convex function its first step from within goes beyond the
    /// root and no later one passes it.
    bool meets_arc(const Line& line, double side, bool is_inside, double start, double& t) const {
        const double enough =
            std::numeric_limits<double>::epsilon() * egg_.reach() * std::sqrt(line.inverse_dd);
        const double outside = t;
        t = start;
        constexpr int most = 40;
        for (int i = 0; i < most; ++i) {
            const Vec3 p = line.at(t);
            const Vec2 at = flat(p);
            const Egg::Height height = egg_.height(at);
            const double f = height.distance - line.level;
            const double slope = glm::dot(line.d, gradient(p, at, height.outward));
            if (i == 0 && is_inside) {
                const double next = t - f / slope;
                t = slope * side > 0.0 && f < 0.0 && next * side < outside * side ? next : outside;
                continue;
            }
            if (f <= 0.0) break;
            if (!(slope * side > 0.0)) return false;
            t -= f / slope;
            if (f <= enough * std::abs(slope)) break;
        }
        return true;
    }

    static Vec2 flat(const Vec3& p) { return {std::sqrt(p.x * p.x + p.z * p.z), p.y}; }
    Vec3 gradient(const Vec3& p) const {
        const Vec2 at = flat(p);
        return gradient(p, at, egg_.height(at).outward);
    }
    static Vec3 gradient(const Vec3& p, const Vec2& at, const Vec2& n) {
        const double share = at.x > 0.0 ? n.x / at.x : 0.0;
        return {share * p.x, n.y, share * p.z};
    }
    bool starts_here(const ShapeRay& query, const Vec3& o) const {
        if (query.starts_on_surface) return true;
        if (!(query.origin_error > 0.0)) return false;
        const double error = query.origin_error * std::max(frame_.radial_stretch, frame_.axial_stretch);
        const Vec3 from = o - Vec3{0.0, egg_.middle(), 0.0};
        const double reach = egg_.reach() + error;
        if (glm::dot(from, from) > reach * reach) return false;
        return std::abs(egg_.distance(flat(o))) <= error;
    }

    Frame frame_;
    Egg egg_;
};

ShapePtr read(BlockReader& in) {
    const SourceRange at = in.where();
    const double bottom = in.number();
    const double top = in.number();
    if (bottom < 0.0 || top < 0.0) in.fail_at(at, "Both ovus radii must be positive.");
    if (top >= 2.0 * bottom)
        in.diagnostics().warning(at, "The upper sphere of the ovus holds the lower one.");
    return std::make_shared<Ovus>(Frame(Transform{}), Egg(bottom, top));
}

}  // namespace

namespace shapes {
extern const ShapeKind ovus;
const ShapeKind ovus{"ovus", read, "ovus { 0.6, 0.35 }"};
}  // namespace shapes

}  // namespace rb
