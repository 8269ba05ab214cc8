#pragma once
#include <cstddef>

namespace rb {

struct ShadingProgram;

/// What a scene's surfaces, lights and air ask of shading; the rest is left out (`--explain`, `--no-skip`).
struct Needs {
    size_t textures = 0;  ///< different ones: what several surfaces wear alike is compiled once
    size_t surfaces = 0;
    size_t with_coordinates = 0;    ///< surfaces whose u, v or neighbourhood some pattern looks at
    bool interiors = false;         ///< which solids a ray is in
    bool opaque_shadows = false;    ///< something stops light
    bool filtered_shadows = false;  ///< something lets light through, changed
    bool air = false;               ///< fog, rainbows or media outside of solids
    size_t area_lights = 0;
    size_t shadowless_lights = 0;
    size_t lights = 0;
};

Needs needs_of(const ShadingProgram& program);

}  // namespace rb
