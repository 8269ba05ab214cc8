#include "shade/shading_program.h"

#include <algorithm>
#include <map>

namespace rb {

ShadingProgram::ShadingProgram(const World& world_to_shade, const ShadingOptions& chosen)
    : world(world_to_shade),
      geometry(*world_to_shade.geometry),
      options(chosen),
      patterns{world_to_shade.settings.noise_generator, world_to_shade.settings.number_of_waves},
      before_37(world_to_shade.effective_version < 370),
      sky(world_to_shade.sky_sphere, world_to_shade.background, patterns, before_37),
      fog(chosen.quality >= 9 ? world_to_shade.fogs : std::vector<Fog>{}, patterns.noise_generator) {
    options.quality = std::clamp(options.quality, 0, 9);
    add_surfaces();
    add_lights();
    for (const SurfaceMask kind : {blocks_light, filters_light}) {
        if (geometry.has(kind)) shadow_mask |= kind;
    }
    if (tracks_interiors) camera_interiors = geometry.interiors_at(world.camera.location);
}

void ShadingProgram::add_surfaces() {
    const TextureSettings settings{patterns, world.settings.ambient_light, options.quality};
    tracks_interiors = !fog.empty();
    // Copies of a declared object share their layers, and those without a pattern their program too.
    std::map<std::pair<const TextureLayers*, std::array<double, 12>>, uint32_t> known;
    const auto compiled = [&](const WornTexture& worn) {
        std::array<double, 12> place{};
        for (size_t i = 0; i < 12; ++i) {
            place[i] = worn.world_from_texture.forward.row[i / 3][static_cast<int>(i % 3)];
        }
        const auto [entry, is_new] = known.try_emplace({worn.layers.get(), place}, 0u);
        if (is_new) {
            entry->second = static_cast<uint32_t>(textures.size());
            textures.emplace_back(*transformed(worn.layers, worn.world_from_texture), settings);
        }
        const TextureProgram& texture = textures[entry->second];
        tracks_interiors = tracks_interiors || texture.passes_light || texture.has_fresnel;
        return entry->second;
    };
    surfaces.reserve(world.surfaces.size());
    for (const Surface& surface : world.surfaces) {
        SurfaceProgram program;
        program.texture = compiled(surface.texture);
        program.interior_texture =
            surface.interior_texture ? compiled(*surface.interior_texture) : program.texture;
        program.interior = surface.interior;
        program.uv_mapping = surface.uv_mapping;
        program.double_illuminate = surface.double_illuminate;
        surfaces.push_back(program);
    }
}

void ShadingProgram::add_lights() {
    for (const Light& light : world.lights) {
        LightProgram program(light);
        if (options.quality < 5 && light.is_area) {
            Light point = light;
            point.is_area = false;
            program = LightProgram(point);
        }
        first_sample.push_back(sample_count);
        sample_count += program.sample_count();
        lights.push_back(std::move(program));
    }
}

}  // namespace rb
