#include "shapes/woop.h"

#include <array>

namespace rb {

Bounds clipped_triangle(const Vec3& a, const Vec3& b, const Vec3& c, const Bounds& cell) {
    // Each of the six planes adds at most one corner.
    std::array<Vec3, 9> polygon;
    polygon[0] = a;
    polygon[1] = b;
    polygon[2] = c;
    size_t n = 3;
    for (int axis = 0; axis < 3; ++axis) {
        for (const bool high : {false, true}) {
            const double plane = high ? cell.hi[axis] : cell.lo[axis];
            const double sign = high ? 1.0 : -1.0;
            std::array<double, 9> beyond;
            bool cuts = false;
            for (size_t i = 0; i < n; ++i) {
                beyond[i] = sign * (polygon[i][axis] - plane);
                cuts = cuts || beyond[i] > 0.0;
            }
            if (!cuts) continue;
            std::array<Vec3, 9> kept;
            size_t m = 0;
            for (size_t i = 0; i < n; ++i) {
                const size_t next = i + 1 < n ? i + 1 : 0;
                const Vec3& p = polygon[i];
                const Vec3& q = polygon[next];
                const double dp = beyond[i];
                const double dq = beyond[next];
                if (dp <= 0.0) kept[m++] = p;
                if ((dp < 0.0 && dq > 0.0) || (dp > 0.0 && dq < 0.0)) {
                    // From the inner to the outer end, so that neighbours cut a shared edge at the same
                    // point.
                    Vec3 cut = dp < dq ? p + (q - p) * (dp / (dp - dq)) : q + (p - q) * (dq / (dq - dp));
                    cut[axis] = plane;
                    kept[m++] = cut;
                }
            }
            for (size_t i = 0; i < m; ++i) polygon[i] = kept[i];
            n = m;
            if (n == 0) return {};
        }
    }
    Bounds box;
    for (size_t i = 0; i < n; ++i) box.include(polygon[i]);
    return box;
}

}  // namespace rb
