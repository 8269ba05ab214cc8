#pragma once
#include "math/bounds.h"
#include "math/ray.h"

#include <cmath>

namespace rb {

/// What a triangle test finds: the distance, and the weights of the second and third vertex.
struct TriangleHit {
    double t = 0;
    Vec2 at{0.0};
};

/// A ray prepared for the watertight triangle test (Woop, Benthin, Wald 2013): two triangles that share an
/// edge compute the same two products for it, so no ray passes between them. Needs -ffp-contract=off.
class WoopRay {
public:
    explicit WoopRay(const Ray& ray) : origin_(ray.origin) {
        const Vec3 size = glm::abs(ray.direction);
        kz_ = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
        kx_ = (kz_ + 1) % 3;
        ky_ = (kx_ + 1) % 3;
        sz_ = 1.0 / ray.direction[kz_];
        sx_ = ray.direction[kx_] * sz_;
        sy_ = ray.direction[ky_] * sz_;
    }

    /// Edges and vertices belong to every triangle that has them.
    bool hits(const Vec3& a, const Vec3& b, const Vec3& c, TriangleHit& hit) const {
        const Sheared s = shear(a, b, c);
        if ((s.u < 0.0 || s.v < 0.0 || s.w < 0.0) && (s.u > 0.0 || s.v > 0.0 || s.w > 0.0)) return false;
        return finish(s, hit);
    }

    /// For counting: an edge belongs to exactly one of two neighbours, a vertex to exactly one of its fan.
    bool hits_once(const Vec3& a, const Vec3& b, const Vec3& c, TriangleHit& hit) const {
        const Sheared s = shear(a, b, c);
        const double side = s.u + s.v + s.w > 0.0 ? 1.0 : -1.0;
        if (!owns(s.u * side, side * (s.cx - s.bx), side * (s.cy - s.by))) return false;
        if (!owns(s.v * side, side * (s.ax - s.cx), side * (s.ay - s.cy))) return false;
        if (!owns(s.w * side, side * (s.bx - s.ax), side * (s.by - s.ay))) return false;
        return finish(s, hit);
    }

private:
    struct Sheared {
        double ax, ay, az, bx, by, bz, cx, cy, cz;
        double u, v, w;
    };

    Sheared shear(const Vec3& va, const Vec3& vb, const Vec3& vc) const {
        const Vec3 a = va - origin_;
        const Vec3 b = vb - origin_;
        const Vec3 c = vc - origin_;
        Sheared s;
        s.az = a[kz_];
        s.bz = b[kz_];
        s.cz = c[kz_];
        s.ax = a[kx_] - sx_ * s.az;
        s.ay = a[ky_] - sy_ * s.az;
        s.bx = b[kx_] - sx_ * s.bz;
        s.by = b[ky_] - sy_ * s.bz;
        s.cx = c[kx_] - sx_ * s.cz;
        s.cy = c[ky_] - sy_ * s.cz;
        s.u = s.cx * s.by - s.cy * s.bx;
        s.v = s.ax * s.cy - s.ay * s.cx;
        s.w = s.bx * s.ay - s.by * s.ax;
        return s;
    }

    bool finish(const Sheared& s, TriangleHit& hit) const {
        const double sum = s.u + s.v + s.w;
        if (sum == 0.0) return false;
        const double inverse = 1.0 / sum;
        hit.t = sz_ * (s.u * s.az + s.v * s.bz + s.w * s.cz) * inverse;
        hit.at = {s.v * inverse, s.w * inverse};
        return true;
    }

    /// `edge` with the triangle's inside on its positive side, running along (dx, dy).
    static bool owns(double edge, double dx, double dy) {
        return edge > 0.0 || (edge == 0.0 && (dy > 0.0 || (dy == 0.0 && dx > 0.0)));
    }

    Vec3 origin_;
    int kx_, ky_, kz_;
    double sx_, sy_, sz_;
};

/// True if `p` lies within `error` of the triangle's plane: a ray from there can only meet it at its origin.
inline bool in_plane(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c, double error) {
    const Vec3 n = glm::cross(b - a, c - a);
    const double height = glm::dot(n, p - a);
    return height * height <= error * error * glm::dot(n, n);
}

/// The box of the part of a triangle inside `cell` (Sutherland and Hodgman); empty if there is none.
Bounds clipped_triangle(const Vec3& a, const Vec3& b, const Vec3& c, const Bounds& cell);

}  // namespace rb
