#include "shapes/frustum.h"

#include "shapes/revolve.h"

#include <algorithm>

#include <fmt/format.h>

namespace rb {

Bounds Frustum::bounds() const {
    Bounds box = frame_.circle_bounds(radius_at(profile_.z0), profile_.z0);
    box.include(frame_.circle_bounds(radius_at(profile_.z1), profile_.z1));
    // The circle's extent carries the rounding of one square root and product.
    const Vec3 pad = 4.0 * std::numeric_limits<double>::epsilon() * (glm::abs(box.lo) + glm::abs(box.hi));
    return {box.lo - pad, box.hi + pad};
}

Bounds Frustum::solid_bounds() const {
    const Bounds box = bounds();
    // Open ones reach a little beyond their surface, see inside().
    const Vec3 pad = open_ ? 1e-9 * box.size() + 1e-12 * (glm::abs(box.lo) + glm::abs(box.hi)) : Vec3{0.0};
    return {box.lo - pad, box.hi + pad};
}

Bounds Frustum::language_extent() const {
    const double r = std::max(std::abs(radius_at(profile_.z0)), std::abs(radius_at(profile_.z1)));
    return rb::transformed(Bounds{{-r, -r, profile_.z0}, {r, r, profile_.z1}},
                           frame_.object_from_local.forward);
}

bool Frustum::inside(const Vec3& p) const {
    const Vec3 q = frame_.local_point(p);
    // Closed ones exclude their boundary, open ones include it (spec: geometry 5.2); local units are about 1.
    const double margin = open_ ? 1e-10 : -1e-10;
    if (q.z < profile_.z0 - margin || q.z > profile_.z1 + margin) return false;
    const double r = std::abs(radius_at(q.z)) + margin;
    return r >= 0.0 && q.x * q.x + q.y * q.y <= r * r;
}

bool Frustum::put_on_parts(const ShapeRay& query, Vec3& o) const {
    const double on_cap0 = std::abs(o.z - profile_.z0);
    const double on_cap1 = std::abs(o.z - profile_.z1);
    const double on_side = std::abs(std::sqrt(o.x * o.x + o.y * o.y) - std::abs(radius_at(o.z)));
    bool side_here = false;
    bool cap0_here = false;
    bool cap1_here = false;
    if (query.origin_error > 0.0) {
        const double axial = query.origin_error * frame_.axial_stretch;
        const double radial = query.origin_error * frame_.radial_stretch + std::abs(profile_.slope) * axial;
        side_here = on_side <= radial;
        cap0_here = on_cap0 <= axial;
        cap1_here = on_cap1 <= axial;
    }
    if (query.starts_on_surface) {
        uint32_t part = query.origin_part;
        if (part > cap1) {
            // Compare in object units, or a flat disc would take its caps for its side.
            const double axial = frame_.radial_stretch;
            const double radial = frame_.axial_stretch;
            part = side;
            double nearest = on_side * radial;
            if (!open_ && on_cap0 * axial < nearest) nearest = on_cap0 * axial, part = cap0;
            if (!open_ && on_cap1 * axial < nearest) part = cap1;
        }
        side_here = side_here || part == side;
        cap0_here = cap0_here || part == cap0;
        cap1_here = cap1_here || part == cap1;
    }
    if (cap0_here) o.z = profile_.z0;
    if (cap1_here) o.z = profile_.z1;
    return side_here;
}

void Frustum::snap(const Crossing& at, Vec3& p) const {
    if (at.part == side) return;
    const auto& rows = frame_.object_from_local.forward.row;
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3;
        const int k = (i + 2) % 3;
        if (rows[2][j] != 0.0 || rows[2][k] != 0.0 || rows[0][i] != 0.0 || rows[1][i] != 0.0) continue;
        p[i] = rows[3][i] + (at.part == cap0 ? profile_.z0 : profile_.z1) * rows[2][i];
        return;
    }
}

std::optional<TriangleMesh> Frustum::tessellate(double tolerance) const {
    const double r0 = radius_at(profile_.z0);
    const double r1 = radius_at(profile_.z1);
    const double scale = stretch(frame_.object_from_local.forward);
    const double largest = std::max(std::abs(r0), std::abs(r1));
    const int turns = turn_segments(largest, tolerance / scale);
    std::vector<Vec2> profile;
    if (!open_ && r0 != 0.0) profile.emplace_back(0.0, profile_.z0);
    profile.emplace_back(std::abs(r0), profile_.z0);
    if (r0 * r1 < 0.0) profile.emplace_back(0.0, -profile_.offset / profile_.slope);
    profile.emplace_back(std::abs(r1), profile_.z1);
    if (!open_ && r1 != 0.0) profile.emplace_back(0.0, profile_.z1);
    TriangleMesh mesh = revolve(profile, false, turns, frame_.object_from_local.forward);
    mesh.error += scale * largest * (1.0 - std::cos(pi / turns));
    return mesh;
}

std::string Frustum::describe() const {
    const auto& rows = frame_.object_from_local.forward.row;
    const Vec3 a = rows[3] + profile_.z0 * rows[2];
    const Vec3 b = rows[3] + profile_.z1 * rows[2];
    return fmt::format("from <{},{},{}> to <{},{},{}>{}", a.x, a.y, a.z, b.x, b.y, b.z, open_ ? " open" : "");
}

}  // namespace rb
