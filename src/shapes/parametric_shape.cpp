#include "shapes/parametric_shape.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace rb {

namespace {

/// How often a cell that is seen edge-on is halved both ways.
constexpr int most_cuts = 6;

Interval bound(const Function& function, const Vec2& lo, const Vec2& hi) {
    const std::array<Interval, 2> uv{Interval{lo.x, hi.x}, Interval{lo.y, hi.y}};
    return function.bound({uv.data(), std::min<size_t>(2, static_cast<size_t>(function.parameter_count()))},
                          0);
}

double value(const Function& function, const Vec2& uv) {
    const std::array<double, 3> arguments{uv.x, uv.y, 0.0};
    double result = 0.0;
    function.evaluate({arguments.data(), static_cast<size_t>(function.parameter_count())}, {&result, 1});
    return result;
}

}  // namespace

Vec3 ParametricData::at(const Vec2& uv) const {
    return {value(*functions[0], uv), value(*functions[1], uv), value(*functions[2], uv)};
}

/// A part of the parameters' range with the points at its corners.
struct Parametric::Cell {
    Vec2 lo, hi;
    std::array<Vec3, 4> corner;  ///< (lo, lo), (hi, lo), (lo, hi), (hi, hi)

    Vec2 middle() const { return 0.5 * (lo + hi); }
    Vec2 size() const { return hi - lo; }
    /// Slopes along the whole cell, at its corner k.
    Vec3 across_u(size_t k) const { return k < 2 ? corner[1] - corner[0] : corner[3] - corner[2]; }
    Vec3 across_v(size_t k) const { return k % 2 == 0 ? corner[2] - corner[0] : corner[3] - corner[1]; }
    bool is_finite() const {
        return std::ranges::all_of(corner, [](const Vec3& p) {
            return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
        });
    }
};

Parametric::Cell Parametric::cell(uint32_t number) const {
    const uint32_t i = number % side;
    const uint32_t k = number / side;
    const auto line = [&](uint32_t u, uint32_t v) {
        const Vec2 share{static_cast<double>(u) / side, static_cast<double>(v) / side};
        return data_.lo + share * (data_.hi - data_.lo);
    };
    const Vec3* low = grid_.data() + static_cast<size_t>(k) * (side + 1) + i;
    const Vec3* high = low + side + 1;
    return {line(i, k), line(i + 1, k + 1), {low[0], low[1], high[0], high[1]}};
}

Bounds Parametric::box_of(const Cell& c) const {
    Bounds box;
    for (const Vec3& p : c.corner) box.include(p);
    const Vec3 size = box.size();
    for (int i = 0; i < 3; ++i) {
        const auto axis = static_cast<size_t>(i);
        if (has_narrow_bounds_[axis]) {
            const Interval v = bound(*data_.functions[axis], c.lo, c.hi);
            box.lo[i] = v.lo;
            box.hi[i] = v.hi;
        } else {
            // The corners, and what the stated gradient allows between them.
            const double room = std::max(size[i], 0.5 * data_.max_gradient * (c.size().x + c.size().y));
            box.lo[i] -= room;
            box.hi[i] += room;
        }
    }
    return box;
}

Parametric::Parametric(ParametricData data) : data_(std::move(data)) {
    const Vec2 size = data_.hi - data_.lo;
    for (uint32_t k = 0; k <= side; ++k) {
        for (uint32_t i = 0; i <= side; ++i) {
            const Vec2 share{static_cast<double>(i) / side, static_cast<double>(k) / side};
            grid_.push_back(data_.at(data_.lo + share * size));
        }
    }
    for (size_t axis = 0; axis < 3; ++axis) {
        const auto width = [&](double share) {
            double sum = 0.0;
            for (const double at : {0.1, 0.37, 0.62, 0.83}) {
                const Interval v =
                    bound(*data_.functions[axis], data_.lo + at * size, data_.lo + (at + share) * size);
                sum += v.maybe_nan ? std::numeric_limits<double>::infinity() : v.hi - v.lo;
            }
            return sum;
        };
        const double wide = width(1e-3);
        const double narrow = width(1e-5);
        // A bound that shrinks with its cell becomes a hundredth.
        has_narrow_bounds_[axis] = std::isfinite(narrow) && narrow <= 0.2 * wide;
    }
    const auto cell_box = [&](uint32_t number) {
        const Cell c = cell(number);
        if (!c.is_finite()) return empty_box_f;
        const Bounds box = intersection(box_of(c), data_.container.box);
        if (box.is_empty()) return empty_box_f;
        bounds_.include(box);
        return rounded_outward(box);
    };
    KdOptions options;
    options.block = 1;
    tree_ = KdTree(side * side, cell_box, options);
}

/// Finds the crossings of one ray in cells.
class Parametric::Search {
public:
    Search(const Parametric& shape, const Ray& ray, double from, double to)
        : shape_(shape), ray_(ray), from_(from), to_(to), length_(glm::length(ray.direction)) {}

    template <class Take>
    void look(const Cell& cell, int cuts, Take& take) const {
        if (!cell.is_finite()) return;
        if (cuts < most_cuts && !may_pass(cell)) return;
        if (sees_one_side(cell)) {
            newton(cell, false, take);
        } else if (cuts == 0) {
            newton(cell, true, take);
        } else {
            cut(cell, cuts, take);
        }
    }

private:
    /// False where the ray surely misses the cell's box within its way.
    bool may_pass(const Cell& cell) const {
        const Bounds box = shape_.box_of(cell);
        double from = from_;
        double to = to_;
        for (int i = 0; i < 3; ++i) {
            const double o = ray_.origin[i];
            const double d = ray_.direction[i];
            if (d == 0.0) {
                if (o < box.lo[i] || o > box.hi[i]) return false;
                continue;
            }
            constexpr double rounding = 1e-13;
            const double a = (box.lo[i] - o) / d;
            const double b = (box.hi[i] - o) / d;
            const double error = rounding * std::max(std::abs(a), std::abs(b));
            from = std::max(from, std::min(a, b) - error);
            to = std::min(to, std::max(a, b) + error);
        }
        return from <= to;
    }

    /// True if the surface turns the same side to the ray all over the cell, as its corners tell, and bends
    /// little: then a line through it meets it once at most.
    bool sees_one_side(const Cell& cell) const {
        double least = std::numeric_limits<double>::infinity();
        double most = -least;
        for (size_t k = 0; k < 4; ++k) {
            const Vec3 n = glm::cross(cell.across_u(k), cell.across_v(k));
            const double length = glm::length(n);
            if (!(length > 0.0)) return false;
            const double facing = glm::dot(n, ray_.direction) / (length * length_);
            least = std::min(least, facing);
            most = std::max(most, facing);
        }
        // As much again as it turns between the corners may be hidden between them.
        const double turn = most - least;
        return least > turn || most < -turn;
    }

    template <class Take>
    void cut(const Cell& cell, int cuts, Take& take) const {
        const Vec2 m = cell.middle();
        const Vec3 bottom = shape_.data_.at({m.x, cell.lo.y});
        const Vec3 left = shape_.data_.at({cell.lo.x, m.y});
        const Vec3 center = shape_.data_.at(m);
        const Vec3 right = shape_.data_.at({cell.hi.x, m.y});
        const Vec3 top = shape_.data_.at({m.x, cell.hi.y});
        const auto& c = cell.corner;
        look({cell.lo, m, {c[0], bottom, left, center}}, cuts - 1, take);
        look({{m.x, cell.lo.y}, {cell.hi.x, m.y}, {bottom, c[1], center, right}}, cuts - 1, take);
        look({{cell.lo.x, m.y}, {m.x, cell.hi.y}, {left, center, c[2], top}}, cuts - 1, take);
        look({m, cell.hi, {center, right, top, c[3]}}, cuts - 1, take);
    }

    /// u, v (in shares of the cell, from its middle) and t where ray and tangent plane meet.
    static Vec3 solve(const Vec3& su, const Vec3& sv, const Vec3& d, const Vec3& gap) {
        const Vec3 n = glm::cross(su, sv);
        const double t = -glm::dot(n, gap) / glm::dot(n, d);
        const Vec3 rest = gap + t * d;
        const double nn = glm::dot(n, n);
        return {glm::dot(glm::cross(rest, sv), n) / nn, glm::dot(glm::cross(su, rest), n) / nn, t};
    }

    /// With the slopes of the whole cell, or, where it is seen edge-on, with those at each guess.
    template <class Take>
    void newton(const Cell& cell, bool edge_on, Take& take) const {
        const auto& c = cell.corner;
        Vec3 su = 0.5 * (cell.across_u(0) + cell.across_u(2));
        Vec3 sv = 0.5 * (cell.across_v(0) + cell.across_v(1));
        constexpr double far = 1.0;
        // The first step from the mean of the corners costs nothing. Where the cell is seen nearly edge-on,
        // how far that lies off the surface counts much: a way out of the cell has to start on it.
        Vec3 point = 0.25 * (c[0] + c[1] + c[2] + c[3]);
        Vec3 step = solve(su, sv, ray_.direction, ray_.origin - point);
        if (!(std::max(std::abs(step.x), std::abs(step.y)) < far)) {
            point = shape_.data_.at(cell.middle());
            step = solve(su, sv, ray_.direction, ray_.origin - point);
        }
        Vec2 share{0.0};
        const double farthest = edge_on ? 4.0 : 1.5;
        constexpr int most = 24;
        for (int i = 0; i < most; ++i) {
            const double size = std::max(std::abs(step.x), std::abs(step.y));
            if (!(size < far)) {
                if (!edge_on || !(size < std::numeric_limits<double>::infinity())) return;
                step *= far / size;
            }
            share += Vec2{step.x, step.y};
            if (std::abs(share.x) > farthest || std::abs(share.y) > farthest) return;
            // A neighbour finds the same crossing: a cell takes what lies on its rim.
            constexpr double rim = 0.5 + 1e-6;
            constexpr double enough = 1e-11;
            if (i > 0 && size <= enough) {
                if (std::abs(share.x) <= rim && std::abs(share.y) <= rim)
                    take(step.z, glm::clamp(uv_at(cell, share), shape_.data_.lo, shape_.data_.hi));
                return;
            }
            point = shape_.data_.at(uv_at(cell, share));
            // The slopes of the whole cell converge slowly where those on it differ much.
            constexpr int enough_with_fixed_slopes = 3;
            if (edge_on || i >= enough_with_fixed_slopes) {
                constexpr double h = 1e-3;
                su = (shape_.data_.at(uv_at(cell, share + Vec2{h, 0.0})) - point) / h;
                sv = (shape_.data_.at(uv_at(cell, share + Vec2{0.0, h})) - point) / h;
            }
            step = solve(su, sv, ray_.direction, ray_.origin - point);
        }
    }

    Vec2 uv_at(const Cell& cell, const Vec2& share) const { return cell.middle() + share * cell.size(); }

    const Parametric& shape_;
    const Ray& ray_;
    double from_;
    double to_;
    double length_;
};

template <class Take>
void Parametric::each_crossing(const ShapeRay& query, const double& t_max, Take&& take) const {
    double from = query.t_min;
    double to = t_max;
    if (!data_.container.clip(query.ray, from, to)) return;
    if (query.starts_on_surface || query.origin_error > 0.0) {
        // The crossing at the origin is found again with the error of Newton's method.
        const double least = std::max(1e-8 * glm::length(bounds_.size()), 4.0 * query.origin_error);
        from = std::max(from, least / glm::length(query.ray.direction));
    }
    const Search search(*this, query.ray, from, to);
    const auto found = [&](double t, const Vec2& uv) {
        if (t > from && t <= to && t <= t_max) take(t, uv);
    };
    tree_.walk(query.ray, from, t_max, [&](const uint32_t* cells, uint32_t count) {
        for (uint32_t i = 0; i < count; ++i) search.look(cell(cells[i]), most_cuts, found);
        return false;
    });
}

void Parametric::crossings(const ShapeRay& ray, Crossings& out) const {
    std::vector<Crossing> all;
    each_crossing(ray, ray.t_max, [&](double t, const Vec2& uv) { all.push_back({t, 0, uv}); });
    std::ranges::sort(all, {}, &Crossing::t);
    for (size_t i = 0; i < all.size(); ++i) {
        // A cell may be visited twice, and a rim belongs to two.
        constexpr double same = 1e-9;
        if (i == 0 || all[i].t - all[i - 1].t > same * std::abs(all[i].t)) out.add(all[i]);
    }
}

bool Parametric::closest(const ShapeRay& ray, const CrossingFilter* filter, Crossing& nearest) const {
    double best = ray.t_max;
    bool found = false;
    each_crossing(ray, best, [&](double t, const Vec2& uv) {
        const Crossing crossing{t, 0, uv};
        if (filter && !filter->counts(crossing)) return;
        nearest = crossing;
        best = t;
        found = true;
    });
    return found;
}

Vec3 Parametric::normal(const Vec3&, const Crossing& at) const {
    const Vec3 p = data_.at(at.at);
    const Vec3 su = data_.at(at.at + Vec2{data_.accuracy, 0.0}) - p;
    const Vec3 sv = data_.at(at.at + Vec2{0.0, data_.accuracy}) - p;
    const Vec3 n = glm::cross(su, sv);
    return n == Vec3{0.0} ? Vec3{1, 0, 0} : n;
}

std::string Parametric::describe() const {
    return fmt::format("u {} to {}, v {} to {}{}", data_.lo.x, data_.hi.x, data_.lo.y, data_.hi.y,
                       has_narrow_bounds_[0] && has_narrow_bounds_[1] && has_narrow_bounds_[2]
                           ? ", bounded by intervals"
                           : fmt::format(", max_gradient {}", data_.max_gradient));
}

}  // namespace rb
