#pragma once
#include "shade/integrator.h"

#include <bit>
#include <cmath>
#include <emmintrin.h>
#include <limits>
#include <vector>

namespace rb {

/// A sample with its colour as comparisons want it.
struct ComparableSample {
    Radiance light;
    float size = 0;  ///< sum of all magnitudes of the code
    /// Red, green and blue encoded within one part in 10,000, and transmit; not a number where that is not
    /// known.
    __m128 code = _mm_setzero_ps();
};

/// Distance between two samples after gamma encoding; sum over the channels and transmit.
class SampleDistance {
public:
    SampleDistance(const std::optional<GammaCurve>& assumed_gamma, double antialias_gamma);
    double operator()(const Radiance& a, const Radiance& b) const;
    /// A channel as comparisons see it: gamma-encoded, 0 below 0.
    double encoded(float v) const;

    ComparableSample comparable(const Radiance& light) const {
        const __m128 code = _mm_setr_ps(roughly_encoded(light.rgb.x), roughly_encoded(light.rgb.y),
                                        roughly_encoded(light.rgb.z), light.transmit);
        return {light, sum_of_magnitudes(code), code};
    }
    /// Same answer as (*this)(a, b) >= threshold, but nearly always without a power function.
    bool at_least(const ComparableSample& a, const ComparableSample& b, double threshold) const {
        const float rough = sum_of_magnitudes(_mm_sub_ps(a.code, b.code));
        // Room for the table, and for the order of single precision sums.
        constexpr float table_error = 2e-4f;
        const float margin = table_error * (a.size + b.size);
        const auto limit = static_cast<float>(threshold);
        if (rough + margin < limit) return false;
        if (rough - margin > limit) return true;
        return exactly_at_least(a, b, threshold);
    }

private:
    /// 64 entries per power of two, linear between them: 4e-5 off at the most.
    static constexpr uint32_t table_shift = 17;
    static constexpr float table_least = 0x1p-20f;
    static constexpr float table_greatest = 0x1p10f;

    static float sum_of_magnitudes(__m128 v) {
        const __m128 magnitudes = _mm_andnot_ps(_mm_set1_ps(-0.0f), v);
        const __m128 pairs = _mm_add_ps(magnitudes, _mm_movehl_ps(magnitudes, magnitudes));
        return _mm_cvtss_f32(_mm_add_ss(pairs, _mm_shuffle_ps(pairs, pairs, 1)));
    }
    float roughly_encoded(float v) const {
        if (raw_) return v;
        if (!(v >= table_least && v < table_greatest))
            return v == 0.0f ? 0.0f : std::numeric_limits<float>::quiet_NaN();
        const auto bits = std::bit_cast<uint32_t>(v);
        const uint32_t slot = (bits >> table_shift) - (std::bit_cast<uint32_t>(table_least) >> table_shift);
        constexpr float step = 1u << table_shift;
        const float t = static_cast<float>(bits & ((1u << table_shift) - 1)) / step;
        return table_[slot] + t * (table_[slot + 1] - table_[slot]);
    }
    bool exactly_at_least(const ComparableSample& a, const ComparableSample& b, double threshold) const;

    bool is_srgb_ = false;
    double exponent_ = 1;
    bool raw_ = false;
    std::vector<float> table_;  ///< encoded values of floats whose last 17 bits are 0, from table_least on
};

}  // namespace rb
