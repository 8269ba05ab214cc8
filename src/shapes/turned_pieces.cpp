#include "shapes/turned_pieces.h"

#include "math/bernstein.h"
#include "math/roots.h"

#include <algorithm>
#include <cmath>

namespace rb {

namespace {

template <size_t N>
double value(const std::array<double, N>& c, double x) {
    double f = 0.0;
    for (const double a : c) f = f * x + a;
    return f;
}

template <size_t N>
double slope_of(const std::array<double, N>& c, double x) {
    double f = 0.0;
    for (size_t i = 0; i + 1 < N; ++i) f = f * x + static_cast<double>(N - 1 - i) * c[i];
    return f;
}

/// Sign changes of the lower `degree` powers of c.
int changes(const std::array<double, 7>& c, int degree, bool start, bool end, std::array<double, 6>& w) {
    const auto of = [&]<size_t N>() {
        std::array<double, N + 1> low;
        std::copy(c.end() - static_cast<std::ptrdiff_t>(N + 1), c.end(), low.begin());
        return sign_changes<N>(low, start, end, std::span<double, N>(w.data(), N));
    };
    switch (degree) {
        case 0:
            return 0;
        case 1:
            return of.operator()<1>();
        case 2:
            return of.operator()<2>();
        case 3:
            return of.operator()<3>();
        case 4:
            return of.operator()<4>();
        case 5:
            return of.operator()<5>();
        default:
            return of.operator()<6>();
    }
}

struct Range {
    double lo = std::numeric_limits<double>::infinity();
    double hi = -std::numeric_limits<double>::infinity();
};

/// Includes all values over [0, 1], by the hull of the coefficients of 2^levels parts.
template <size_t N>
void include_values(const std::array<double, N>& b, int levels, Range& range) {
    if (levels > 0) {
        const auto cut = halve(b);
        include_values(cut.left, levels - 1, range);
        include_values(cut.right, levels - 1, range);
        return;
    }
    for (const double x : b) {
        range.lo = std::min(range.lo, x);
        range.hi = std::max(range.hi, x);
    }
}

/// Divides c by w - own, as often as it is zero there: the other crossings stay where they are. `start` and
/// `end`: whether c is negative at the ends.
void divide_by_start(const TurnedPiece& piece, double own, std::array<double, 7>& c, int& degree, bool& start,
                     bool& end) {
    const bool on_axis = (own == 0.0 && piece.start.x == 0.0) || (own == 1.0 && piece.end.x == 0.0);
    for (int times = on_axis && piece.squares_radius ? 2 : 1; times > 0 && degree > 0; --times) {
        for (size_t i = 1; i < 7; ++i) c[i] += own * c[i - 1];
        std::copy_backward(c.begin(), c.end() - 1, c.end());
        c[0] = 0.0;
        --degree;
        if (own > 0.0) start = !start;
        if (own == 0.0) start = c[6] < 0.0;
        if (own == 1.0) end = value(c, 1.0) < 0.0;
    }
}

}  // namespace

Vec2 TurnedPiece::at(double w) const {
    if (w == 0.0) return start;
    if (w == 1.0) return end;
    return {std::sqrt(std::max(squared_radius(w), 0.0)), value(y, w)};
}

double TurnedPiece::squared_radius(double w) const {
    double f = 0.0;
    for (auto i = static_cast<size_t>(6 - degree); i < s.size(); ++i) f = f * w + s[i];
    return f;
}

double TurnedPiece::height(double w) const { return w == 0.0 ? start.y : w == 1.0 ? end.y : value(y, w); }

Vec2 TurnedPiece::slope(double w) const { return {0.5 * slope_of(s, w), slope_of(y, w)}; }

void TurnedLine::look_from_axis() {
    across = d.x * d.x + d.z * d.z;
    t_near = 0.0;
    if (across > 0.0) {
        t_near = -(o.x * d.x + o.z * d.z) / across;
        const double x = o.x + t_near * d.x;
        const double z = o.z + t_near * d.z;
        nearest = x * x + z * z;
    } else {
        nearest = o.x * o.x + o.z * o.z;
    }
    y_near = o.y + t_near * d.y;
    dd = d.y * d.y;
    constexpr double flat = 1e-12;
    level = dd <= flat * across;
    constexpr double least_slope = 1e-6;
    steep = dd >= least_slope * across;
    t_per_height = 1.0 / d.y;
}

double TurnedLine::t_at(const TurnedPiece& piece, double w) const {
    if (steep) return (piece.height(w) - o.y) / d.y;
    const Vec2 p = piece.at(w);
    const double half = std::sqrt(std::max(p.x * p.x - nearest, 0.0) / across);
    return (p.y < y_near) == (d.y < 0.0) ? t_near + half : t_near - half;
}

TurnedPieces::TurnedPieces(std::vector<TurnedPiece> pieces) : pieces_(std::move(pieces)) {
    std::vector<Box> boxes;
    samples_.resize(pieces_.size());
    for (size_t i = 0; i < pieces_.size(); ++i) {
        boxes.push_back(box_of(pieces_[i]));
        for (size_t k = 0; k < sample_count; ++k)
            samples_[i][k] = pieces_[i].at(static_cast<double>(k) / (sample_count - 1));
    }
    tree_ = RangeTree<Box>(boxes);
}

TurnedPieces::Box TurnedPieces::box_of(const TurnedPiece& piece) {
    constexpr int levels = 4;
    Range s;
    Range y;
    include_values(bernstein_over_unit(piece.s), levels, s);
    include_values(bernstein_over_unit(piece.y), levels, y);
    const Vec2 least{std::sqrt(std::max(s.lo, 0.0)), y.lo};
    const Vec2 most{std::sqrt(std::max(s.hi, 0.0)), y.hi};
    const Vec2 lo = glm::min(least, glm::min(piece.start, piece.end));
    const Vec2 hi = glm::max(most, glm::max(piece.start, piece.end));
    constexpr double rounding = 1e-12;
    const Vec2 pad = rounding * glm::max(glm::abs(lo), glm::abs(hi));
    return {{std::max(lo.x - pad.x, 0.0), lo.y - pad.y}, hi + pad};
}

/// By the terms of side(), so that it never contradicts the signs at the ends of a piece.
TurnedPieces::Box::Box(const Vec2& lo, const Vec2& hi)
    : lo_(lo),
      hi_(hi),
      middle_(0.5 * (lo.y + hi.y)),
      half_(0.5 * (hi.y - lo.y)),
      inner_(lo.x * lo.x),
      outer_(hi.x * hi.x) {
    constexpr double rounding = 1e-15;
    half_ += rounding * std::max(std::abs(lo.y), std::abs(hi.y));
}

bool TurnedPieces::Box::may_meet(const TurnedLine& line, double t_min, double t_max) const {
    if (line.level) return true;
    const double off = std::abs(line.y_near - middle_);
    const double least = std::max(off - half_, 0.0);
    const double most = off + half_;
    const double nearest = line.dd * line.nearest;
    const double outer = line.dd * outer_;
    const double far = line.across * most * most;
    constexpr double rounding = 1e-13;
    const double margin = rounding * (far + nearest + outer);
    if (line.across * least * least + nearest - outer > margin) return false;
    if (far + nearest - line.dd * inner_ < -margin) return false;
    // Flatter lines meet it at a t that the height does not tell well.
    if (!line.steep) return true;
    const double t = (middle_ - line.o.y) * line.t_per_height;
    const double reach = half_ * std::abs(line.t_per_height);
    constexpr double t_rounding = 1e-12;
    const double pad = reach + t_rounding * (std::abs(t) + reach);
    return t + pad >= t_min && t - pad <= t_max;
}

TurnedPieces::Contact TurnedPieces::nearest_on(uint32_t index, const Vec2& p) const {
    const TurnedPiece& piece = pieces_[index];
    if (piece.y[0] == 0.0 && piece.y[1] == 0.0 && piece.y[2] != 0.0) {
        // The height alone tells where a point on the piece lies.
        const double w = std::clamp((p.y - piece.y[3]) / piece.y[2], 0.0, 1.0);
        const Vec2 at = piece.at(w);
        constexpr double near = 1e-6;
        if (glm::length(at - p) < near * std::abs(piece.y[2])) return settle(index, p, w, at);
    }
    // Not from an end: on the axis the squared radius has no slope.
    double least = std::numeric_limits<double>::infinity();
    size_t first = 0;
    for (size_t i = 1; i + 1 < sample_count; ++i) {
        const Vec2 off = samples_[index][i] - p;
        const double dd = glm::dot(off, off);
        if (!(dd < least)) continue;
        least = dd;
        first = i;
    }
    const double w = static_cast<double>(first) / (sample_count - 1);
    Contact best = settle(index, p, w, samples_[index][first]);
    for (const double end : {0.0, 1.0}) {
        const double distance = glm::length(piece.at(end) - p);
        if (distance < best.distance) best = {index, end, distance};
    }
    return best;
}

TurnedPieces::Contact TurnedPieces::settle(uint32_t index, const Vec2& p, double w, const Vec2& at) const {
    const TurnedPiece& piece = pieces_[index];
    return settle_on_curve(piece, index, p, w, at, [&](double at_w, const Vec2& here) {
        const Vec2 along = piece.slope(at_w);
        // On the axis the squared radius does not tell the radius' slope.
        return here.x > 0.0 ? Vec2{along.x / here.x, along.y} : Vec2{0.0};
    });
}

TurnedPieces::Contact TurnedPieces::nearest(const Vec2& p, double within) const {
    Contact best{0, 0.0, within};
    tree_.visit([&](const Box& box) { return box.distance(p) < best.distance; },
                [&](uint32_t piece) {
                    const Contact found = nearest_on(piece, p);
                    if (found.distance < best.distance) best = found;
                });
    return best;
}

int TurnedPieces::cross(const TurnedLine& line, uint32_t index, double own, std::array<Hit, 12>& hits) const {
    if (line.level) return cross_level(line, index, own, hits);
    const TurnedPiece& piece = pieces_[index];
    const double dd = line.dd;
    std::array<double, 4> y = piece.y;
    y[3] -= line.y_near;
    std::array<double, 7> c{};
    if (y[0] == 0.0 && y[1] == 0.0) {
        c = {0.0, 0.0, 0.0, 0.0, y[2] * y[2], 2.0 * y[2] * y[3], y[3] * y[3]};
    } else {
        for (size_t i = 0; i < 4; ++i) {
            for (size_t k = 0; k < 4; ++k) c[i + k] += y[i] * y[k];
        }
    }
    for (auto i = static_cast<size_t>(6 - piece.degree); i < 7; ++i)
        c[i] = line.across * c[i] - dd * piece.s[i];
    c[6] += dd * line.nearest;
    bool start = line.side(piece.start) < 0.0;
    bool end = line.side(piece.end) < 0.0;
    int degree = piece.degree;
    if (own >= 0.0) divide_by_start(piece, own, c, degree, start, end);
    std::array<double, 6> w{};
    const int n = changes(c, degree, start, end, w);
    // Of flat lines a polynomial in the height alone tells t badly.
    constexpr double flat = 1e-2;
    const bool settles = dd < flat * line.across;
    for (int i = 0; i < n; ++i) {
        const double at = w[static_cast<size_t>(i)];
        const Hit hit{line.t_at(piece, at), at};
        hits[static_cast<size_t>(i)] = settles ? settled(line, piece, hit) : hit;
    }
    return n;
}

/// A step of Newton's method on height and squared distance from the axis, by t and w together.
TurnedPieces::Hit TurnedPieces::settled(const TurnedLine& line, const TurnedPiece& piece, const Hit& hit) {
    const double out = hit.t - line.t_near;
    const double up = line.o.y + hit.t * line.d.y - piece.height(hit.w);
    const double off = line.across * out * out + line.nearest - piece.squared_radius(hit.w);
    const Vec2 slope = piece.slope(hit.w);
    const double along = 2.0 * line.across * out;
    const double determinant = 2.0 * slope.x * line.d.y - slope.y * along;
    const double w = hit.w + (off * line.d.y - up * along) / determinant;
    const double t = hit.t + (off * slope.y - up * 2.0 * slope.x) / determinant;
    constexpr double near = 1e-6;
    return std::abs(w - hit.w) < near && w >= 0.0 && w <= 1.0 ? Hit{t, w} : hit;
}

/// Each height met gives both ends of a chord; the slope of the ray then moves each a little.
int TurnedPieces::cross_level(const TurnedLine& line, uint32_t index, double own,
                              std::array<Hit, 12>& hits) const {
    const TurnedPiece& piece = pieces_[index];
    if (!(line.across > 0.0)) return 0;
    std::array<double, 7> c{0.0, 0.0, 0.0, piece.y[0], piece.y[1], piece.y[2], piece.y[3] - line.y_near};
    std::array<double, 6> heights{};
    const int found = changes(c, 3, piece.start.y < line.y_near, piece.end.y < line.y_near, heights);
    int n = 0;
    for (int i = 0; i < found; ++i) {
        for (const double sign : {-1.0, 1.0}) {
            double w = heights[static_cast<size_t>(i)];
            double t = line.t_near;
            for (int k = 0; k < 3; ++k) {
                const double chord = piece.squared_radius(w) - line.nearest;
                t = line.t_near + sign * std::sqrt(std::max(chord, 0.0) / line.across);
                const double slope = piece.slope(w).y;
                const double miss = line.o.y + t * line.d.y - value(piece.y, w);
                if (slope != 0.0) w = std::clamp(w + miss / slope, 0.0, 1.0);
            }
            if (piece.squared_radius(w) <= line.nearest) continue;
            constexpr double near = 1e-6;
            const bool starts = own >= 0.0 && std::abs(w - own) < near;
            if (starts && (t < line.t_near) == (0.0 < line.t_near)) t = 0.0;
            hits[static_cast<size_t>(n++)] = {t, w};
        }
    }
    return n;
}

}  // namespace rb
