#pragma once
#include "compile/geometry.h"
#include "shade/fog.h"
#include "shade/integrator.h"
#include "shade/light_program.h"
#include "shade/media_program.h"
#include "shade/photon_light.h"
#include "shade/rainbow.h"
#include "shade/sky.h"
#include "shade/texture_program.h"

namespace rb {

/// A texture at its place: objects that differ only in where they stand share the texture.
struct Look {
    uint32_t texture = 0;         ///< index into ShadingProgram::textures
    std::vector<Warp> transform;  ///< the object's, as a chain of at most one
    uint32_t lights = 0;          ///< index into ShadingProgram::light_lists
};

/// What a surface of the world wears, compiled.
struct SurfaceProgram {
    uint32_t look = 0;           ///< index into ShadingProgram::looks
    uint32_t interior_look = 0;  ///< the same as `look` if it has none of its own
    uint32_t interior = 0;
    bool uv_mapping = false;
    bool double_illuminate = false;
    bool needs_uv = false;  ///< of either look
    PhotonRole photons;
};

/// Whom a program serves: rays of the picture, or rays that gather indirect light. To those highlights are
/// invisible, area lights are points at their centres, the air is clear (but with `media on`), and the level
/// at which little weight is dropped is another one (shading spec 13.2).
enum class RayPurpose { picture, gather };

/// A world compiled for shading; immutable while rendering.
struct ShadingProgram {
    ShadingProgram(const World& world_to_shade, const ShadingOptions& chosen,
                   RayPurpose rays = RayPurpose::picture);

    /// radiosity{} is in force: it takes the place of ambient light from version 3.7 on.
    static bool has_indirect_light(const World& world, const ShadingOptions& options) {
        return world.settings.radiosity && options.indirect_light && options.quality >= 9;
    }

    const World& world;
    const Geometry& geometry;
    ShadingOptions options;
    RayPurpose purpose;
    float adc_bailout;
    bool has_air_effects;  ///< fog, rainbows and media act
    /// SurfaceMask bits of straight rays, refracted ones, and those that were reflected.
    std::array<RayMask, 3> ray_masks{seen_by_image, seen_by_image, seen_by_reflection};
    PatternSettings patterns;
    bool before_37 = false;  ///< the older rules for opacity and sky
    std::vector<TextureProgram> textures;
    std::vector<Look> looks;
    std::vector<SurfaceProgram> surfaces;
    std::vector<uint32_t> leaf_surfaces;  ///< index into `surfaces`; no_surface for meshes with several
    bool needs_samples = false;           ///< some texture asks for StreamState::samples
    std::vector<LightProgram> lights;
    /// Indices into `lights`: of the global ones, and of what else surfaces are lit by (list_of()).
    std::vector<std::vector<uint32_t>> light_lists;
    std::vector<uint32_t> first_sample;  ///< of each light among all samples of all lights
    uint32_t sample_count = 0;
    SkyProgram sky;
    FogProgram fog;
    RainbowProgram rainbow;
    MediaProgram media;
    std::shared_ptr<const PhotonLight> photons;  ///< null until there are any

    RayMask shadow_mask = 0;  ///< which kinds of leaves shadow rays can meet at all
    bool tracks_interiors = false;
    std::vector<uint32_t> camera_interiors;

    double ior_of(uint32_t interior) const {
        const double ior = world.interiors[interior].interior.ior;
        return ior == 0.0 ? 1.0 : ior;
    }
    const SurfaceProgram& surface_of(const Hit& hit) const {
        return surfaces[geometry.surface_of(hit.leaf, hit.crossing.member)];
    }

    bool shows_photons() const { return photons && photons->on_surfaces(); }

    /// The list of the lights that shine where a surface is.
    static uint32_t list_of(const LightChoice& lights) { return 2 * lights.group + (lights.global ? 0 : 1); }

    /// Something in the air changes light on its way outside of solids.
    bool has_air() const { return !fog.empty() || !rainbow.empty() || media.fills_air(); }

private:
    void add_surfaces();
    void add_lights();
};

}  // namespace rb
