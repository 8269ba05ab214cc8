#pragma once
#include "render/lens.h"
#include "render/sample_distance.h"

#include <functional>
#include <span>

namespace rb {

/// Antialiasing as the reference does it (shading spec 12): `method` 0 none, 1 the centre and its neighbours
/// decide on depth^2 more samples, 2 recursive refinement between pixel corners.
struct AntialiasOptions {
    int method = 0;
    double threshold = 0.3;
    int depth = 3;
    double jitter = 1.0;
    double gamma = 2.5;
};

/// A rectangle of pixels [x0, x1) x [y0, y1).
struct PixelBlock {
    int x0 = 0;
    int y0 = 0;
    int x1 = 0;
    int y1 = 0;
    int width() const { return x1 - x0; }
    int height() const { return y1 - y0; }
};

/// Traces samples in batches at continuous picture positions.
class Sampler {
public:
    Sampler(const Integrator& integrator, const CameraRays& rays, const Lens& lens, RayCounters& counters)
        : integrator_(integrator), rays_(rays), lens_(lens), counters_(counters) {}

    void sample(std::span<const Vec2> positions, std::span<Radiance> out);

private:
    void sample_several(std::span<const Vec2> positions, std::span<Radiance> out);
    void sample_through_lens(std::span<const Vec2> positions, std::span<Radiance> out);

    const Integrator& integrator_;
    const CameraRays& rays_;
    const Lens& lens_;
    RayCounters& counters_;
};

class BlockBorders;

/// Renders one block; `out` gets its pixels row by row. The result depends on the block's place, as in the
/// reference, but not on threads or batches. `borders`: what other blocks know already, or null.
void render_block(Sampler& sampler, const PixelBlock& block, const AntialiasOptions& options,
                  const SampleDistance& distance, BlockBorders* borders, std::span<Radiance> out);

}  // namespace rb
