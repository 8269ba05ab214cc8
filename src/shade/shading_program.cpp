#include "shade/shading_program.h"

#include <algorithm>
#include <unordered_map>

namespace rb {

namespace {

bool air_acts(const World& world, const ShadingOptions& options, RayPurpose purpose) {
    if (options.quality < 9) return false;
    return purpose == RayPurpose::picture || (world.settings.radiosity && world.settings.radiosity->media);
}

}  // namespace

ShadingProgram::ShadingProgram(const World& world_to_shade, const ShadingOptions& chosen, RayPurpose rays)
    : world(world_to_shade),
      geometry(*world_to_shade.geometry),
      options(chosen),
      purpose(rays),
      adc_bailout(world_to_shade.settings.adc_bailout),
      has_air_effects(air_acts(world_to_shade, chosen, rays)),
      patterns{world_to_shade.settings.noise_generator, world_to_shade.settings.number_of_waves},
      before_37(world_to_shade.effective_version < 370),
      sky(world_to_shade.sky_sphere, world_to_shade.background, patterns, before_37,
          chosen.alpha_output && rays == RayPurpose::picture),
      fog(has_air_effects ? world_to_shade.fogs : std::vector<Fog>{}, patterns.noise_generator),
      rainbow(has_air_effects ? world_to_shade.rainbows : std::vector<Rainbow>{}),
      media(world_to_shade, patterns, has_air_effects) {
    options.quality = std::clamp(options.quality, 0, 9);
    if (purpose == RayPurpose::gather) {
        if (world.settings.radiosity) adc_bailout = world.settings.radiosity->adc_bailout;
        ray_masks = {seen_by_gather, seen_by_gather_refracted, seen_by_gather_mirrored};
        options.alpha_output = false;
    }
    add_surfaces();
    add_lights();
    for (const SurfaceMask kind : {blocks_light, filters_light}) {
        if (geometry.has(kind) || !options.skip_unneeded) shadow_mask |= kind;
    }
    if (tracks_interiors) camera_interiors = geometry.interiors_at(world.camera.location);
}

void ShadingProgram::add_surfaces() {
    const bool replaces_ambient = has_indirect_light(world, options) && !before_37;
    const Rgb ambient = replaces_ambient ? Rgb(0.0f) : world.settings.ambient_light;
    TextureCompiler compiler(
        {patterns, ambient, options.quality, purpose == RayPurpose::picture,
         purpose == RayPurpose::picture && options.quality >= 9 && world.settings.subsurface.has_value()});
    tracks_interiors = has_air() || media.fills_interiors() || !options.skip_unneeded;
    needs_samples = !options.skip_unneeded;
    std::unordered_map<const TextureLayers*, uint32_t> known;
    const auto compiled = [&](const WornTexture& worn, uint32_t lit_by) {
        const auto [entry, is_new] =
            known.try_emplace(worn.layers.get(), static_cast<uint32_t>(textures.size()));
        if (is_new) {
            textures.emplace_back(*worn.layers, compiler);
            const TextureProgram& texture = textures.back();
            tracks_interiors = tracks_interiors || texture.passes_light || texture.has_fresnel;
        }
        Look look{entry->second, {}, lit_by};
        if (!worn.world_from_texture.is_identity()) look.transform.emplace_back(worn.world_from_texture);
        const bool same_as_last = !looks.empty() && looks.back().texture == look.texture &&
                                  looks.back().lights == look.lights && look.transform.empty() &&
                                  looks.back().transform.empty();
        if (!same_as_last) looks.push_back(std::move(look));
        return static_cast<uint32_t>(looks.size() - 1);
    };
    surfaces.reserve(world.surfaces.size());
    for (const Surface& surface : world.surfaces) {
        SurfaceProgram program;
        const uint32_t lit_by = list_of(surface.lights);
        program.look = compiled(surface.texture, lit_by);
        program.interior_look =
            surface.interior_texture ? compiled(*surface.interior_texture, lit_by) : program.look;
        program.interior = surface.interior;
        program.photons = surface.photons;
        program.uv_mapping = surface.uv_mapping;
        program.double_illuminate = surface.double_illuminate;
        const auto asks = [&](uint32_t look) {
            return textures[looks[look].texture].surface_need != SurfaceNeed::none;
        };
        const bool asked = asks(program.look) || asks(program.interior_look);
        program.needs_uv = surface.uv_mapping || asked || !options.skip_unneeded;
        needs_samples = needs_samples || asked;
        surfaces.push_back(program);
    }
    leaf_surfaces.reserve(geometry.leaves().size());
    for (const Leaf& leaf : geometry.leaves()) {
        leaf_surfaces.push_back(leaf.has_one_surface() ? leaf.surface : no_surface);
    }
}

void ShadingProgram::add_lights() {
    std::vector<uint32_t> global;
    for (const WorldLight& placed : world.lights) {
        Light light = placed.light;
        if (options.quality < 5 || purpose == RayPurpose::gather) light.is_area = false;
        LightProgram program(light, placed.projected_through.get(), options.area_lights);
        if (placed.is_global) global.push_back(static_cast<uint32_t>(lights.size()));
        first_sample.push_back(sample_count);
        sample_count += program.sample_count();
        lights.push_back(std::move(program));
    }
    for (const auto& group : world.light_groups) {
        light_lists.push_back(global);
        light_lists.back().insert(light_lists.back().end(), group.begin(), group.end());
        light_lists.push_back(group);
    }
}

}  // namespace rb
