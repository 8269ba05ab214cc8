#include "shapes/convex_ray.h"
#include "shapes/isosurface.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace rb {

namespace {

constexpr uint32_t sphere_part = 7;
constexpr uint32_t on_function = 0;

}  // namespace

double IsosurfaceData::value(const Vec3& p) const {
    const std::array<double, 3> arguments{p.x, p.y, p.z};
    double result = 0.0;
    function->evaluate(arguments, {&result, 1});
    return result - threshold;
}

Interval IsosurfaceData::bound(const Bounds& cell) const {
    const std::array<Interval, 3> arguments{Interval{cell.lo.x, cell.hi.x}, Interval{cell.lo.y, cell.hi.y},
                                            Interval{cell.lo.z, cell.hi.z}};
    return function->bound(arguments, 0) - Interval(threshold);
}

bool IsosurfaceData::contains(const Vec3& p) const {
    if (radius) {
        const Vec3 q = p - box.center();
        return glm::dot(q, q) <= *radius * *radius;
    }
    return box.contains(p);
}

/// The ray within the container.
struct Isosurface::Span {
    double enter = 0;
    double leave = 0;
    uint32_t enter_part = 0;
    uint32_t leave_part = 0;
};

/// Finds the zeros along one ray in ascending order: pieces that surely hold none are left out, where the
/// value surely rises or falls a change of sign is one zero; the others are stepped through, as far as what
/// is known of their slope allows, and steps that may hold a zero are halved down to the resolution. Where
/// the slope is not known, intervals look at once; loose ones are no help, and max_gradient is trusted.
class Isosurface::Search {
public:
    Search(const Isosurface& shape, const ShapeRay& query, double level)
        : shape_(shape),
          ray_(query.ray),
          t_max_(query.t_max),
          level_(level),
          least_(shape.resolution_ / glm::length(ray_.direction)),
          steepest_(shape.data_.max_gradient * glm::length(ray_.direction)) {}

    double least() const { return least_; }

    /// A place on the ray; its value is computed when it is asked for, its sign may be known before.
    class Place {
    public:
        Place(const Search& search, double t) : t_(t), search_(&search) {}
        double t() const { return t_; }
        double f() {
            if (known_ != Known::value) f_ = search_->value(t_);
            known_ = Known::value;
            return f_;
        }
        bool below() { return known_ == Known::sign ? below_ : f() < 0.0; }
        void set_below(bool is) {
            if (known_ != Known::nothing) return;
            known_ = Known::sign;
            below_ = is;
        }

    private:
        enum class Known : uint8_t { nothing, sign, value };
        double t_;
        double f_ = 0.0;
        bool below_ = false;
        Known known_ = Known::nothing;
        const Search* search_;
    };

    /// Calls take(t) for every zero between `a` and `b`, places in one cell, until it returns false; then it
    /// returns false, too.
    template <class Take>
    bool run(Place& a, Place& b, size_t cell, const Take& take) const {
        const FunctionCells::Content content = shape_.content_of(cell, ray_.direction);
        if (content.sign != CellSign::unclear) return true;
        const Interval& slope = content.slope;
        if (slope.lo > 0.0 || slope.hi < 0.0) return go_on(sides(a, b), a, b, nullptr, take);
        if (!shape_.loose_ && slope.has_infinity()) return halve(a, b, nullptr, take);
        const Interval trusted = slope.has_infinity() ? Interval{-steepest_, steepest_} : slope;
        return step_through(a, b, trusted, take);
    }

private:
    enum class Found { none, one, jump, unclear };

    /// Of a value that only rises or only falls.
    static Found sides(Place& a, Place& b) { return a.below() == b.below() ? Found::none : Found::one; }

    double value(double t) const { return shape_.data_.value(ray_.at(t)) - level_; }

    /// `slope`: what is known of the slope all along, or null.
    template <class Take>
    bool halve(Place& a, Place& b, const Interval* slope, const Take& take) const {
        if (a.t() > t_max_) return false;
        // Values are quicker than intervals, which soon tell all in small pieces.
        constexpr double small = 8.0;
        const bool loosely = slope && (shape_.loose_ || b.t() - a.t() > small * least_);
        return go_on(loosely ? look_loosely(a, b, *slope) : look(a, b), a, b, slope, take);
    }

    template <class Take>
    bool go_on(Found found, Place& a, Place& b, const Interval* slope, const Take& take) const {
        if (found == Found::none) return true;
        Place middle(*this, 0.5 * (a.t() + b.t()));
        const bool splits = middle.t() > a.t() && middle.t() < b.t();
        if (found == Found::one || b.t() - a.t() <= least_ || !splits) {
            return a.below() == b.below() ||
                   take(bracketed_root([&](double t) { return value(t); }, a.t(), a.f(), b.t(), b.f()));
        }
        if (found == Found::jump && a.below() != b.below()) return pass_jump(a, b, take);
        return halve(a, middle, slope, take) && halve(middle, b, slope, take);
    }

    /// Finds one jump between places on different sides; then those that may stand before and behind it.
    template <class Take>
    bool pass_jump(Place& a, Place& b, const Take& take) const {
        Place before = a;
        Place behind = b;
        while (behind.t() - before.t() > least_) {
            Place middle(*this, 0.5 * (before.t() + behind.t()));
            if (!(middle.t() > before.t() && middle.t() < behind.t())) break;
            (middle.below() == before.below() ? before : behind) = middle;
        }
        return (before.t() == a.t() || halve(a, before, nullptr, take)) &&
               go_on(Found::one, before, behind, nullptr, take) &&
               (behind.t() == b.t() || halve(behind, b, nullptr, take));
    }

    /// In steps as long as the slope allows, if the value goes on as it did in the last one.
    template <class Take>
    bool step_through(const Place& from, Place& end, const Interval& slope, const Take& take) const {
        double falling = 0.0;
        for (Place a = from; a.t() < end.t();) {
            const double steepest_fall = toward_zero(a, slope);
            const double step = std::max(2.0 * std::abs(a.f()) / (steepest_fall + falling), least_);
            Place b = a.t() + step < end.t() ? Place(*this, a.t() + step) : end;
            if (!halve(a, b, &slope, take)) return false;
            constexpr double most = 0.9;
            falling = std::clamp((std::abs(a.f()) - std::abs(b.f())) / (b.t() - a.t()), -most * steepest_fall,
                                 steepest_fall);
            a = b;
        }
        return true;
    }

    /// How fast the value may go to zero, and away from it.
    static double toward_zero(Place& a, const Interval& slope) { return a.below() ? slope.hi : -slope.lo; }
    static double from_zero(Place& a, const Interval& slope) { return a.below() ? -slope.lo : slope.hi; }

    /// The steepest lines from both ends meet before they come to zero.
    static bool lines_miss_zero(Place& a, Place& b, const Interval& slope) {
        const double down = toward_zero(a, slope);
        const double up = from_zero(a, slope);
        const double reach = down * up * (b.t() - a.t());
        const double height = std::abs(a.f()) * up + std::abs(b.f()) * down;
        constexpr double rounding = 1e-9;
        return height > reach * (1.0 + rounding);
    }

    /// `one`: no more than one, which the signs at the ends tell; `jump`: any number, jumps too.
    Found look(Place& a, Place& b) const {
        LinePlace place;
        for (int i = 0; i < 3; ++i) {
            const Interval d(ray_.direction[i]);
            place[static_cast<size_t>(i)] = {Interval(ray_.origin[i]) + Interval(a.t(), b.t()) * d, d};
        }
        const IntervalSlope v = shape_.data_.function->bound_slope(place, 0);
        if (misses_zero(v.value)) {
            a.set_below(v.value.hi < shape_.data_.threshold + level_);
            b.set_below(a.below());
            return Found::none;
        }
        const Interval& s = v.slope;
        if (!s.maybe_nan && (s.lo > 0.0 || s.hi < 0.0)) return sides(a, b);
        if (s.has_infinity()) return Found::jump;
        if (s.maybe_nan) return Found::unclear;
        if (a.below() != b.below()) return Found::unclear;
        return lines_miss_zero(a, b, s) ? Found::none : Found::unclear;
    }

    /// By a slope that is known beforehand.
    static Found look_loosely(Place& a, Place& b, const Interval& slope) {
        return a.below() == b.below() && lines_miss_zero(a, b, slope) ? Found::none : Found::unclear;
    }

    bool misses_zero(const Interval& function) const {
        const Interval v = function - Interval(shape_.data_.threshold) - Interval(level_);
        return !v.maybe_nan && (v.lo > 0.0 || v.hi < 0.0);
    }

    const Isosurface& shape_;
    const Ray& ray_;
    double t_max_;
    double level_;
    double least_;
    double steepest_;
};

Isosurface::Isosurface(IsosurfaceData data)
    : data_(std::move(data)),
      loose_(has_loose_bounds(data_)),
      resolution_(loose_ ? 0.5 * data_.accuracy : std::min(data_.accuracy, 1e-3 * data_.size()) / 16.0),
      cells_(data_.box, [this](const Bounds& cell) { return data_.bound(cell); }),
      bounds_(cells_.hull(false, !data_.open)) {}

bool Isosurface::enters_container(const ShapeRay& query, Span& span) const {
    const Vec3& d = query.ray.direction;
    const Vec3& o = query.ray.origin;
    constexpr double inf = std::numeric_limits<double>::infinity();
    span = {-inf, inf, 0, 0};
    if (data_.radius) {
        const double dd = glm::dot(d, d);
        const Vec3 p = o - data_.box.center();
        const double at = -glm::dot(p, d) / dd;
        const Vec3 q = p + at * d;
        const double chord = *data_.radius * *data_.radius - glm::dot(q, q);
        if (!(chord > 0.0)) return false;
        const double half = std::sqrt(chord / dd);
        span = {at - half, at + half, sphere_part, sphere_part};
        return span.leave > 0.0;
    }
    for (int i = 0; i < 3; ++i) {
        if (d[i] == 0.0) {
            if (o[i] < data_.box.lo[i] || o[i] > data_.box.hi[i]) return false;
            continue;
        }
        const auto low = static_cast<uint32_t>(1 + 2 * i);
        double a = (data_.box.lo[i] - o[i]) / d[i];
        double b = (data_.box.hi[i] - o[i]) / d[i];
        const bool forward = d[i] > 0.0;
        if (!forward) std::swap(a, b);
        if (a > span.enter) {
            span.enter = a;
            span.enter_part = forward ? low : low + 1;
        }
        if (b < span.leave) {
            span.leave = b;
            span.leave_part = forward ? low + 1 : low;
        }
    }
    return span.enter < span.leave && span.leave > 0.0;
}

double Isosurface::side_distance(const Vec3& p, uint32_t& part) const {
    if (data_.radius) {
        part = sphere_part;
        return std::abs(glm::length(p - data_.box.center()) - *data_.radius);
    }
    double best = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 3; ++i) {
        const double lo = std::abs(p[i] - data_.box.lo[i]);
        const double hi = std::abs(p[i] - data_.box.hi[i]);
        if (lo < best) part = static_cast<uint32_t>(1 + 2 * i);
        if (hi < std::min(best, lo)) part = static_cast<uint32_t>(2 + 2 * i);
        best = std::min({best, lo, hi});
    }
    return best;
}

/// The part on which the ray starts; any_part if in free space.
uint32_t Isosurface::start_part(const ShapeRay& query) const {
    if (query.starts_on_surface && query.origin_part != any_part) return query.origin_part;
    const Vec3& o = query.ray.origin;
    if (!query.starts_on_surface) {
        if (!(query.origin_error > 0.0)) return any_part;
        const Bounds reach{data_.box.lo - query.origin_error, data_.box.hi + query.origin_error};
        if (!reach.contains(o)) return any_part;
    }
    uint32_t side = 0;
    const double to_side = side_distance(o, side);
    const double slope = glm::length(gradient(o)) / data_.accuracy;
    const double to_function = std::abs(data_.value(o)) / std::max(slope, std::numeric_limits<double>::min());
    if (!query.starts_on_surface && std::min(to_side, to_function) > query.origin_error) return any_part;
    return to_side < to_function ? side : on_function;
}

template <class Take>
void Isosurface::each_crossing(const ShapeRay& query, Take&& take) const {
    Span span;
    if (!enters_container(query, span)) return;
    const uint32_t start = start_part(query);
    // On the function's surface its value there counts as the threshold, so that the root is exactly at the
    // origin; but where the function jumps, its value is that of one side.
    double level = start == on_function ? data_.value(query.ray.origin) : 0.0;
    if (is_jump(level, query.origin_error)) level = 0.0;
    const Search search(*this, query, level);
    double a = std::max(span.enter, 0.0);
    bool on_side = false;
    if (start != any_part && start != on_function) {
        // From a side either in or out.
        if (span.leave_part == start && (span.enter_part != start || span.leave < -span.enter)) return;
        on_side = span.enter_part == start;
        if (on_side) a = span.enter;
    }
    constexpr double share = 1.0 / 64.0;
    if (start == on_function) a = std::min(share * search.least(), 0.5 * span.leave);
    Search::Place from(search, a);
    bool may_enter = !data_.open && !on_side && span.enter > 0.0;
    const auto piece = [&](double, double end, CellSign sign, size_t cell) {
        Search::Place to(search, end);
        if (sign != CellSign::unclear && level == 0.0) {
            from.set_below(sign == CellSign::below);
            to.set_below(sign == CellSign::below);
        }
        if (may_enter && from.below() && !take(span.enter, span.enter_part)) return false;
        may_enter = false;
        const auto function_root = [&](double t) { return take(t, on_function); };
        if (sign == CellSign::unclear && !search.run(from, to, cell, function_root)) return false;
        from = to;
        return end <= query.t_max;
    };
    if (cells_.walk(query.ray, a, span.leave, piece) && !data_.open && from.below())
        take(span.leave, span.leave_part);
}

FunctionCells::Content Isosurface::content_of(size_t cell, const Vec3& direction) const {
    return cells_.content(cell, direction, [this](const LinePlace& place) {
        return data_.function->bound_slope(place, 0) - data_.threshold;
    });
}

void Isosurface::crossings(const ShapeRay& query, Crossings& out) const {
    size_t left = data_.max_trace;
    each_crossing(query, [&](double t, uint32_t part) {
        if (t > query.t_max) return false;
        if (t > query.t_min) out.add({t, part, Vec2{0.0}});
        return --left > 0;
    });
}

bool Isosurface::closest(const ShapeRay& query, const CrossingFilter* filter, Crossing& nearest) const {
    bool found = false;
    size_t left = data_.max_trace;
    each_crossing(query, [&](double t, uint32_t part) {
        if (t > query.t_max) return false;
        const Crossing crossing{t, part, Vec2{0.0}};
        if (t > query.t_min && (!filter || filter->counts(crossing))) {
            nearest = crossing;
            found = true;
            return false;
        }
        return --left > 0;
    });
    return found;
}

bool Isosurface::is_jump(double value, double error) const {
    constexpr double rounding = 1e-9;
    return std::abs(value) > data_.max_gradient * (10.0 * error + rounding * data_.size());
}

Vec3 Isosurface::gradient(const Vec3& p) const {
    const double f = data_.value(p);
    // Across a jump, whichever side of it rounding has put the point on.
    const bool jumps = is_jump(f, 0.0);
    Vec3 n;
    for (int i = 0; i < 3; ++i) {
        Vec3 after = p;
        Vec3 before = p;
        after[i] += data_.accuracy;
        before[i] -= data_.accuracy;
        n[i] = data_.value(after) - (jumps ? data_.value(before) : f);
    }
    return n;
}

Vec3 Isosurface::normal(const Vec3& p, const Crossing& at) const {
    if (at.part == sphere_part) return p - data_.box.center();
    if (at.part != on_function) {
        Vec3 n{0.0};
        n[static_cast<int>(at.part - 1) / 2] = at.part % 2 ? -1.0 : 1.0;
        return n;
    }
    const Vec3 n = gradient(p);
    return n == Vec3{0.0} ? Vec3{1, 0, 0} : n;
}

std::string Isosurface::describe() const {
    const Bounds& b = data_.box;
    return fmt::format("threshold {} accuracy {} in {} <{},{},{}> <{},{},{}>, {}{}", data_.threshold,
                       data_.accuracy, data_.radius ? "sphere" : "box", b.lo.x, b.lo.y, b.lo.z, b.hi.x,
                       b.hi.y, b.hi.z,
                       loose_ ? fmt::format("max_gradient {}", data_.max_gradient) : "bounded by intervals",
                       data_.open ? ", open" : "");
}

}  // namespace rb
