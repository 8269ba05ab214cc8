#pragma once
#include "render/antialias.h"

namespace rb {

/// Method 1 (shading spec 12.3): pixels that differ from the one to the left or above get depth^2 samples
/// more. `borders`: what other blocks know already, or null.
void render_by_neighbours(Sampler& sampler, const PixelBlock& block, const AntialiasOptions& options,
                          const SampleDistance& distance, BlockBorders* borders, std::span<Radiance> out);

/// Method 2 (shading spec 12.4): pixels whose corners differ are quartered, `depth` times at the most.
void render_by_corners(Sampler& sampler, const PixelBlock& block, const AntialiasOptions& options,
                       const SampleDistance& distance, std::span<Radiance> out);

/// Method 3 of POV-Ray 3.8 (shading spec 20.2): a pixel gets samples until those of it and the four pixels
/// beside it say, with the options' confidence, that the mean is known within the threshold; 4^depth at the
/// most. Samples are spread evenly instead of at random, and pixels of other blocks are not looked at, as in
/// the reference.
void render_by_confidence(Sampler& sampler, const PixelBlock& block, const AntialiasOptions& options,
                          const SampleDistance& distance, std::span<Radiance> out);

/// Each pixel gets samples until its standard error, gamma-encoded, is estimated to be `options.error` at the
/// most, or it has `options.max_samples`. First its corners are looked at, which it shares with its
/// neighbours; where they agree well enough they are all. Else it gets samples of its own, and their number
/// doubles from step to step. The error is estimated from the means of the four quarters of the samples, each
/// of which covers the pixel evenly; since whole and quarters together cover it more evenly still, the
/// estimate is rather too large. Lest a pixel stops by chance, it has at least half of the samples of the
/// pixels around it in its block. Through an open lens there are no corners, and each sample is one ray.
void render_by_error(Sampler& sampler, const PixelBlock& block, const AntialiasOptions& options,
                     const SampleDistance& distance, std::span<Radiance> out);

}  // namespace rb
