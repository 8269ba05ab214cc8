#pragma once
#include "render/sample_distance.h"
#include "render/sampler.h"

#include <span>

namespace rb {

/// Antialiasing as the reference does it (shading spec 12): `method` 0 none, 1 the centre and its neighbours
/// decide on depth^2 more samples, 2 recursive refinement between pixel corners; 3 as version 3.8 does; or
/// our own. See antialias_methods.h for the last two.
struct AntialiasOptions {
    int method = 0;
    double threshold = 0.3;
    int depth = 3;
    double jitter = 1.0;
    double gamma = 2.5;
    double confidence = 0.9;  ///< method 3
    double error = 0.005;     ///< method_by_error: standard error of a pixel, as a picture shows it (0..1)
    uint32_t max_samples = 1024;  ///< of a pixel by that method, but 4 in any case
};

/// AntialiasOptions::method of our own: each pixel is sampled until its error is small enough.
constexpr int method_by_error = 4;

/// A rectangle of pixels [x0, x1) x [y0, y1).
struct PixelBlock {
    int x0 = 0;
    int y0 = 0;
    int x1 = 0;
    int y1 = 0;
    int width() const { return x1 - x0; }
    int height() const { return y1 - y0; }
};

class BlockBorders;

/// Renders one block; `out` gets its pixels row by row. The result depends on the block's place, as in the
/// reference, but not on threads or batches. `borders`: what other blocks know already, or null.
void render_block(Sampler& sampler, const PixelBlock& block, const AntialiasOptions& options,
                  const SampleDistance& distance, BlockBorders* borders, std::span<Radiance> out);

}  // namespace rb
