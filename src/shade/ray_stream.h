#pragma once
#include "shade/media_tracer.h"

namespace rb {

/// Follows one batch of camera rays, wave by wave, until nothing is left to follow.
class RayStream {
public:
    RayStream(const ShadingProgram& program, StreamState& state)
        : program_(program), state_(state), media_(program, state) {}

    void trace(std::span<const CameraRay> rays, std::span<Radiance> out);

protected:
    void add_point(uint32_t ray_index, const Hit& hit, const SurfaceProgram& surface, const Rgb& weight,
                   float alpha);
    void shade_hits();

    const ShadingProgram& program_;
    StreamState& state_;

private:
    void start(std::span<const CameraRay> rays);
    void run_wave();
    void intersect();
    const Candidates* candidates(std::span<const PathRay> rays);
    void add_hit(uint32_t ray_index, const Hit& hit);
    std::span<const uint32_t> group_hits(Scratch::Scope& memory);
    void shade_sky(std::span<const uint32_t> misses);
    void fill_samples();
    void pass(const PathRay& ray, const AirEffect& effect, Rgb& weight, float& alpha);
    std::span<const uint32_t> lights_on(const Hit& hit) const;
    void pass_air(uint32_t ray_index, double length, std::span<const uint32_t> lights, Rgb& weight,
                  float& alpha);
    void pass_media(uint32_t ray_index, double length, std::span<const uint32_t> lights, Rgb& weight,
                    float& alpha);
    void finish(std::span<const CameraRay> rays, std::span<Radiance> out);

    MediaTracer media_;
    Candidates candidates_;            ///< of the rays at hand
    std::vector<SurfaceWeight> worn_;  ///< of the hit at hand
};

}  // namespace rb
