#pragma once
#include "render/camera_rays.h"
#include "shade/integrator.h"

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

/// Distance between two samples after gamma encoding; sum over the channels and transmit.
class SampleDistance {
public:
    SampleDistance(const std::optional<GammaCurve>& assumed_gamma, double antialias_gamma);
    double operator()(const Radiance& a, const Radiance& b) const;
    /// Same answer as (*this)(a, b) >= threshold, but nearly always without a power function.
    bool at_least(const Radiance& a, const Radiance& b, double threshold) const;

private:
    double encoded(float v) const;
    /// encoded() within one part in 10,000, from a table; negative where the table does not reach.
    float roughly_encoded(float v) const;

    bool is_srgb_ = false;
    double exponent_ = 1;
    bool raw_ = false;
    std::vector<float> table_;  ///< encoded values of floats whose last 17 bits are 0, from table_least on
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
    Sampler(const Integrator& integrator, const CameraRays& rays, RayCounters& counters)
        : integrator_(integrator), rays_(rays), counters_(counters) {}

    void sample(std::span<const Vec2> positions, std::vector<Radiance>& out);

private:
    const Integrator& integrator_;
    const CameraRays& rays_;
    RayCounters& counters_;
    std::vector<CameraRay> batch_;
};

/// Renders one block; `out` gets its pixels row by row. The result depends on the block's place, as in the
/// reference, but not on threads or batches.
void render_block(Sampler& sampler, const PixelBlock& block, const AntialiasOptions& options,
                  const SampleDistance& distance, std::span<Radiance> out);

}  // namespace rb
