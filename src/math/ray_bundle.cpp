#include "math/ray_bundle.h"

#include <cmath>

namespace rb {

bool RayBundle::misses_plane(const Vec3& normal, double distance) const {
    // The least and the greatest of height and slope; the magnitudes bound what rounding does.
    double low = -distance;
    double high = -distance;
    double low_slope = 0;
    double high_slope = 0;
    double size = std::abs(distance);
    double slope_size = 0;
    for (int i = 0; i < 3; ++i) {
        const double n = normal[i];
        if (n == 0.0) continue;
        const bool up = n > 0.0;
        low += n * (up ? origins.lo[i] : origins.hi[i]);
        high += n * (up ? origins.hi[i] : origins.lo[i]);
        low_slope += n * (up ? lower[i] : upper[i]);
        high_slope += n * (up ? upper[i] : lower[i]);
        size += std::abs(n) * std::max(std::abs(origins.lo[i]), std::abs(origins.hi[i]));
        slope_size += std::abs(n) * std::max(std::abs(lower[i]), std::abs(upper[i]));
    }
    constexpr double rounding = 1e-9;
    const double error = rounding * size;
    const double slope_error = rounding * slope_size;
    const bool endless = far == std::numeric_limits<double>::infinity();
    if (low > error) {
        if (low_slope - slope_error >= 0.0) return true;
        return !endless && low + far * (low_slope - slope_error) > error;
    }
    if (high < -error) {
        if (high_slope + slope_error <= 0.0) return true;
        return !endless && high + far * (high_slope + slope_error) < -error;
    }
    return false;
}

}  // namespace rb
