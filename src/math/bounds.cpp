#include "math/bounds.h"

#include <cmath>

namespace rb {

bool Bounds::is_finite() const {
    for (int i = 0; i < 3; ++i) {
        if (!std::isfinite(lo[i]) || !std::isfinite(hi[i])) return false;
    }
    return true;
}

double Bounds::half_area() const {
    if (is_empty()) return 0.0;
    const Vec3 s = size();
    return s.x * s.y + s.y * s.z + s.z * s.x;
}

Bounds intersection(const Bounds& a, const Bounds& b) { return {glm::max(a.lo, b.lo), glm::min(a.hi, b.hi)}; }

Bounds transformed(const Bounds& b, const Affine& map) {
    if (b.is_empty()) return b;
    if (!b.is_finite()) return Bounds::everything();
    // Interval arithmetic per output axis (Arvo, Graphics Gems 1990); the error term covers the three
    // roundings.
    Bounds out{map.row[3], map.row[3]};
    Vec3 magnitude = glm::abs(map.row[3]);
    for (int i = 0; i < 3; ++i) {
        const Vec3 a = map.row[static_cast<size_t>(i)] * b.lo[i];
        const Vec3 c = map.row[static_cast<size_t>(i)] * b.hi[i];
        out.lo += glm::min(a, c);
        out.hi += glm::max(a, c);
        magnitude += glm::max(glm::abs(a), glm::abs(c));
    }
    constexpr double gamma4 = 4.0 * std::numeric_limits<double>::epsilon();
    out.lo -= gamma4 * magnitude;
    out.hi += gamma4 * magnitude;
    return out;
}

}  // namespace rb
