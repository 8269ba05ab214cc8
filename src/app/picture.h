#pragma once
#include "app/settings.h"

namespace rb {

/// Film to file values: alpha made straight, gamma encoded (linear for OpenEXR and HDR), grey if asked
/// (shading spec 17, textures spec 10).
/// The rows refer to the film.
PixelRows picture_of(const Film& film, const std::optional<GammaCurve>& assumed_gamma,
                     const Settings& settings);

}  // namespace rb
