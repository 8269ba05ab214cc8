#pragma once
#include "app/settings.h"

namespace rb {

/// Film to file values: alpha made straight, gamma encoded (light for OpenEXR, HDR and
/// dithering), grey if asked
/// (shading spec 17, textures spec 10).
/// The rows refer to the film.
PixelRows picture_of(const Film& film, const std::optional<GammaCurve>& assumed_gamma,
                     const Settings& settings);

/// How the picture is dithered, if it is: its rows then hold light.
Dithering dithering_of(const std::optional<GammaCurve>& assumed_gamma, const Settings& settings);

}  // namespace rb
