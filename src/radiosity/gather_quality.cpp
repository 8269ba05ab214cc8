#include "radiosity/gather_quality.h"

#include <algorithm>
#include <cmath>

namespace rb {

namespace {

constexpr int fewest_rays = 5;
constexpr int most_rays = 1 << 16;

constexpr double loosest_bound = 0.27;

/// The language's bounds are for records without gradients: with them errors shrink much faster than the
/// bound, and many records that say the same even out their noise. Looser ones than `loosest_bound` would
/// save little.
double bound_for(double written) {
    constexpr double share = 0.75;
    constexpr double usual = 0.25;
    if (written < usual) return share * usual * std::pow(written / usual, 0.25);
    return std::min(loosest_bound, share * written);
}

/// Smoothing does what the rays that are left out would have done, as far as records are so coarse that few
/// rays are asked for.
double rays_for(int count) {
    constexpr int left_out = 25;
    constexpr int few = 35;
    return std::clamp(count - left_out, std::min(few, count), most_rays);
}

}  // namespace

GatherQuality::GatherQuality(const RadiositySettings& settings, bool smooth, double error)
    : minimum_radius(settings.minimum_reuse), maximum_radius(settings.maximum_reuse) {
    double count = smooth ? rays_for(settings.count) : std::min(settings.count, most_rays);
    double bound = bound_for(settings.error_bound * settings.low_error_factor);
    if (error > 0.0) {
        // Measured: errors grow about as the bound, and shrink as the number of rays, to these powers.
        constexpr double usual = 0.005;
        constexpr double finest_radius = 0.004;
        count = std::clamp(256.0 * std::pow(usual / error, 1.5), 24.0, double{most_rays});
        bound = std::min(loosest_bound, 0.13 * std::pow(error / usual, 2.0 / 3.0));
        minimum_radius = std::min(minimum_radius, finest_radius);
    }
    minimum_reach = error > 0.0 ? minimum_radius * bound : settings.minimum_reuse * settings.error_bound;
    // Later bounces show less of their errors.
    for (int depth = 0; depth < settings.recursion_limit; ++depth) {
        rays.push_back(std::max(fewest_rays, static_cast<int>(std::ldexp(count, -depth))));
        bounds.push_back(std::ldexp(bound, depth));
    }
}

}  // namespace rb
