#include "image/gamma.h"

#include <charconv>
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

OutputEncoding::OutputEncoding(const std::optional<GammaCurve>& assumed, const GammaCurve& file)
    : file_(file) {
    if (!assumed) {
        passes_ = true;
        return;
    }
    working_ = Curve(*assumed);
    passes_ = working_.same_as(file_);
}

std::optional<GammaCurve> parse_gamma(std::string_view text) {
    if (text.size() == 4 && (text[0] | 32) == 's' && (text[1] | 32) == 'r' && (text[2] | 32) == 'g' &&
        (text[3] | 32) == 'b') {
        return GammaCurve{SrgbCurve{}};
    }
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size() || !(value > 0.0)) return std::nullopt;
    return GammaCurve{value};
}

}  // namespace rb
