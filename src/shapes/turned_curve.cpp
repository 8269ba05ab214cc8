#include "shapes/turned_curve.h"

#include "shapes/revolve.h"

#include <cmath>

#include <fmt/format.h>

namespace rb {

namespace {

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

TurnedShape::TurnedShape(std::shared_ptr<const TurnedCurve> curve, const Transform& object_from_local)
    : curve_(std::move(curve)),
      object_from_local_(object_from_local),
      local_stretch_(stretch(object_from_local.backward)) {
    Vec2 lo{std::numeric_limits<double>::infinity()};
    Vec2 hi{-lo};
    for (const TurnedPiece& piece : curve_->pieces.all()) include_piece(piece, lo, hi);
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
    for (const TurnedPiece& piece : curve_->pieces.all()) {
        if (q.y < piece.start.y || q.y > piece.end.y) continue;
        const double radius = piece.at((q.y - piece.start.y) / (piece.end.y - piece.start.y)).x;
        return ss <= radius * radius;
    }
    return false;
}

/// The part nearest to the line's origin, if nearer than `within`.
void TurnedShape::put_on_nearest(double within, Line& line) const {
    const Vec3& o = line.o;
    const Vec2 p{std::sqrt(o.x * o.x + o.z * o.z), o.y};
    const TurnedPieces::Contact contact = curve_->pieces.nearest(p, within);
    double least = contact.distance;
    if (least < within) {
        line.part = contact.piece;
        line.w = contact.w;
    }
    if (!curve_->caps) return;
    for (const uint32_t cap : {base_cap(), base_cap() + 1}) {
        const double d = std::abs(o.y - cap_rim(cap).y);
        if (!(d < least) || p.x > cap_rim(cap).x) continue;
        least = d;
        line.part = cap;
    }
}

void TurnedShape::put_on_part(const ShapeRay& query, Line& line) const {
    if (query.starts_on_surface && query.origin_part < base_cap()) {
        line.part = query.origin_part;
        const double rho = std::sqrt(line.o.x * line.o.x + line.o.z * line.o.z);
        line.w = curve_->pieces.nearest_on(line.part, {rho, line.o.y}).w;
    } else if (query.starts_on_surface && query.origin_part < base_cap() + 2) {
        line.part = query.origin_part;
    } else {
        const double error = query.origin_error * local_stretch_;
        put_on_nearest(query.starts_on_surface ? std::numeric_limits<double>::infinity() : error, line);
    }
    if (line.part == none) return;
    if (line.part >= base_cap()) {
        line.o.y = cap_rim(line.part).y;
        return;
    }
    line.neighbour = neighbour(line.part, line.w);
    const Vec2 p = piece(line.part).at(line.w);
    const double rho = std::sqrt(line.o.x * line.o.x + line.o.z * line.o.z);
    if (rho > 0.0) {
        line.o.x *= p.x / rho;
        line.o.z *= p.x / rho;
    }
    line.o.y = p.y;
}

/// The piece that begins or ends where `part` has its end `w`, if there is one.
uint32_t TurnedShape::neighbour(uint32_t part, double w) const {
    if (w > 0.0 && w < 1.0) return none;
    const uint32_t count = base_cap();
    const uint32_t other = w == 1.0 ? (part + 1) % count : (part + count - 1) % count;
    const bool meets =
        w == 1.0 ? piece(other).start == piece(part).end : piece(other).end == piece(part).start;
    return other != part && meets ? other : none;
}

TurnedShape::Line TurnedShape::set_up(const ShapeRay& query) const {
    Line line;
    line.o = object_from_local_.inverse_point(query.ray.origin);
    line.d = object_from_local_.inverse_direction(query.ray.direction);
    if (query.starts_on_surface || query.origin_error > 0.0) put_on_part(query, line);
    line.look_from_axis();
    return line;
}

bool TurnedShape::meets_cap(const Line& line, uint32_t cap, double& t) const {
    if (line.d.y == 0.0) return false;
    t = (cap_rim(cap).y - line.o.y) / line.d.y;
    return line.side(cap_rim(cap)) < 0.0;
}

/// A tessellated copy knows the piece but not where on it.
double TurnedShape::parameter_at(const Vec3& local, const Crossing& at) const {
    const TurnedPiece& own = piece(at.part);
    const Vec2 p{std::hypot(local.x, local.z), local.y};
    constexpr double near = 1e-6;
    const double w = at.at.x;
    const bool known = glm::length(own.at(w) - p) <= near * (p.x + glm::length(own.end - own.start));
    return known ? w : curve_->pieces.nearest_on(at.part, p).w;
}

Vec3 TurnedShape::normal(const Vec3& p, const Crossing& at) const {
    if (at.part >= base_cap()) return object_from_local_.normal({0, at.part == base_cap() ? -1.0 : 1.0, 0});
    const Vec3 q = object_from_local_.inverse_point(p);
    const Vec2 slope = piece(at.part).slope(parameter_at(q, at));
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
    if (curve_->caps) profile.push_back({0.0, pieces().front().start.y});
    for (uint32_t index = 0; index < base_cap(); ++index) {
        const TurnedPiece& piece = pieces()[index];
        int parts = 1;
        const auto chords_are_near = [&] {
            for (int i = 0; i < 8 * parts; ++i) {
                const double first = std::floor(i / 8.0) / parts;
                const double share = (i % 8) / 8.0;
                const Vec2 chord = glm::mix(piece.at(first), piece.at(first + 1.0 / parts), share);
                if (curve_->pieces.nearest_on(index, chord).distance > 0.9 * within) return false;
            }
            return true;
        };
        constexpr int most = 1024;
        while (parts < most && !chords_are_near()) parts *= 2;
        for (int i = 0; i < parts; ++i) profile.push_back(piece.at(static_cast<double>(i) / parts));
        for (int i = 0; i <= parts; ++i)
            widest = std::max(widest, piece.at(static_cast<double>(i) / parts).x);
    }
    const bool closed = !curve_->caps && pieces().back().end == pieces().front().start;
    if (!closed) profile.push_back(pieces().back().end);
    if (curve_->caps) profile.push_back({0.0, pieces().back().end.y});
    // revolve() turns about z.
    Affine place = object_from_local_.forward;
    std::swap(place.row[1], place.row[2]);
    std::swap(place.row[0], place.row[1]);
    TriangleMesh mesh = revolve(profile, closed, turn_segments(widest, within), place);
    mesh.error += tolerance;
    return mesh;
}

std::string TurnedShape::describe() const {
    return fmt::format("{} pieces from <{},{}> to <{},{}>{}", pieces().size(), pieces().front().start.x,
                       pieces().front().start.y, pieces().back().end.x, pieces().back().end.y,
                       curve_->caps ? ", closed" : "");
}

}  // namespace rb
