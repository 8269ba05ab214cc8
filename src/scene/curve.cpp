#include "scene/curve.h"

#include <algorithm>
#include <cmath>

namespace rb {

float srgb_encode(float linear) {
    return linear <= 0.0031308f ? 12.92f * linear : 1.055f * std::pow(linear, 1.0f / 2.4f) - 0.055f;
}

float srgb_decode(float encoded) {
    return encoded < 0.04045f ? encoded / 12.92f : std::pow((encoded + 0.055f) / 1.055f, 2.4f);
}

Curve::Curve(const GammaCurve& gamma) {
    if (std::holds_alternative<SrgbCurve>(gamma)) {
        kind_ = Kind::srgb;
        return;
    }
    power_ = static_cast<float>(std::get<double>(gamma));
    kind_ = std::abs(power_ - 1.0f) <= 0.01f ? Kind::linear : Kind::power;
}

float Curve::encode(float linear) const {
    switch (kind_) {
        case Kind::linear:
            return linear;
        case Kind::power:
            return std::pow(std::max(linear, 0.0f), 1.0f / power_);
        case Kind::srgb:
            return srgb_encode(linear);
    }
    return linear;
}

float Curve::decode(float encoded) const {
    switch (kind_) {
        case Kind::linear:
            return encoded;
        case Kind::power:
            return std::pow(std::max(encoded, 0.0f), power_);
        case Kind::srgb:
            return srgb_decode(encoded);
    }
    return encoded;
}

bool Curve::same_as(const Curve& other) const {
    if (kind_ != other.kind_) return false;
    return kind_ != Kind::power || std::abs(power_ / other.power_ - 1.0f) <= 0.01f;
}

}  // namespace rb
