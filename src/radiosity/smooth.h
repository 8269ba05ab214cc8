#pragma once
#include "radiosity/irradiance_cache.h"

#include <span>

namespace rb {

/// The records with less of the noise that their gathers have by chance: each gets the mean light of the
/// records around it, carried to its place. Those count that each of the two could
/// answer for with an error of three times `bound`, by their wide radii, and whose light differs by no more
/// than chance explains.
std::vector<IrradianceRecord> smoothed(std::span<const IrradianceRecord> records, double bound, int threads);

}  // namespace rb
