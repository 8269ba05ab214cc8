#include "compile/geometry_parts.h"

namespace rb {

World compile(const Scene& scene, const CompileOptions& options, Diagnostics& diagnostics) {
    World world;
    world.settings = scene.settings;
    world.effective_version = scene.effective_version;
    world.background = scene.background;
    world.sky_sphere = scene.sky_sphere;
    world.fogs = scene.fogs;
    world.camera = scene.camera;
    Flattener flattener(world, scene.default_texture, diagnostics);
    for (const ObjectPtr& object : scene.objects) flattener.add(object);
    world.geometry = make_geometry(flattener.finish(), options.brute_force);
    return world;
}

}  // namespace rb
