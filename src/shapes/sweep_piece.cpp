#include "shapes/sweep_piece.h"

#include "math/quick_roots.h"
#include "math/roots.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

namespace rb {

namespace {

/// A polynomial, highest power first.
template <size_t N>
using Poly = std::array<double, N + 1>;

template <size_t N>
double value(const Poly<N>& p, double w) {
    double v = p[0];
    for (size_t i = 1; i <= N; ++i) v = v * w + p[i];
    return v;
}

template <size_t N>
Poly<N - 1> derivative(const Poly<N>& p) {
    Poly<N - 1> d;
    for (size_t i = 0; i < N; ++i) d[i] = static_cast<double>(N - i) * p[i];
    return d;
}

template <size_t N, size_t M>
Poly<N + M> product(const Poly<N>& a, const Poly<M>& b) {
    Poly<N + M> p{};
#pragma GCC unroll 8
    for (size_t i = 0; i <= N; ++i) {
#pragma GCC unroll 8
        for (size_t k = 0; k <= M; ++k) p[i + k] += a[i] * b[k];
    }
    return p;
}

/// p(lo + width x) as a polynomial in x.
template <size_t N>
Poly<N> restricted(Poly<N> p, double lo, double width) {
#pragma GCC unroll 8
    for (size_t k = N; k > 0; --k) {
#pragma GCC unroll 8
        for (size_t i = 1; i <= k; ++i) p[i] += lo * p[i - 1];
    }
    double power = 1.0;
    for (size_t k = N; k-- > 0;) {
        power *= width;
        p[k] *= power;
    }
    return p;
}

template <size_t N>
struct Roots {
    std::array<double, N> at;
    size_t count = 0;
    bool sure = true;  ///< double precision told all
};

/// Roots within [0, 1], ascending.
template <size_t N>
Roots<N> roots_of(const Poly<N>& p) {
    Roots<N> roots;
    if constexpr (N <= 2) {
        std::array<double, 2> all{};
        size_t n = 1;
        if constexpr (N == 1) {
            all[0] = -p[1] / p[0];
        } else {
            n = static_cast<size_t>(solve_quadratic(p[0], 0.5 * p[1], p[2], all));
        }
        roots.sure = false;
        for (size_t i = 0; i < n; ++i) {
            if (all[i] >= 0.0 && all[i] <= 1.0) roots.at[roots.count++] = all[i];
        }
    } else if (const auto quick = QuickRoots<N>(p).search(roots.at)) {
        roots.count = *quick;
    } else {
        roots.sure = false;
        roots.count = static_cast<size_t>(solve_polynomial(p, 0.0, 1.0, roots.at));
    }
    return roots;
}

/// The powers of a range of a piece over its own unit interval, highest first.
template <size_t N>
std::array<Ball, N + 1> powers_of(const SweepPiece& piece, const SweepRange& range) {
    std::array<Ball, N + 1> p;
    std::reverse_copy(piece.power.begin(), piece.power.begin() + N + 1, p.begin());
    if (range.lo == 0.0 && range.hi == 1.0) return p;
#pragma GCC unroll 8
    for (size_t k = N; k > 0; --k) {
#pragma GCC unroll 8
        for (size_t i = 1; i <= k; ++i) p[i] += range.lo * p[i - 1];
    }
    double power = 1.0;
    for (size_t k = N; k-- > 0;) {
        power *= range.hi - range.lo;
        p[k] *= power;
    }
    return p;
}

/// A range of a piece as a ray sees it, with a parameter from 0 to 1; degree N of the curve.
template <size_t N>
class RangeView {
public:
    RangeView(const SweepPiece& piece, const SweepRange& range, const SweepQuestion& question)
        : range_(range), from_surface_(question.from_surface) {
        const RayFrame& frame = question.frame;
        const auto p = powers_of<N>(piece, range);
        Poly<N> u;
        Poly<N> v;
        Poly<N> r;
#pragma GCC unroll 8
        for (size_t i = 0; i <= N; ++i) {
            const Vec3 c = Vec3{p[i]} - (i == N ? frame.origin : Vec3{0.0});
            along_[i] = glm::dot(c, frame.along);
            u[i] = glm::dot(c, frame.u);
            v[i] = glm::dot(c, frame.v);
            r[i] = p[i].w;
        }
        const Poly<2 * N> uu = product<N, N>(u, u);
        const Poly<2 * N> vv = product<N, N>(v, v);
        room_ = product<N, N>(r, r);
#pragma GCC unroll 8
        for (size_t i = 0; i <= 2 * N; ++i) room_[i] -= uu[i] + vv[i];
        room_[2 * N] += question.level;
    }

    /// Calls take(lo, hi) for every run of balls that the ray meets.
    template <class Take>
    void each_run(Take&& take) const {
        std::array<double, 3 * N + 2> cuts;
        cuts[0] = 0.0;
        size_t n = 1;
        const auto ends = roots_of<2 * N>(room_);
        for (size_t i = 0; i < ends.count; ++i) cuts[n++] = ends.at[i];
        Roots<N> passes;
        if (from_surface_ && !(n == 1 && value<2 * N>(room_, 0.5) <= 0.0)) {
            // A run ends where centres pass the origin.
            passes = roots_of<N>(along_);
            for (size_t i = 0; i < passes.count; ++i) cuts[n++] = passes.at[i];
            std::sort(cuts.begin() + 1, cuts.begin() + static_cast<std::ptrdiff_t>(n));
        }
        cuts[n++] = 1.0;
        const auto ends_run = [&](double x) {
            for (size_t i = 0; i < passes.count; ++i) {
                if (passes.at[i] == x) return true;
            }
            return false;
        };
        for (size_t i = 0; i + 1 < n;) {
            if (!is_met(cuts[i], cuts[i + 1])) {
                ++i;
                continue;
            }
            size_t end = i + 1;
            while (end + 1 < n && !ends_run(cuts[end]) && is_met(cuts[end], cuts[end + 1])) ++end;
            // From the surface the balls lie either ahead or behind: none is around the origin.
            if (!from_surface_ || along(0.5 * (cuts[i] + cuts[end])) > 0.0) take(cuts[i], cuts[end]);
            i = end;
        }
    }

    Way way_through(double x) const {
        const double half = std::sqrt(std::max(value<2 * N>(room_, x), 0.0));
        const double a = along(x);
        const double w = range_.lo + x * (range_.hi - range_.lo);
        return {a - half, a + half, range_.piece, range_.piece, w, w};
    }

    Way way_between(double lo, double hi) const {
        Way way = way_through(lo);
        const auto look = [&](double x) {
            const Way ball = way_through(x);
            if (ball.in < way.in) {
                way.in = ball.in;
                way.in_w = ball.in_w;
            }
            if (ball.out > way.out) {
                way.out = ball.out;
                way.out_w = ball.out_w;
            }
        };
        look(hi);
        const double width = hi - lo;
        const auto room = restricted<2 * N>(room_, lo, width);
        const auto slope = derivative<N>(restricted<N>(along_, lo, width));
        const auto room_slope = derivative<2 * N>(room);
        auto turn = product<2 * N - 1, 2 * N - 1>(room_slope, room_slope);
        const auto other = product<2 * N, 2 * N - 2>(room, product<N - 1, N - 1>(slope, slope));
        for (size_t i = 0; i < turn.size(); ++i) turn[i] -= 4.0 * other[i];
        const auto turns = roots_of<4 * N - 2>(turn);
        for (size_t i = 0; i < turns.count; ++i) look(lo + width * turns.at[i]);
        if (turns.sure) return way;
        // Where a' is about 0 they come in pairs too close to be told, around those of D'.
        const auto tops = roots_of<2 * N - 1>(room_slope);
        for (size_t i = 0; i < tops.count; ++i) look(lo + width * tops.at[i]);
        return way;
    }

private:
    bool is_met(double lo, double hi) const { return hi > lo && value<2 * N>(room_, 0.5 * (lo + hi)) > 0.0; }
    double along(double x) const { return value<N>(along_, x); }

    const SweepRange& range_;
    bool from_surface_;
    Poly<N> along_;
    Poly<2 * N> room_;
};

template <size_t N>
void add_ways_of(const SweepPiece& piece, const SweepRange& range, const SweepQuestion& question,
                 std::vector<Way>& ways) {
    const RangeView<N> view(piece, range, question);
    view.each_run([&](double lo, double hi) { ways.push_back(view.way_between(lo, hi)); });
}

template <size_t N>
void add_balls_of(const SweepPiece& piece, const SweepRange& range, const SweepQuestion& question,
                  std::vector<Way>& ways) {
    const RangeView<N> view(piece, range, question);
    view.each_run([&](double lo, double hi) { ways.push_back(view.way_through(0.5 * (lo + hi))); });
}

template <size_t N>
DeepestBall deepest_of(const SweepPiece& piece, const SweepRange& range, const Vec3& p) {
    const auto powers = powers_of<N>(piece, range);
    Poly<2 * N> f{};
    for (int axis = 0; axis < 4; ++axis) {
        Poly<N> c;
        for (size_t i = 0; i <= N; ++i) c[i] = powers[i][axis];
        if (axis < 3) c[N] -= p[axis];
        const Poly<2 * N> cc = product<N, N>(c, c);
        for (size_t i = 0; i <= 2 * N; ++i) f[i] += axis < 3 ? cc[i] : -cc[i];
    }
    DeepestBall best{f[2 * N], range.lo};
    const auto look = [&](double x) {
        const double v = value<2 * N>(f, x);
        if (v < best.level) best = {v, range.lo + x * (range.hi - range.lo)};
    };
    look(1.0);
    const auto turns = roots_of<2 * N - 1>(derivative<2 * N>(f));
    for (size_t i = 0; i < turns.count; ++i) look(turns.at[i]);
    return best;
}

}  // namespace

SweepPiece SweepPiece::bezier(const std::array<Ball, 4>& c) {
    SweepPiece piece;
    piece.control = c;
    piece.power = {c[0], 3.0 * (c[1] - c[0]), 3.0 * (c[0] - 2.0 * c[1] + c[2]),
                   c[3] - c[0] + 3.0 * (c[1] - c[2])};
    return piece;
}

SweepPiece SweepPiece::straight(const Ball& a, const Ball& b) {
    SweepPiece piece;
    piece.control = {a, a, b, b};
    piece.power = {a, b - a, Ball{0.0}, Ball{0.0}};
    piece.is_straight = true;
    return piece;
}

Bounds SweepPiece::box() const {
    Bounds box;
    for (const Ball& ball : control) {
        box.include(Vec3{ball} - std::abs(ball.w));
        box.include(Vec3{ball} + std::abs(ball.w));
    }
    return box;
}

/// A Bezier curve lies in the hull of its control points, and how far a ball reaches from a point is convex.
SweepBound SweepBound::around(const SweepPiece& piece, double lo, double hi) {
    const double third = (hi - lo) / 3.0;
    const auto slope = [&](double w) {
        return piece.power[1] + w * (2.0 * piece.power[2] + 3.0 * w * piece.power[3]);
    };
    const Ball a = piece.at(lo);
    const Ball b = piece.at(hi);
    const std::array<Ball, 4> control{a, a + third * slope(lo), b - third * slope(hi), b};
    Bounds box;
    for (const Ball& ball : control) {
        box.include(Vec3{ball} - std::abs(ball.w));
        box.include(Vec3{ball} + std::abs(ball.w));
    }
    SweepBound bound{0.5 * (box.lo + box.hi), 0.0};
    for (const Ball& ball : control)
        bound.radius = std::max(bound.radius, glm::length(Vec3{ball} - bound.center) + std::abs(ball.w));
    return bound;
}

void SweepBound::include(const SweepBound& other) {
    const Vec3 way = other.center - center;
    const double apart = glm::length(way);
    if (apart + other.radius <= radius) return;
    if (apart + radius <= other.radius) {
        *this = other;
        return;
    }
    const double whole = 0.5 * (apart + radius + other.radius);
    center += ((whole - radius) / apart) * way;
    constexpr double rounding = 1e-12;
    radius = whole * (1.0 + rounding);
}

RayFrame::RayFrame(const Vec3& from, const Vec3& direction) : origin(from), length(glm::length(direction)) {
    along = direction / length;
    const Vec3 size = glm::abs(along);
    const Vec3 axis = size.x <= size.y && size.x <= size.z ? Vec3{1, 0, 0}
                      : size.y <= size.z                   ? Vec3{0, 1, 0}
                                                           : Vec3{0, 0, 1};
    u = glm::normalize(glm::cross(along, axis));
    v = glm::cross(along, u);
}

void add_ways(const SweepPiece& piece, const SweepRange& range, const SweepQuestion& question,
              std::vector<Way>& ways) {
    piece.is_straight ? add_ways_of<1>(piece, range, question, ways)
                      : add_ways_of<3>(piece, range, question, ways);
}

void add_balls(const SweepPiece& piece, const SweepRange& range, const SweepQuestion& question,
               std::vector<Way>& ways) {
    piece.is_straight ? add_balls_of<1>(piece, range, question, ways)
                      : add_balls_of<3>(piece, range, question, ways);
}

DeepestBall deepest(const SweepPiece& piece, const SweepRange& range, const Vec3& p) {
    return piece.is_straight ? deepest_of<1>(piece, range, p) : deepest_of<3>(piece, range, p);
}

}  // namespace rb
