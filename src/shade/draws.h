#pragma once
#include <cstdint>

namespace rb {

/// What the random numbers along a ray are drawn for: mixed(seed of the ray, one of these). Those with a list
/// (bands, lights, ...) count on from their value. The low numbers from 0 on are those of
/// StreamState::light_seed(), which mixes once more.
enum Draw : uint64_t {
    draw_transmitted_ray = 1,
    draw_reflected_ray = 2,
    draw_passing_ray = 3,  ///< straight through a translucent body
    draw_bands = 100,
    draw_crand = 0x10000,     ///< by light
    draw_rainbows = 0x20000,  ///< by rainbow
    draw_media_of_interiors = 0x30000,
    draw_media_of_air,
    draw_indirect_light,  ///< of the near and of the far side
    draw_body_walls = draw_indirect_light + 2,
    draw_body_depths,
    draw_photons_left_in_media,
};

}  // namespace rb
