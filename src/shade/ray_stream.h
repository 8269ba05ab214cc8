#pragma once
#include "shade/media_tracer.h"
#include "shade/surfel.h"

namespace rb {

/// A ray that leaves a surface to gather what comes from where it goes.
struct GatherRay {
    Ray ray;
    uint32_t leaf = no_leaf;
    uint32_t part = any_part;
    uint32_t member = 0;
    double error = 0;
    uint64_t seed = 0;
};
struct GatheredLight {
    Rgb rgb{0.0f};
    double distance = 0;  ///< to what the ray meets; infinite if it meets nothing
};

/// Follows one batch of rays, wave by wave, until nothing is left to follow.
class RayStream {
public:
    RayStream(const ShadingProgram& program, StreamState& state)
        : program_(program), state_(state), media_(program, state) {}

    void trace(std::span<const CameraRay> rays, std::span<Radiance> out);

    /// Rays from surfaces with `depth` - 1 diffuse surfaces between them and the eye, under the limits of
    /// shading spec 13.3. `surfels`: what need not be shaded again; or null.
    void gather(std::span<const GatherRay> rays, int depth, const SurfelUse* surfels,
                std::span<GatheredLight> out);

protected:
    void add_point(uint32_t ray_index, const Hit& hit, const SurfaceProgram& surface, const Rgb& weight,
                   float alpha);
    void shade_hits();

    const ShadingProgram& program_;
    StreamState& state_;

private:
    void clear(size_t slots);
    std::vector<uint32_t> solids_around(std::span<const CameraRay> rays) const;
    void start(std::span<const CameraRay> rays);
    void start(std::span<const GatherRay> rays, int depth);
    bool is_known(uint32_t ray_index, const Hit& hit, uint32_t look, const Vec3& normal);
    void run_wave();
    RayMask mask_of(const PathRay& ray) const;
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
    void add_powers();

    MediaTracer media_;
    Candidates candidates_;            ///< of the rays at hand
    std::vector<SurfaceWeight> worn_;  ///< of the hit at hand

    // Of the first wave of rays that gather; empty and null after it.
    std::span<GatheredLight> gathered_;
    const SurfelUse* surfels_ = nullptr;
    std::vector<uint32_t> fresh_rays_;  ///< of the surfels that are new
};

}  // namespace rb
