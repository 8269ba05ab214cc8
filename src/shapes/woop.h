#pragma once
#include "math/bounds.h"
#include "math/ray.h"
#include "math/twofold.h"

#include <cmath>
#include <limits>

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
    explicit WoopRay(const Ray& ray) {
        // Without branches: which axis is the longest is hard to predict.
        const Vec3 size = glm::abs(ray.direction);
        const int x_longest = static_cast<int>(size.x > size.y) & static_cast<int>(size.x > size.z);
        const int y_longest = static_cast<int>(!(size.x > size.y)) & static_cast<int>(size.y > size.z);
        kz_ = 2 - 2 * x_longest - y_longest;
        kx_ = kz_ == 2 ? 0 : kz_ + 1;
        ky_ = kx_ == 2 ? 0 : kx_ + 1;
        const double* origin = &ray.origin.x;
        const double* direction = &ray.direction.x;
        ox_ = origin[kx_];
        oy_ = origin[ky_];
        oz_ = origin[kz_];
        sz_ = 1.0 / direction[kz_];
        sx_ = direction[kx_] * sz_;
        sy_ = direction[ky_] * sz_;
    }

    /// Edges and vertices belong to every triangle that has them.
    template <class V>
    bool hits(const V& a, const V& b, const V& c, TriangleHit& hit) const {
        const Sheared s = shear(a, b, c);
        if ((s.u < 0.0 || s.v < 0.0 || s.w < 0.0) && (s.u > 0.0 || s.v > 0.0 || s.w > 0.0)) return false;
        return finish(s, hit);
    }

    /// For counting: of the faces of a closed mesh an even number is met, through edges and vertices, too.
    /// The signs are exact, and a ray through an edge counts as one next to it: moved in x by less than
    /// anything, in y by less than that (Edelsbrunner and Muecke 1990).
    template <class V>
    bool hits_once(const V& a, const V& b, const V& c, TriangleHit& hit) const {
        Sheared s = shear(a, b, c);
        s.u = exactly(s.cx, s.by, s.cy, s.bx, s.u);
        s.v = exactly(s.ax, s.cy, s.ay, s.cx, s.v);
        s.w = exactly(s.bx, s.ay, s.by, s.ax, s.w);
        const int u = side(s.u, s.cx - s.bx, s.cy - s.by);
        const int v = side(s.v, s.ax - s.cx, s.ay - s.cy);
        const int w = side(s.w, s.bx - s.ax, s.by - s.ay);
        return u != 0 && u == v && u == w && finish(s, hit);
    }

private:
    friend class WoopBlockRay;
    struct Sheared {
        double ax, ay, az, bx, by, bz, cx, cy, cz;
        double u, v, w;
    };

    template <class V>
    Sheared shear(const V& a, const V& b, const V& c) const {
        // Through pointers: a vector's [] with a variable index costs a branch.
        Sheared s;
        s.az = static_cast<double>((&a.x)[kz_]) - oz_;
        s.bz = static_cast<double>((&b.x)[kz_]) - oz_;
        s.cz = static_cast<double>((&c.x)[kz_]) - oz_;
        s.ax = static_cast<double>((&a.x)[kx_]) - ox_ - sx_ * s.az;
        s.ay = static_cast<double>((&a.x)[ky_]) - oy_ - sy_ * s.az;
        s.bx = static_cast<double>((&b.x)[kx_]) - ox_ - sx_ * s.bz;
        s.by = static_cast<double>((&b.x)[ky_]) - oy_ - sy_ * s.bz;
        s.cx = static_cast<double>((&c.x)[kx_]) - ox_ - sx_ * s.cz;
        s.cy = static_cast<double>((&c.x)[ky_]) - oy_ - sy_ * s.cz;
        s.u = s.cx * s.by - s.cy * s.bx;
        s.v = s.ax * s.cy - s.ay * s.cx;
        s.w = s.bx * s.ay - s.by * s.ax;
        return s;
    }

    bool finish(const Sheared& s, TriangleHit& hit) const {
        const double sum = s.u + s.v + s.w;
        if (sum == 0.0) return false;
        const double inverse = 1.0 / sum;
        hit.t = sz_ * ((s.u * s.az + s.v * s.bz + s.w * s.cz) * inverse);
        hit.at = {s.v * inverse, s.w * inverse};
        return true;
    }

    /// a b - c d, where `rounded` is what double precision makes of it.
    static double exactly(double a, double b, double c, double d, double rounded) {
        constexpr double rounding = 4.0 * std::numeric_limits<double>::epsilon();
        if (std::abs(rounded) > rounding * (std::abs(a * b) + std::abs(c * d))) return rounded;
        return static_cast<double>(Twofold(a) * b + Twofold(-c) * d);
    }

    /// The sign of an edge that runs along (dx, dy), seen from the ray moved; 0 if it is but a point.
    static int side(double edge, double dx, double dy) {
        for (const double v : {edge, dy, -dx}) {
            if (v != 0.0) return v > 0.0 ? 1 : -1;
        }
        return 0;
    }

    double ox_, oy_, oz_;
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
