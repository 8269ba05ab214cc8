#pragma once
#include "scene/color.h"

namespace rb {

/// Colour of the band of light between two wavelengths in nanometres, so that equal bands of the visible
/// range add up to about white times their number (spec: shading 10.3, 19.1).
Rgb band_hue(double wavelength, double width);

}  // namespace rb
