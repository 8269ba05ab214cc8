#include "shade/needs.h"

#include "shade/shading_program.h"

#include <algorithm>

namespace rb {

Needs needs_of(const ShadingProgram& program) {
    Needs needs;
    needs.textures = program.textures.size();
    needs.surfaces = program.surfaces.size();
    needs.with_coordinates = static_cast<size_t>(std::ranges::count_if(
        program.surfaces, [](const SurfaceProgram& surface) { return surface.needs_uv; }));
    needs.interiors = program.tracks_interiors;
    needs.opaque_shadows = (program.shadow_mask & blocks_light) != 0;
    needs.filtered_shadows = (program.shadow_mask & filters_light) != 0;
    needs.air = program.has_air();
    needs.lights = program.lights.size();
    for (const LightProgram& light : program.lights) {
        needs.area_lights += light.light().is_area ? 1 : 0;
        needs.shadowless_lights += light.is_shadowless() ? 1 : 0;
    }
    return needs;
}

}  // namespace rb
