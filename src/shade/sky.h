#pragma once
#include "patterns/pigment_program.h"
#include "scene/scene.h"

#include <array>

namespace rb {

/// What a ray sees that hits nothing.
struct SkyLight {
    Rgb rgb{0.0f};
    float transmit = 0;
};

/// sky_sphere and background (manual 3.4.8, 3.4.1.3).
class SkyProgram {
public:
    /// `alpha_output`: the picture may be see-through where a see-through background is.
    SkyProgram(const std::optional<SkySphere>& sky, const std::optional<Color>& background,
               const PatternSettings& settings, bool before_37, bool alpha_output);

    /// True if there is only a background.
    bool is_plain() const { return pigments_.empty(); }
    const SkyLight& plain(bool alpha) const { return plain_[alpha ? 1 : 0]; }

    /// `shows_alpha[i]`: the ray counts for alpha output, which then may see through the background.
    void evaluate(std::span<const Vec3> directions, std::span<const uint8_t> shows_alpha,
                  std::span<SkyLight> out) const;

private:
    /// Adds what is behind `light`, of which the sky lets `filter` through.
    void put_background(const Rgb& filter, bool alpha, SkyLight& light) const;
    SkyLight plain_background(bool alpha) const;

    std::vector<PigmentProgram> pigments_;  ///< top first
    Rgb emission_{1.0f};
    Transform world_from_sky_;
    Color background_;
    struct Ground {
        Rgb light{0.0f};
        Rgb passed{0.0f};
    };
    std::array<Ground, 2> ground_;  ///< the background without and with alpha
    std::array<SkyLight, 2> plain_;
    bool has_background_ = false;
    bool before_37_ = false;
};

}  // namespace rb
