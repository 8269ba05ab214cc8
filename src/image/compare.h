#pragma once
#include "image/pixels.h"

namespace rb {

/// How far two pictures of the same size lie apart. Values are taken as 8-bit numbers (0..255).
struct ImageDifference {
    double rmse = 0;       ///< root of the mean squared error over all colour channels, in 1/255 units
    double share_off = 0;  ///< share of pixels with any colour channel off by more than 8/255
    double ssim = 1;       ///< mean structural similarity (Wang et al. 2004), 7x7 windows, mean over channels
    double max_error = 0;  ///< largest channel difference, in 1/255 units
};

/// Throws IoError if the sizes differ.
ImageDifference compare(const Pixels& a, const Pixels& b);

/// The largest channel difference per pixel as a heat map: black (equal), blue, green, yellow, red (64/255 or
/// more).
Pixels heat_map(const Pixels& a, const Pixels& b);

}  // namespace rb
