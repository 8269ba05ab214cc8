#include "shapes/extrusion.h"

#include <cmath>

#include <fmt/format.h>

namespace rb {

namespace {

Bounds local_box(const SweptOutlines& swept) {
    Bounds box;
    for (const Outline& outline : swept.outlines) {
        for (const double h : {swept.h0, swept.h1}) {
            const double scale = swept.conic ? h : 1.0;
            box.include({outline.lo().x * scale, outline.lo().y * scale, h});
            box.include({outline.hi().x * scale, outline.hi().y * scale, h});
        }
    }
    return box;
}

}  // namespace

Extrusion::Extrusion(std::shared_ptr<const SweptOutlines> swept, const Transform& object_from_local)
    : swept_(std::move(swept)),
      object_from_local_(object_from_local),
      local_stretch_(stretch(object_from_local.backward)) {
    const Bounds box = local_box(*swept_);
    if (box.is_empty()) return;
    box_ = rb::transformed(box, object_from_local.forward);
    const Vec3 pad = 8.0 * std::numeric_limits<double>::epsilon() * (glm::abs(box_.lo) + glm::abs(box_.hi));
    box_ = {box_.lo - pad, box_.hi + pad};
}

Bounds Extrusion::language_extent() const {
    if (swept_->extent.is_empty()) return box_;
    return rb::transformed(swept_->extent, object_from_local_.forward);
}

bool Extrusion::inside(const Vec3& p) const {
    const Vec3 q = object_from_local_.inverse_point(p);
    if (q.z < swept_->h0 || q.z > swept_->h1 || (q.z == swept_->h1 && !swept_->top_inside)) return false;
    if (swept_->conic && q.z == 0.0) return false;
    const Vec2 at = flat(q);
    return std::ranges::any_of(swept_->outlines, [&](const Outline& o) { return o.contains(at); });
}

Extrusion::Local Extrusion::put_on_parts(const ShapeRay& query) const {
    Local ray;
    ray.o = object_from_local_.inverse_point(query.ray.origin);
    ray.d = object_from_local_.inverse_direction(query.ray.direction);
    const double error = query.origin_error * local_stretch_;
    if (query.starts_on_surface) {
        if (query.origin_part != any_part) {
            touch_known_part(query.origin_part, ray);
        } else {
            touch_nearest(inf, ray);
        }
    } else if (error > 0.0 && is_near(query.ray.origin, query.origin_error)) {
        touch_nearest(error, ray);
    }
    if (error > 0.0) {
        for (const uint32_t cap : {cap0, cap1}) {
            if (std::abs(ray.o.z - height(cap)) <= error) ray.o.z = height(cap);
        }
    }
    if (ray.touched != none) {
        const Vec2 p = swept_->outlines[ray.touched].pieces()[ray.contact.piece].at(ray.contact.w);
        const double scale = swept_->conic ? ray.o.z : 1.0;
        ray.o.x = p.x * scale;
        ray.o.y = p.y * scale;
    }
    return ray;
}

/// False if the surface is surely farther from a point of the object's space.
bool Extrusion::is_near(const Vec3& p, double distance) const {
    return Bounds{box_.lo - distance, box_.hi + distance}.contains(p);
}

void Extrusion::touch_known_part(uint32_t part, Local& ray) const {
    if (part < first_wall) {
        ray.o.z = height(part);
        return;
    }
    uint32_t piece = part - first_wall;
    for (uint32_t i = 0; i < swept_->outlines.size(); ++i) {
        const Outline& outline = swept_->outlines[i];
        const auto count = static_cast<uint32_t>(outline.pieces().size());
        if (piece < count) {
            ray.touched = i;
            ray.contact = outline.nearest_on(piece, flat(ray.o));
            return;
        }
        piece -= count;
    }
}

void Extrusion::touch_nearest(double within, Local& ray) const {
    const double h = ray.o.z;
    if (swept_->conic && h == 0.0) return;
    // From distances in the plane of the outlines to those in space.
    const double scale = swept_->conic ? std::abs(h) : 1.0;
    const Vec2 p = flat(ray.o);
    const double tilt = swept_->conic ? 1.0 + glm::length(p) : 1.0;
    double best = within * tilt / scale;
    for (uint32_t i = 0; i < swept_->outlines.size(); ++i) {
        const auto found = swept_->outlines[i].nearest(p, best);
        if (!(found.distance < best)) continue;
        best = found.distance;
        ray.touched = i;
        ray.contact = found;
    }
    if (within < inf) return;
    // The one part that the ray starts on may be a cap.
    for (const uint32_t cap : {cap0, cap1}) {
        if (!has_cap(cap) || !(std::abs(h - height(cap)) < best * scale / tilt)) continue;
        best = std::abs(h - height(cap)) * tilt / scale;
        ray.touched = none;
        ray.o.z = height(cap);
    }
}

bool Extrusion::clip(const Local& ray, Slab& slab) const {
    if (ray.d.z == 0.0) return ray.o.z >= swept_->h0 && ray.o.z <= swept_->h1;
    slab.t_in = (swept_->h0 - ray.o.z) / ray.d.z;
    slab.t_out = (swept_->h1 - ray.o.z) / ray.d.z;
    if (ray.d.z < 0.0) {
        std::swap(slab.t_in, slab.t_out);
        std::swap(slab.in_cap, slab.out_cap);
    }
    return true;
}

bool Extrusion::way_of(const Local& ray, const Slab& slab, double t_min, double t_max, FlatBox& way) const {
    constexpr double rounding = 1e-12;
    const double from = std::max(slab.t_in - rounding * std::abs(slab.t_in), t_min);
    const double to = std::min(slab.t_out + rounding * std::abs(slab.t_out), t_max);
    if (!(from <= to)) return false;
    way = {Vec2{-inf}, Vec2{inf}};
    // Through the apex the image runs to infinity and back.
    if (swept_->conic && !(swept_->h0 > 0.0 || swept_->h1 < 0.0)) return true;
    if (to == inf) return true;
    const Vec2 a = flat(ray.o + from * ray.d);
    const Vec2 b = flat(ray.o + to * ray.d);
    const Vec2 size = glm::abs(Vec2{ray.o.x, ray.o.y}) + to * glm::abs(Vec2{ray.d.x, ray.d.y});
    const double scale = swept_->conic ? std::min(std::abs(swept_->h0), std::abs(swept_->h1)) : 1.0;
    const Vec2 pad = rounding * (glm::abs(a) + glm::abs(b) + size / scale);
    way = {glm::min(a, b) - pad, glm::max(a, b) + pad};
    return true;
}

/// A ray's image in the outlines' plane is a line, under the parallel and under the central projection alike.
void Extrusion::cross(const Outline& outline, uint32_t first, const Local& ray,
                      const Outline::Contact* contact, Walls& walls) const {
    const Vec3 o = swept_->conic ? ray.o : Vec3{ray.o.x, ray.o.y, 1.0};
    const Vec3 d = swept_->conic ? ray.d : Vec3{ray.d.x, ray.d.y, 0.0};
    const Vec3 n = glm::cross(o, d);
    if (n == Vec3{0.0}) {
        walls.always_inside = swept_->conic ? d.z != 0.0 && outline.contains(Vec2{d.x, d.y} / d.z)
                                            : outline.contains({o.x, o.y});
        return;
    }
    // At the end of a piece its neighbour has the crossing, too: leave it to their common sign.
    const bool divides = contact && contact->w > 0.0 && contact->w < 1.0;
    const double reach = contact ? 1e-9 : 0.0;
    const PlaneLine line{n.x, n.y, n.z};
    outline.crossings(line, divides ? contact : nullptr, [&](uint32_t piece, double w) {
        const Vec2 p = outline.pieces()[piece].at(w);
        const double along_u = d.x - d.z * p.x;
        const double along_v = d.y - d.z * p.y;
        double t =
            std::abs(along_u) > std::abs(along_v) ? (o.z * p.x - o.x) / along_u : (o.z * p.y - o.y) / along_v;
        if (contact && !divides && piece == contact->piece && std::abs(w - contact->w) <= reach) t = 0.0;
        walls.add({t, first + piece, w});
    });
    if (divides) walls.add({0.0, first + contact->piece, contact->w});
}

Vec3 Extrusion::normal(const Vec3& p, const Crossing& at) const {
    if (at.part == cap0) return object_from_local_.normal({0, 0, swept_->base_normal});
    if (at.part == cap1) return object_from_local_.normal({0, 0, 1});
    uint32_t index = at.part - first_wall;
    const Outline* outline = swept_->outlines.data();
    while (index >= outline->pieces().size()) {
        index -= static_cast<uint32_t>(outline->pieces().size());
        ++outline;
    }
    const CurvePiece& piece = outline->pieces()[index];
    // A tessellated copy knows the piece but not where on it.
    double w = at.at.x;
    const Vec2 local = flat(object_from_local_.inverse_point(p));
    constexpr double near = 1e-6;
    const bool known = glm::length(piece.at(w) - local) <= near * glm::length(outline->hi() - outline->lo());
    if (!known) w = outline->nearest_on(index, local).w;
    Vec2 along = piece.slope(w);
    if (along == Vec2{0.0}) along = piece.end() - piece.start();
    Vec3 n{along.y, -along.x, 0.0};
    if (swept_->conic) {
        const Vec2 q = piece.at(w);
        n.z = -(q.x * n.x + q.y * n.y);
    }
    return object_from_local_.normal(n);
}

void Extrusion::snap(const Crossing& at, Vec3& p) const {
    if (at.part >= first_wall) return;
    // Only where the axis is one of the object's.
    const auto& r = object_from_local_.forward.row;
    for (int axis = 0; axis < 3; ++axis) {
        if (r[0][axis] == 0.0 && r[1][axis] == 0.0) p[axis] = r[3][axis] + height(at.part) * r[2][axis];
    }
}

std::string Extrusion::describe() const {
    size_t pieces = 0;
    for (const Outline& outline : swept_->outlines) pieces += outline.pieces().size();
    return fmt::format("from {} to {}, {} outlines of {} pieces{}{}", swept_->h0, swept_->h1,
                       swept_->outlines.size(), pieces, swept_->conic ? ", conic" : "",
                       swept_->open ? ", open" : "");
}

}  // namespace rb
