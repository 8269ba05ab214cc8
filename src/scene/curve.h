#pragma once
#include <variant>

namespace rb {

/// How numbers in a file relate to light: a power, or the sRGB curve.
struct SrgbCurve {
    friend bool operator==(SrgbCurve, SrgbCurve) = default;
};
using GammaCurve = std::variant<SrgbCurve, double>;

/// sRGB transfer curve (IEC 61966-2-1), linear to encoded and back; negative values stay linear.
float srgb_encode(float linear);
float srgb_decode(float encoded);

/// A transfer curve ready to use: how stored numbers relate to linear light.
class Curve {
public:
    enum class Kind { linear, power, srgb };

    Curve() = default;
    /// A power within 1 % of 1 counts as linear (textures spec 10.2).
    explicit Curve(const GammaCurve& gamma);

    float encode(float linear) const;
    float decode(float encoded) const;
    Kind kind() const { return kind_; }
    float power() const { return power_; }
    /// True if no visible difference lies between the two: same kind, powers within 1 %.
    bool same_as(const Curve& other) const;

private:
    Kind kind_ = Kind::linear;
    float power_ = 1;
};

}  // namespace rb
