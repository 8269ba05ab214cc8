#include "shapes/sphere_sweep_shape.h"

#include "math/interval.h"
#include "math/roots.h"
#include "shapes/ray_shape.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace rb {

namespace {

/// A polynomial, lowest power first.
template <size_t N>
using Poly = std::array<double, N + 1>;

template <size_t N>
double value(const Poly<N>& p, double w) {
    double v = p[N];
    for (size_t i = N; i-- > 0;) v = v * w + p[i];
    return v;
}

template <size_t N>
Poly<N - 1> derivative(const Poly<N>& p) {
    Poly<N - 1> d;
    for (size_t i = 0; i < N; ++i) d[i] = static_cast<double>(i + 1) * p[i + 1];
    return d;
}

template <size_t N, size_t M>
Poly<N + M> product(const Poly<N>& a, const Poly<M>& b) {
    Poly<N + M> p{};
    for (size_t i = 0; i <= N; ++i) {
        for (size_t k = 0; k <= M; ++k) p[i + k] += a[i] * b[k];
    }
    return p;
}

/// Roots within [lo, hi], ascending.
template <size_t N>
size_t roots_of(const Poly<N>& p, double lo, double hi, std::span<double> roots) {
    if constexpr (N == 1) {
        roots[0] = -p[0] / p[1];
        return roots[0] >= lo && roots[0] <= hi ? 1 : 0;
    } else if constexpr (N == 2) {
        std::array<double, 2> all{};
        const int n = solve_quadratic(p[2], 0.5 * p[1], p[0], all);
        size_t kept = 0;
        for (size_t i = 0; i < static_cast<size_t>(n); ++i) {
            if (all[i] >= lo && all[i] <= hi) roots[kept++] = all[i];
        }
        return kept;
    } else {
        Poly<N> high;
        std::reverse_copy(p.begin(), p.end(), high.begin());
        return static_cast<size_t>(solve_polynomial(high, lo, hi, roots));
    }
}

/// Directions along and across a ray.
struct RayFrame {
    explicit RayFrame(const Ray& ray) : origin(ray.origin), length(glm::length(ray.direction)) {
        along = ray.direction / length;
        const Vec3 size = glm::abs(along);
        const Vec3 axis = size.x <= size.y && size.x <= size.z ? Vec3{1, 0, 0}
                          : size.y <= size.z                   ? Vec3{0, 1, 0}
                                                               : Vec3{0, 0, 1};
        u = glm::normalize(glm::cross(along, axis));
        v = glm::cross(along, u);
    }
    Vec3 origin;
    double length;
    Vec3 along, u, v;
};

/// Where balls meet a ray, without gaps: distances with the piece and place of the balls that make the ends.
struct Way {
    double in = 0, out = 0;
    uint32_t in_piece = 0, out_piece = 0;
    double in_w = 0, out_w = 0;
};

/// One piece as a ray sees it; degree N of the curve.
template <size_t N>
class PieceView {
public:
    /// `level` is added to the squared radius.
    PieceView(const SweepPiece& piece, uint32_t number, const RayFrame& frame, double level)
        : number_(number) {
        Poly<N> u;
        Poly<N> v;
        Poly<N> r;
        for (size_t i = 0; i <= N; ++i) {
            const Vec3 c = Vec3{piece.power[i]} - (i == 0 ? frame.origin : Vec3{0.0});
            along_[i] = glm::dot(c, frame.along);
            u[i] = glm::dot(c, frame.u);
            v[i] = glm::dot(c, frame.v);
            r[i] = piece.power[i].w;
        }
        const Poly<2 * N> uu = product<N, N>(u, u);
        const Poly<2 * N> vv = product<N, N>(v, v);
        room_ = product<N, N>(r, r);
        for (size_t i = 0; i <= 2 * N; ++i) room_[i] -= uu[i] + vv[i];
        room_[0] += level;
    }

    /// Calls take(way, place of a ball on it) for every range of balls that the ray meets. With
    /// `from_surface` no ball is around the ray's origin, so that a range ends where centres pass it.
    template <class Take>
    void each_way(bool from_surface, Take&& take) const {
        std::array<double, 3 * N + 2> cuts;
        cuts[0] = 0.0;
        size_t n = 1 + roots_of<2 * N>(room_, 0.0, 1.0, std::span(cuts).subspan(1));
        std::array<double, N> passes{};
        size_t passing = 0;
        if (from_surface) {
            passing = roots_of<N>(along_, 0.0, 1.0, passes);
            for (size_t i = 0; i < passing; ++i) cuts[n++] = passes[i];
            std::sort(cuts.begin() + 1, cuts.begin() + static_cast<std::ptrdiff_t>(n));
        }
        cuts[n++] = 1.0;
        const auto ends_range = [&](double w) {
            return std::find(passes.begin(), passes.begin() + static_cast<std::ptrdiff_t>(passing), w) !=
                   passes.begin() + static_cast<std::ptrdiff_t>(passing);
        };
        for (size_t i = 0; i + 1 < n;) {
            if (!is_met(cuts[i], cuts[i + 1])) {
                ++i;
                continue;
            }
            size_t end = i + 1;
            while (end + 1 < n && !ends_range(cuts[end]) && is_met(cuts[end], cuts[end + 1])) ++end;
            take(way_between(cuts[i], cuts[end]), along(0.5 * (cuts[i] + cuts[end])));
            i = end;
        }
    }

private:
    bool is_met(double lo, double hi) const { return hi > lo && value<2 * N>(room_, 0.5 * (lo + hi)) > 0.0; }
    double along(double w) const { return value<N>(along_, w); }

    Way way_between(double lo, double hi) const {
        Way way;
        way.in_piece = way.out_piece = number_;
        way.in = std::numeric_limits<double>::infinity();
        way.out = -way.in;
        const auto look = [&](double w) {
            const double half = std::sqrt(std::max(value<2 * N>(room_, w), 0.0));
            const double a = along(w);
            if (a - half < way.in) {
                way.in = a - half;
                way.in_w = w;
            }
            if (a + half > way.out) {
                way.out = a + half;
                way.out_w = w;
            }
        };
        look(lo);
        look(hi);
        const auto slope = derivative<N>(along_);
        const auto room_slope = derivative<2 * N>(room_);
        auto turn = product<2 * N - 1, 2 * N - 1>(room_slope, room_slope);
        const auto other = product<2 * N, 2 * N - 2>(room_, product<N - 1, N - 1>(slope, slope));
        for (size_t i = 0; i < turn.size(); ++i) turn[i] -= 4.0 * other[i];
        std::array<double, 4 * N - 2> roots;
        size_t n = roots_of<4 * N - 2>(turn, lo, hi, roots);
        for (size_t i = 0; i < n; ++i) look(roots[i]);
        // Where a' is about 0 they come in pairs too close to be told, around those of D'.
        n = roots_of<2 * N - 1>(room_slope, lo, hi, roots);
        for (size_t i = 0; i < n; ++i) look(roots[i]);
        return way;
    }

    uint32_t number_;
    Poly<N> along_;
    Poly<2 * N> room_;
};

/// True if no ball of the piece can meet the ray.
bool passes_by(const SweepPiece& piece, const RayFrame& frame) {
    const double reach = piece.largest_radius();
    double u_lo = std::numeric_limits<double>::infinity();
    double u_hi = -u_lo;
    double v_lo = u_lo;
    double v_hi = u_hi;
    for (const Ball& ball : piece.control) {
        const Vec3 c = Vec3{ball} - frame.origin;
        const double u = glm::dot(c, frame.u);
        const double v = glm::dot(c, frame.v);
        u_lo = std::min(u_lo, u);
        u_hi = std::max(u_hi, u);
        v_lo = std::min(v_lo, v);
        v_hi = std::max(v_hi, v);
    }
    constexpr double room = 1.0 + 1e-9;
    const double far = room * reach;
    return u_lo > far || u_hi < -far || v_lo > far || v_hi < -far;
}

/// The ball of a piece that lies deepest around `p`: squared distance less squared radius, and where.
template <size_t N>
std::pair<double, double> deepest(const SweepPiece& piece, const Vec3& p) {
    Poly<2 * N> f{};
    for (int axis = 0; axis < 4; ++axis) {
        Poly<N> c;
        for (size_t i = 0; i <= N; ++i) c[i] = piece.power[i][axis];
        if (axis < 3) c[0] -= p[axis];
        const Poly<2 * N> cc = product<N, N>(c, c);
        for (size_t i = 0; i <= 2 * N; ++i) f[i] += axis < 3 ? cc[i] : -cc[i];
    }
    std::pair<double, double> best{f[0], 0.0};
    const auto look = [&](double w) {
        const double v = value<2 * N>(f, w);
        if (v < best.first) best = {v, w};
    };
    look(1.0);
    std::array<double, 2 * N> roots;
    const size_t n = roots_of<2 * N - 1>(derivative<2 * N>(f), 0.0, 1.0, roots);
    for (size_t i = 0; i < n; ++i) look(roots[i]);
    return best;
}

std::pair<double, double> deepest(const SweepPiece& piece, const Vec3& p) {
    return piece.is_straight ? deepest<1>(piece, p) : deepest<3>(piece, p);
}

bool is_near(const Bounds& box, const Vec3& p, double distance) {
    return Bounds{box.lo - distance, box.hi + distance}.contains(p);
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

double SweepPiece::largest_radius() const {
    double r = 0.0;
    for (const Ball& ball : control) r = std::max(r, std::abs(ball.w));
    return r;
}

Bounds SweepPiece::box() const {
    Bounds box;
    for (const Ball& ball : control) {
        box.include(Vec3{ball} - std::abs(ball.w));
        box.include(Vec3{ball} + std::abs(ball.w));
    }
    return box;
}

SphereSweep::SphereSweep(std::vector<SweepPiece> pieces, const Bounds& extent)
    : pieces_(std::move(pieces)), extent_(extent) {
    for (const SweepPiece& piece : pieces_) bounds_.include(piece.box());
}

bool SphereSweep::inside(const Vec3& p) const {
    return std::ranges::any_of(pieces_, [&](const SweepPiece& piece) {
        return piece.box().contains(p) && deepest(piece, p).first <= 0.0;
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
    size_t first = 0;
    size_t last = pieces_.size();
    if (ray.starts_on_surface && ray.origin_part != any_part) {
        // A joint belongs to both pieces.
        first = ray.origin_part - std::min<size_t>(ray.origin_part, 1);
        last = std::min<size_t>(ray.origin_part + 2, last);
    }
    double best = std::numeric_limits<double>::infinity();
    size_t best_piece = 0;
    double best_w = 0.0;
    for (size_t i = first; i < last; ++i) {
        if (!ray.starts_on_surface && !is_near(pieces_[i].box(), o, ray.origin_error)) continue;
        const auto [f, w] = deepest(pieces_[i], o);
        if (f < best) {
            best = f;
            best_piece = i;
            best_w = w;
        }
    }
    if (!std::isfinite(best)) return std::nullopt;
    const Vec3 center{pieces_[best_piece].at(best_w)};
    if (!ray.starts_on_surface && std::abs(best) > 2.0 * ray.origin_error * glm::length(o - center))
        return std::nullopt;
    return Start{best, static_cast<uint32_t>(best_piece), best_w};
}

void SphereSweep::crossings(const ShapeRay& ray, Crossings& out) const {
    const RayFrame frame(ray.ray);
    const auto start = start_of(ray);
    thread_local std::vector<Way> ways;
    ways.clear();
    // From the surface the balls lie either ahead or behind: none is around the origin.
    const auto take = [&](const Way& way, double place) {
        if (!start || place > 0.0) ways.push_back(way);
    };
    for (uint32_t i = 0; i < pieces_.size(); ++i) {
        if (passes_by(pieces_[i], frame)) continue;
        const double level = start ? start->level : 0.0;
        if (pieces_[i].is_straight) {
            PieceView<1>(pieces_[i], i, frame, level).each_way(start.has_value(), take);
        } else {
            PieceView<3>(pieces_[i], i, frame, level).each_way(start.has_value(), take);
        }
    }
    bool leaves = false;
    if (start) {
        // The way through the ball at the origin: its entry is there, and no answer.
        const Vec3 center{pieces_[start->piece].at(start->w)};
        const double through = 2.0 * glm::dot(center - frame.origin, frame.along);
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
        // Who has left has entered what he leaves next, however near.
        add(leaves ? std::max(way.in, first) : way.in, way.in_piece, way.in_w);
        add(way.out, way.out_piece, way.out_w);
    }
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
