#pragma once
#include "shade/area_sampler.h"
#include "shade/stream_state.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace rb {

/// Distance attenuation of an interior (manual 3.4.7.5).
Rgb interior_fade(const Interior& interior, double distance);

/// Follows shadow rays from lit points to lights.
class ShadowTracer {
public:
    ShadowTracer(const ShadingProgram& program, StreamState& state) : program_(program), state_(state) {}

    /// What of `color` arrives at a hit from `light`, at its centre or over its area. Adaptive area sampling
    /// compares colours, so they come with their attenuation.
    /// `candidates`: what may be between, or null.
    Rgb arriving(size_t light, const HitPoint& hit, const LightVector& to_center, const Rgb& color,
                 const Candidates* candidates);

    /// True if nothing that may be between takes any of a light's light.
    bool passes_all(const LightProgram& light, const Candidates* candidates) const;

    /// True if no shadow ray from a hit to the light can meet the hit's own surface.
    bool leaves_for_good(const LightProgram& light, const HitPoint& hit, const LightVector& to_center) const;

    // What is left of light that comes along a ray, from inside of `inside`:

    /// of a surface that it crosses, the fading in the interior that it leaves there included;
    Rgb filter_of(const Hit& hit, const Ray& ray, std::span<const uint32_t> inside);
    /// by that fading alone;
    Rgb fade_of(const Hit& hit, std::span<const uint32_t> inside) const {
        const uint32_t own = program_.surface_of(hit).interior;
        const Interior& interior = program_.world.interiors[own].interior;
        const bool fades = interior.fade_power > 0.0 && std::abs(interior.fade_distance) > 1e-10;
        if (!fades || std::ranges::find(inside, own) == inside.end()) return Rgb(1.0f);
        return interior_fade(interior, hit.t);
    }
    /// by the media of interiors.
    Rgb media_filter(const Ray& ray, double length, std::span<const uint32_t> inside, uint64_t seed);

private:
    struct Grid;
    struct GridCorner;
    struct Pattern;
    bool is_dimmed(const Light& light) const;
    const Candidates* narrowed(const LightProgram& light, const HitPoint& hit, const LightVector& to_center,
                               const Candidates* wider, Candidates& memory) const;
    Rgb along(const LightProgram& light, const HitPoint& hit, RayQuery& query, double distance, Rgb color,
              const Candidates* candidates, uint32_t& blocker);
    Rgb through_air(const LightProgram& light, const HitPoint& from, const Ray& ray, double distance,
                    const Rgb& color);
    Rgb filtered(const LightProgram& light, const HitPoint& from, RayQuery query, double distance, Rgb color,
                 const Candidates* candidates);
    bool is_left_to_photons(const Light& light, const Hit& blocker) const;
    bool are_hollow(std::span<const uint32_t> interiors) const;
    Rgb air_filter(const Ray& ray, double length, std::span<const uint32_t> inside, bool ends_on_surface,
                   uint64_t seed);
    Rgb surface_filter(const SurfaceProgram& surface, const Hit& hit, const Vec3& direction);
    Rgb over_pattern(size_t light, const HitPoint& hit, const AreaSampler& sampler, const Rgb& color,
                     const Candidates* candidates);
    bool corners_agree(size_t light, const HitPoint& hit, const AreaSampler& sampler, const Rgb& color,
                       const Candidates* candidates, const Rgb& least, const Rgb& most);
    bool is_in_umbra(const LightProgram& light, const HitPoint& hit, const AreaSampler& sampler,
                     std::span<const uint32_t> blockers, const Candidates* candidates);
    Rgb over_area(size_t light, const HitPoint& hit, const LightVector& to_center, const Rgb& color,
                  const Candidates* candidates);
    void look_at_corners(Grid& grid, const std::array<GridCorner, 4>& corners);
    Rgb grid_cell(Grid& grid, int u1, int v1, int u2, int v2, int level);

    const ShadingProgram& program_;
    StreamState& state_;
    MediaMix mix_;
    std::vector<SurfaceWeight> worn_;  ///< of the hit at hand
};

/// Light factor that a texture lets through at one place: the product of its layers (manual 3.4.7.8).
/// `transform` is the object's, for normals; `caustics`: exponent of fake caustics, 0 for none.
Rgb texture_filter(const TextureProgram& texture, const PatternSamples& place,
                   std::span<const Warp> transform, const Vec3& normal, const Vec3& light_direction,
                   double caustics);

}  // namespace rb
