#include "render/sample_distance.h"

#include <bit>
#include <cmath>

namespace rb {

namespace {

constexpr uint32_t table_shift =
    17;  ///< 64 entries per power of two, linear between them: 4e-5 off at the most
constexpr float table_least = 0x1p-20f;
constexpr float table_greatest = 0x1p10f;

}  // namespace

SampleDistance::SampleDistance(const std::optional<GammaCurve>& assumed_gamma, double antialias_gamma) {
    double working = 1.0;
    if (assumed_gamma) {
        is_srgb_ = std::holds_alternative<SrgbCurve>(*assumed_gamma);
        if (!is_srgb_) working = std::get<double>(*assumed_gamma);
    }
    exponent_ = working / antialias_gamma;
    raw_ = !is_srgb_ && std::abs(exponent_ - 1.0) <= 0.01;
    if (raw_) return;
    for (uint32_t bits = std::bit_cast<uint32_t>(table_least);; bits += 1u << table_shift) {
        table_.push_back(static_cast<float>(encoded(std::bit_cast<float>(bits))));
        if (std::bit_cast<float>(bits) >= table_greatest) break;
    }
}

double SampleDistance::encoded(float v) const {
    double value = static_cast<double>(v);
    if (raw_) return value;
    if (is_srgb_) value = value < 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
    return value > 0.0 ? std::pow(value, exponent_) : 0.0;
}

double SampleDistance::operator()(const Radiance& a, const Radiance& b) const {
    double sum = std::abs(static_cast<double>(a.transmit) - static_cast<double>(b.transmit));
    for (int c = 0; c < 3; ++c) {
        if (a.rgb[c] != b.rgb[c]) sum += std::abs(encoded(a.rgb[c]) - encoded(b.rgb[c]));
    }
    return sum;
}

float SampleDistance::roughly_encoded(float v) const {
    if (raw_) return v;
    if (!(v >= table_least && v < table_greatest))
        return v == 0.0f ? 0.0f : std::numeric_limits<float>::quiet_NaN();
    const uint32_t bits = std::bit_cast<uint32_t>(v);
    const uint32_t slot = (bits >> table_shift) - (std::bit_cast<uint32_t>(table_least) >> table_shift);
    constexpr float step = 1u << table_shift;
    const float t = static_cast<float>(bits & ((1u << table_shift) - 1)) / step;
    return table_[slot] + t * (table_[slot + 1] - table_[slot]);
}

bool SampleDistance::exactly_at_least(const ComparableSample& a, const ComparableSample& b,
                                      double threshold) const {
    return (*this)(a.light, b.light) >= threshold;
}

}  // namespace rb
