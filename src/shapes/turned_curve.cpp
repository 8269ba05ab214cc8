#include "shapes/turned_curve.h"

#include "shapes/revolve.h"

#include <cmath>

#include <fmt/format.h>

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

/// The box of the curve's points (radius, height), with all turns in between.
void include_piece(const TurnedPiece& piece, Vec2& lo, Vec2& hi) {
    constexpr int samples = 64;
    const auto include = [&](double w) {
        const Vec2 p = piece.at(w);
        lo = glm::min(lo, p);
        hi = glm::max(hi, p);
    };
    include(0.0);
    include(1.0);
    // A turn lies where the slope changes its sign: between samples, refined by halving.
    for (int axis = 0; axis < 2; ++axis) {
        for (int i = 0; i < samples; ++i) {
            double a = static_cast<double>(i) / samples;
            double b = static_cast<double>(i + 1) / samples;
            const bool down = piece.slope(a)[axis] < 0.0;
            if (down == (piece.slope(b)[axis] < 0.0)) continue;
            for (int k = 0; k < 60; ++k) {
                const double middle = 0.5 * (a + b);
                ((piece.slope(middle)[axis] < 0.0) == down ? a : b) = middle;
            }
            include(a);
        }
    }
}

}  // namespace

Vec2 TurnedPiece::at(double w) const {
    if (w == 0.0) return start;
    if (w == 1.0) return end;
    return {std::sqrt(std::max(value(s, w), 0.0)), value(y, w)};
}

Vec2 TurnedPiece::slope(double w) const { return {0.5 * slope_of(s, w), slope_of(y, w)}; }

TurnedShape::TurnedShape(std::shared_ptr<const TurnedCurve> curve, const Transform& object_from_local)
    : curve_(std::move(curve)),
      object_from_local_(object_from_local),
      local_stretch_(stretch(object_from_local.backward)) {
    Vec2 lo{std::numeric_limits<double>::infinity()};
    Vec2 hi{-lo};
    for (const TurnedPiece& piece : curve_->pieces) include_piece(piece, lo, hi);
    // Each circle's own box would be tighter under a rotation; the cylinder around all is enough.
    const auto& r = object_from_local.forward.row;
    Vec3 half;
    for (int i = 0; i < 3; ++i) half[i] = hi.x * std::hypot(r[0][i], r[2][i]);
    for (const double y : {lo.y, hi.y}) {
        const Vec3 center = r[3] + y * r[1];
        box_.include({center - half, center + half});
    }
    const Vec3 pad = 1e-14 * (glm::abs(box_.lo) + glm::abs(box_.hi));
    box_ = {box_.lo - pad, box_.hi + pad};
}

Bounds TurnedShape::language_extent() const {
    if (!curve_->extent.is_empty()) return rb::transformed(curve_->extent, object_from_local_.forward);
    return box_;
}

bool TurnedShape::inside(const Vec3& p) const {
    const Vec3 q = object_from_local_.inverse_point(p);
    const double ss = q.x * q.x + q.z * q.z;
    if (!curve_->outline.pieces().empty()) {
        if (ss < curve_->least_radius * curve_->least_radius) return false;
        bool in = false;
        curve_->outline.crossings({0.0, 1.0, -q.y}, nullptr, [&](uint32_t piece, double w) {
            if (curve_->outline.pieces()[piece].at(w).x >= std::sqrt(ss)) in = !in;
        });
        return in;
    }
    for (const TurnedPiece& piece : curve_->pieces) {
        if (q.y < piece.start.y || q.y > piece.end.y) continue;
        return ss <= value(piece.s, (q.y - piece.start.y) / (piece.end.y - piece.start.y));
    }
    return false;
}

double TurnedShape::nearest_on(const TurnedPiece& piece, const Vec2& p, double& best) const {
    constexpr int samples = 16;
    double least = std::numeric_limits<double>::infinity();
    const auto offer = [&](double w) {
        const double d = glm::length(piece.at(w) - p);
        if (d < least) {
            least = d;
            best = w;
        }
    };
    for (int i = 0; i <= samples; ++i) offer(static_cast<double>(i) / samples);
    double w = best;
    for (int i = 0; i < 20; ++i) {
        const Vec2 at = piece.at(w);
        Vec2 along = piece.slope(w);
        if (at.x > 0.0) along.x /= at.x;
        const double length = glm::dot(along, along);
        if (!(length > 0.0) || !std::isfinite(length)) break;
        const double next = std::clamp(w + glm::dot(p - at, along) / length, 0.0, 1.0);
        if (next == w) break;
        w = next;
        offer(w);
    }
    return least;
}

double TurnedShape::nearest_part(const Vec3& o, Line& line) const {
    const Vec2 p{std::hypot(o.x, o.z), o.y};
    double least = std::numeric_limits<double>::infinity();
    for (uint32_t i = 0; i < curve_->pieces.size(); ++i) {
        double w = 0;
        const double d = nearest_on(curve_->pieces[i], p, w);
        if (!(d < least)) continue;
        least = d;
        line.part = i;
        line.w = w;
    }
    if (!curve_->caps) return least;
    for (const uint32_t cap : {base_cap(), base_cap() + 1}) {
        const double d = std::abs(o.y - cap_rim(cap).y);
        if (!(d < least) || p.x > cap_rim(cap).x) continue;
        least = d;
        line.part = cap;
    }
    return least;
}

void TurnedShape::put_on_part(const ShapeRay& query, Line& line) const {
    const double error = query.origin_error * local_stretch_;
    if (query.starts_on_surface && query.origin_part < base_cap()) {
        line.part = query.origin_part;
        nearest_on(curve_->pieces[line.part], {std::hypot(line.o.x, line.o.z), line.o.y}, line.w);
    } else if (query.starts_on_surface && query.origin_part < base_cap() + 2) {
        line.part = query.origin_part;
    } else if (query.starts_on_surface || error > 0.0) {
        const double distance = nearest_part(line.o, line);
        if (!query.starts_on_surface && distance > error) line.part = none;
    }
    if (line.part == none) return;
    if (line.part >= base_cap()) {
        line.o.y = cap_rim(line.part).y;
        return;
    }
    const Vec2 p = curve_->pieces[line.part].at(line.w);
    const double rho = std::hypot(line.o.x, line.o.z);
    if (rho > 0.0) {
        line.o.x *= p.x / rho;
        line.o.z *= p.x / rho;
    }
    line.o.y = p.y;
}

bool TurnedShape::set_up(const ShapeRay& query, Line& line) const {
    line.o = object_from_local_.inverse_point(query.ray.origin);
    line.d = object_from_local_.inverse_direction(query.ray.direction);
    if (query.starts_on_surface || query.origin_error > 0.0) put_on_part(query, line);
    const Vec3& o = line.o;
    const Vec3& d = line.d;
    line.across = d.x * d.x + d.z * d.z;
    if (line.across > 0.0) {
        line.t_near = -(o.x * d.x + o.z * d.z) / line.across;
        const double x = o.x + line.t_near * d.x;
        const double z = o.z + line.t_near * d.z;
        line.nearest = x * x + z * z;
    } else {
        line.nearest = o.x * o.x + o.z * o.z;
    }
    line.y_near = o.y + line.t_near * d.y;
    constexpr double level = 1e-12;
    line.level = d.y * d.y <= level * line.across;
    return true;
}

double TurnedShape::t_at(const Line& line, const Vec2& p) const {
    constexpr double steep = 1e-6;
    if (line.d.y * line.d.y >= steep * line.across) return (p.y - line.o.y) / line.d.y;
    const double half = std::sqrt(std::max(p.x * p.x - line.nearest, 0.0) / line.across);
    return (p.y < line.y_near) == (line.d.y < 0.0) ? line.t_near + half : line.t_near - half;
}

int TurnedShape::cross(const Line& line, uint32_t index, std::array<Hit, 12>& hits) const {
    if (line.level) return cross_level(line, index, hits);
    const TurnedPiece& piece = curve_->pieces[index];
    const double dd = line.d.y * line.d.y;
    std::array<double, 4> y = piece.y;
    y[3] -= line.y_near;
    std::array<double, 7> c{};
    for (size_t i = 0; i < 4; ++i) {
        for (size_t k = 0; k < 4; ++k) c[i + k] += line.across * y[i] * y[k];
    }
    for (size_t i = 0; i < 7; ++i) c[i] -= dd * piece.s[i];
    c[6] += dd * line.nearest;
    bool start = side(line, piece.start) < 0.0;
    const bool end = side(line, piece.end) < 0.0;
    int degree = piece.degree;
    const bool divides = line.part == index && line.w > 0.0 && line.w < 1.0;
    if (divides) {
        for (size_t i = 1; i < 7; ++i) c[i] += line.w * c[i - 1];
        std::copy_backward(c.begin(), c.end() - 1, c.end());
        c[0] = 0.0;
        start = !start;
        --degree;
    }
    std::array<double, 6> w{};
    const int n = changes(c, degree, start, end, w);
    for (int i = 0; i < n; ++i) {
        const double at = w[static_cast<size_t>(i)];
        hits[static_cast<size_t>(i)] = {t_at(line, piece.at(at)), at};
    }
    return n;
}

/// Each height met gives both ends of a chord; the slope of the ray then moves each a little.
int TurnedShape::cross_level(const Line& line, uint32_t index, std::array<Hit, 12>& hits) const {
    const TurnedPiece& piece = curve_->pieces[index];
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
                const double chord = value(piece.s, w) - line.nearest;
                t = line.t_near + sign * std::sqrt(std::max(chord, 0.0) / line.across);
                const double slope = piece.slope(w).y;
                const double miss = line.o.y + t * line.d.y - value(piece.y, w);
                if (slope != 0.0) w = std::clamp(w + miss / slope, 0.0, 1.0);
            }
            if (value(piece.s, w) <= line.nearest) continue;
            constexpr double near = 1e-6;
            const bool own = line.part == index && std::abs(w - line.w) < near;
            if (own && (t < line.t_near) == (0.0 < line.t_near)) t = 0.0;
            hits[static_cast<size_t>(n++)] = {t, w};
        }
    }
    return n;
}

bool TurnedShape::meets_cap(const Line& line, uint32_t cap, double& t) const {
    if (line.d.y == 0.0) return false;
    t = (cap_rim(cap).y - line.o.y) / line.d.y;
    return side(line, cap_rim(cap)) < 0.0;
}

/// A tessellated copy knows the piece but not where on it.
double TurnedShape::parameter_at(const Vec3& local, const Crossing& at) const {
    const TurnedPiece& piece = curve_->pieces[at.part];
    const Vec2 p{std::hypot(local.x, local.z), local.y};
    constexpr double near = 1e-6;
    double w = at.at.x;
    if (glm::length(piece.at(w) - p) > near * (p.x + glm::length(piece.end - piece.start)))
        nearest_on(piece, p, w);
    return w;
}

Vec3 TurnedShape::normal(const Vec3& p, const Crossing& at) const {
    if (at.part >= base_cap()) return object_from_local_.normal({0, at.part == base_cap() ? -1.0 : 1.0, 0});
    const Vec3 q = object_from_local_.inverse_point(p);
    const Vec2 slope = curve_->pieces[at.part].slope(parameter_at(q, at));
    const Vec3 n{slope.y * q.x, -slope.x, slope.y * q.z};
    if (n == Vec3{0.0}) return object_from_local_.normal({0, 1, 0});
    return object_from_local_.normal(n);
}

std::optional<Vec2> TurnedShape::uv(const Vec3& p, const Crossing& at) const {
    const Vec3 q = object_from_local_.inverse_point(p);
    const double u = turn_share(q.x, q.z);
    if (at.part < base_cap())
        return Vec2{u, std::min((at.part + parameter_at(q, at)) / static_cast<double>(base_cap()), 1.0)};
    const double share = std::hypot(q.x, q.z) / cap_rim(at.part).x;
    return Vec2{u, at.part == base_cap() ? share - 1.0 : 2.0 - share};
}

std::optional<TriangleMesh> TurnedShape::tessellate(double tolerance) const {
    const double growth = stretch(object_from_local_.forward);
    const double within = 0.5 * tolerance / growth;
    std::vector<Vec2> profile;
    double widest = 0;
    if (curve_->caps) profile.push_back({0.0, curve_->pieces.front().start.y});
    for (const TurnedPiece& piece : curve_->pieces) {
        int parts = 1;
        const auto chords_are_near = [&] {
            for (int i = 0; i < 8 * parts; ++i) {
                const double first = std::floor(i / 8.0) / parts;
                const double share = (i % 8) / 8.0;
                const Vec2 chord = glm::mix(piece.at(first), piece.at(first + 1.0 / parts), share);
                double w = 0;
                if (nearest_on(piece, chord, w) > 0.9 * within) return false;
            }
            return true;
        };
        constexpr int most = 1024;
        while (parts < most && !chords_are_near()) parts *= 2;
        for (int i = 0; i < parts; ++i) profile.push_back(piece.at(static_cast<double>(i) / parts));
        for (int i = 0; i <= parts; ++i)
            widest = std::max(widest, piece.at(static_cast<double>(i) / parts).x);
    }
    const bool closed = !curve_->caps && curve_->pieces.back().end == curve_->pieces.front().start;
    if (!closed) profile.push_back(curve_->pieces.back().end);
    if (curve_->caps) profile.push_back({0.0, curve_->pieces.back().end.y});
    // revolve() turns about z.
    Affine place = object_from_local_.forward;
    std::swap(place.row[1], place.row[2]);
    std::swap(place.row[0], place.row[1]);
    TriangleMesh mesh = revolve(profile, closed, turn_segments(widest, within), place);
    mesh.error += tolerance;
    return mesh;
}

std::string TurnedShape::describe() const {
    return fmt::format("{} pieces from <{},{}> to <{},{}>{}", curve_->pieces.size(),
                       curve_->pieces.front().start.x, curve_->pieces.front().start.y,
                       curve_->pieces.back().end.x, curve_->pieces.back().end.y,
                       curve_->caps ? ", closed" : "");
}

}  // namespace rb
