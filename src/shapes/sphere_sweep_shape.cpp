#include "shapes/sphere_sweep_shape.h"

#include "math/interval.h"
#include "shapes/ray_shape.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace rb {

namespace {

/// Parts about as long as they are thick: their bounding balls hold little else.
int parts_of(const SweepPiece& piece) {
    double length = 0.0;
    double radius = 0.0;
    for (size_t i = 0; i < 4; ++i) {
        if (i > 0) length += glm::length(Vec3{piece.control[i] - piece.control[i - 1]});
        radius = std::max(radius, std::abs(piece.control[i].w));
    }
    constexpr double most = 8.0;
    const double parts = std::ceil(0.5 * length / radius);
    // Nothing is as thick as points without radius.
    return parts < most ? std::max(static_cast<int>(parts), 1) : static_cast<int>(most);
}

}  // namespace

SphereSweep::SphereSweep(std::vector<SweepPiece> pieces, const Bounds& extent)
    : pieces_(std::move(pieces)), extent_(extent) {
    std::vector<SweepBound> bounds;
    for (uint32_t i = 0; i < pieces_.size(); ++i) {
        bounds_.include(pieces_[i].box());
        const int parts = parts_of(pieces_[i]);
        for (int k = 0; k < parts; ++k) {
            const double lo = static_cast<double>(k) / parts;
            const double hi = static_cast<double>(k + 1) / parts;
            ranges_.push_back({i, lo, hi});
            bounds.push_back(SweepBound::around(pieces_[i], lo, hi));
        }
    }
    tree_ = RangeTree<SweepBound>(bounds);
}

template <class Take>
void SphereSweep::each_range_on(const ShapeRay& ray, double length, Take&& take) const {
    const Vec3 along = ray.ray.direction / length;
    const double from = ray.t_min * length;
    const double to = ray.t_max * length;
    const auto meets = [&](const SweepBound& bound) {
        const Vec3 c = bound.center - ray.ray.origin;
        const double place = glm::dot(c, along);
        const double cc = glm::dot(c, c);
        constexpr double rounding = 1e-12;
        const double margin = rounding * cc;
        if (cc - place * place > bound.radius * bound.radius + margin) return false;
        const double reach = bound.radius + rounding * (std::abs(place) + bound.radius);
        return place + reach >= from && place - reach <= to;
    };
    each_range(meets, take);
}

bool SphereSweep::may_hold(const Vec3& p) const {
    if (!bounds_.contains(p)) return false;
    bool found = false;
    tree_.visit(
        [&](const SweepBound& bound) {
            const Vec3 c = bound.center - p;
            constexpr double room = 1.0 + 1e-9;
            return !found && glm::dot(c, c) <= room * bound.radius * bound.radius;
        },
        [&](uint32_t) { found = true; });
    return found;
}

bool SphereSweep::inside(const Vec3& p) const {
    return std::ranges::any_of(pieces_, [&](const SweepPiece& piece) {
        const auto index = static_cast<uint32_t>(&piece - pieces_.data());
        return piece.box().contains(p) && deepest(piece, {index, 0.0, 1.0}, p).level <= 0.0;
    });
}

/// The ball on whose surface a ray starts.
struct SphereSweep::Start {
    double level;  ///< what its squared radius lacks or has too much, so that the origin lies on it
    uint32_t piece;
    double w;
};

std::optional<SphereSweep::Start> SphereSweep::start_of(const ShapeRay& ray) const {
    if (!ray.starts_on_surface && !(ray.origin_error > 0.0)) return std::nullopt;
    const Vec3& o = ray.ray.origin;
    uint32_t first = 0;
    auto last = static_cast<uint32_t>(pieces_.size());
    if (ray.starts_on_surface && ray.origin_part != any_part) {
        // A joint belongs to both pieces.
        first = ray.origin_part - std::min<uint32_t>(ray.origin_part, 1);
        last = std::min(ray.origin_part + 2, last);
    }
    Start best{std::numeric_limits<double>::infinity(), 0, 0.0};
    const auto look = [&](const SweepRange& range) {
        if (range.piece < first || range.piece >= last) return;
        const DeepestBall found = deepest(pieces_[range.piece], range, o);
        if (found.level < best.level) best = {found.level, range.piece, found.w};
    };
    each_range(
        [&](const SweepBound& bound) {
            constexpr double room = 1.0 + 1e-6;
            const double reach = room * bound.radius + ray.origin_error;
            const Vec3 c = bound.center - o;
            return glm::dot(c, c) <= reach * reach;
        },
        look);
    if (ray.starts_on_surface && !std::isfinite(best.level)) {
        for (uint32_t i = first; i < last; ++i) look({i, 0.0, 1.0});
    }
    if (!std::isfinite(best.level)) return std::nullopt;
    const Vec3 center{pieces_[best.piece].at(best.w)};
    if (!ray.starts_on_surface && std::abs(best.level) > 2.0 * ray.origin_error * glm::length(o - center))
        return std::nullopt;
    return best;
}

/// How far the ray runs within the ball where it starts; not positive if it leaves it.
double SphereSweep::way_through(const Start& start, const RayFrame& frame) const {
    const Vec3 center{pieces_[start.piece].at(start.w)};
    return 2.0 * glm::dot(center - frame.origin, frame.along);
}

/// Whether a way that a ray along the surface is on at its start is no longer than rounding makes it: a ball
/// of radius r that lacks e gives one of 2 sqrt(2 r e). Who leaves the ball where he starts may be in another
/// one by the error of his place; who enters it, by the last bits of its radius.
bool SphereSweep::is_rounding(const Way& way, const Start& start, bool leaves, const ShapeRay& ray) const {
    if (way.in > 0.0) return false;
    const double r = glm::length(ray.ray.origin - Vec3{pieces_[start.piece].at(start.w)});
    const double e = leaves ? ray.origin_error : std::numeric_limits<double>::epsilon() * r;
    const double length = way.out - way.in;
    return length * length <= 8.0 * r * e;
}

void SphereSweep::crossings(const ShapeRay& ray, Crossings& out) const {
    const RayFrame frame(ray.ray.origin, ray.ray.direction);
    const auto start = start_of(ray);
    thread_local std::vector<Way> ways;
    ways.clear();
    const SweepQuestion question{frame, start.has_value(), start ? start->level : 0.0};
    each_range_on(ray, frame.length,
                  [&](const SweepRange& range) { add_ways(pieces_[range.piece], range, question, ways); });
    bool leaves = false;
    if (start) {
        // The way through the ball at the origin: its entry is there, and no answer.
        const double through = way_through(*start, frame);
        leaves = !(through > 0.0);
        if (!leaves) ways.push_back({0.0, through, start->piece, start->piece, start->w, start->w});
    }
    std::ranges::sort(ways, {}, &Way::in);
    const auto add = [&](double distance, uint32_t piece, double w) {
        const double t = distance / frame.length;
        if (t > ray.t_min && t <= ray.t_max) out.add({t, piece, Vec2{w, 0.0}});
    };
    const double first = next_above(ray.t_min * frame.length * (1.0 + 1e-12));
    for (size_t i = 0; i < ways.size();) {
        Way way = ways[i++];
        for (; i < ways.size() && ways[i].in <= way.out; ++i) {
            if (ways[i].out <= way.out) continue;
            way.out = ways[i].out;
            way.out_piece = ways[i].out_piece;
            way.out_w = ways[i].out_w;
        }
        if (start && is_rounding(way, *start, leaves, ray)) continue;
        // Who has left has entered what he leaves next, however near.
        add(leaves ? std::max(way.in, first) : way.in, way.in_piece, way.in_w);
        add(way.out, way.out_piece, way.out_w);
    }
}

bool SphereSweep::any(const ShapeRay& ray, const CrossingFilter* filter, Crossing& found) const {
    const auto end_is_outside = [&] {
        return !(ray.t_max < std::numeric_limits<double>::max()) ||
               !may_hold(ray.ray.origin + ray.t_max * ray.ray.direction);
    };
    const auto start = start_of(ray);
    // Where both ends lie outside, any ball between them is entered.
    if (filter || !end_is_outside() || (!start && may_hold(ray.ray.origin + ray.t_min * ray.ray.direction)))
        return closest(ray, filter, found);
    const RayFrame frame(ray.ray.origin, ray.ray.direction);
    const auto take = [&](double distance, uint32_t piece, double w) {
        found = {distance / frame.length, piece, Vec2{w, 0.0}};
        return found.t > ray.t_min && found.t <= ray.t_max;
    };
    const double through = start ? way_through(*start, frame) : 0.0;
    const bool enters = through > 0.0 && !is_rounding(Way{.out = through}, *start, false, ray);
    if (enters && take(through, start->piece, start->w)) return true;
    const SweepQuestion question{frame, start.has_value(), start ? start->level : 0.0};
    const auto is_hit_by = [&](const Way& way) {
        if (start && is_rounding(way, *start, !(through > 0.0), ray)) return false;
        // Who has left the surface enters a ball ahead of it, however near.
        return (start &&
                take(std::max(way.in, std::numeric_limits<double>::min()), way.in_piece, way.in_w)) ||
               take(way.in, way.in_piece, way.in_w) || take(way.out, way.out_piece, way.out_w);
    };
    thread_local std::vector<Way> ways;
    bool is_met = false;
    bool is_doubtful = false;
    each_range_on(ray, frame.length, [&](const SweepRange& range) {
        if (is_met) return;
        ways.clear();
        add_balls(pieces_[range.piece], range, question, ways);
        is_met = std::ranges::any_of(ways, is_hit_by);
        is_doubtful = is_doubtful || !(is_met || ways.empty());
    });
    return is_met || (is_doubtful && closest(ray, filter, found));
}

Vec3 SphereSweep::normal(const Vec3& p, const Crossing& at) const {
    const Vec3 n = p - Vec3{pieces_[at.part].at(at.at.x)};
    return n == Vec3{0.0} ? Vec3{1, 0, 0} : n;
}

ShapePtr SphereSweep::transformed(const Transform& map) const {
    const double scale = similarity_scale(map.forward);
    if (scale == 0.0) return nullptr;
    std::vector<SweepPiece> moved;
    moved.reserve(pieces_.size());
    const auto ball = [&](const Ball& b) { return Ball{map.point(Vec3{b}), scale * b.w}; };
    for (const SweepPiece& piece : pieces_) {
        const auto& c = piece.control;
        moved.push_back(piece.is_straight
                            ? SweepPiece::straight(ball(c[0]), ball(c[3]))
                            : SweepPiece::bezier({ball(c[0]), ball(c[1]), ball(c[2]), ball(c[3])}));
    }
    return std::make_shared<SphereSweep>(std::move(moved), rb::transformed(extent_, map.forward));
}

std::string SphereSweep::describe() const { return fmt::format("{} pieces", pieces_.size()); }

}  // namespace rb
