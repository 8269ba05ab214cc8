#pragma once
#include "shade/integrator.h"

#include <cmath>

namespace rb {

/// A sample with its colour as comparisons want it.
struct ComparableSample {
    Radiance light;
    Rgb code{0.0f};  ///< encoded within one part in 10,000; not a number where that is not known
    float size = 0;  ///< sum of all magnitudes
};

/// Distance between two samples after gamma encoding; sum over the channels and transmit.
class SampleDistance {
public:
    SampleDistance(const std::optional<GammaCurve>& assumed_gamma, double antialias_gamma);
    double operator()(const Radiance& a, const Radiance& b) const;

    ComparableSample comparable(const Radiance& light) const {
        const Rgb code{roughly_encoded(light.rgb.x), roughly_encoded(light.rgb.y),
                       roughly_encoded(light.rgb.z)};
        const Rgb size = glm::abs(code);
        return {light, code, size.x + size.y + size.z + std::abs(light.transmit)};
    }
    /// Same answer as (*this)(a, b) >= threshold, but nearly always without a power function.
    bool at_least(const ComparableSample& a, const ComparableSample& b, double threshold) const {
        const Rgb apart = glm::abs(a.code - b.code);
        const float clear = std::abs(a.light.transmit - b.light.transmit);
        const auto rough = static_cast<double>(apart.x + apart.y + apart.z + clear);
        constexpr double table_error = 2e-4;
        const double margin = table_error * static_cast<double>(a.size + b.size);
        if (rough + margin < threshold) return false;
        if (rough - margin > threshold) return true;
        return exactly_at_least(a, b, threshold);
    }

private:
    double encoded(float v) const;
    float roughly_encoded(float v) const;
    bool exactly_at_least(const ComparableSample& a, const ComparableSample& b, double threshold) const;

    bool is_srgb_ = false;
    double exponent_ = 1;
    bool raw_ = false;
    std::vector<float> table_;  ///< encoded values of floats whose last 17 bits are 0, from table_least on
};

}  // namespace rb
