#pragma once
#include <algorithm>
#include <array>

#include <glm/vec3.hpp>

namespace rb {

/// Light or reflectance per channel, in the scene's working space.
using Rgb = glm::vec3;

/// A colour of the scene language: three channels, `filter` (light passes tinted) and `transmit` (light
/// passes untinted). Nothing is clamped.
struct Color {
    float red = 0;
    float green = 0;
    float blue = 0;
    float filter = 0;
    float transmit = 0;

    Rgb rgb() const { return {red, green, blue}; }
    std::array<float, 5> terms() const { return {red, green, blue, filter, transmit}; }
    friend bool operator==(const Color&, const Color&) = default;
};

/// The grey value that the language uses everywhere (manual 3.4.1.1, measured weights).
inline float grey(const Rgb& c) { return 0.297f * c.x + 0.589f * c.y + 0.114f * c.z; }

/// How much of its own light a surface of this colour shows (scenes of version 3.7); may be negative.
inline float opacity(const Color& c) { return 1.0f - c.filter - c.transmit; }

/// What a surface of this colour lets through, per channel.
inline Rgb passed(const Color& c) { return c.rgb() * c.filter + Rgb(c.transmit); }

inline Color operator*(const Color& c, float s) {
    return {c.red * s, c.green * s, c.blue * s, c.filter * s, c.transmit * s};
}
inline Color operator+(const Color& a, const Color& b) {
    return {a.red + b.red, a.green + b.green, a.blue + b.blue, a.filter + b.filter, a.transmit + b.transmit};
}

}  // namespace rb
