#include "render/sample_distance.h"

#include <bit>
#include <cmath>

namespace rb {

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

bool SampleDistance::exactly_at_least(const ComparableSample& a, const ComparableSample& b,
                                      double threshold) const {
    return (*this)(a.light, b.light) >= threshold;
}

}  // namespace rb
