#include "compile/geometry_parts.h"
#include "compile/tessellated.h"

namespace rb {

World compile(const Scene& scene, const CompileOptions& options, Diagnostics& diagnostics) {
    return compile(Scene(scene), options, diagnostics);
}

World compile(Scene&& scene, const CompileOptions& options, Diagnostics& diagnostics) {
    World world;
    world.settings = scene.settings;
    world.effective_version = scene.effective_version;
    world.background = scene.background;
    world.sky_sphere = scene.sky_sphere;
    world.fogs = scene.fogs;
    world.rainbows = scene.rainbows;
    world.atmosphere = scene.atmosphere;
    world.camera = scene.camera;
    Flattener flattener(world, scene.default_texture, diagnostics);
    const bool tessellates =
        options.geometry == GeometryMode::tessellate || options.geometry == GeometryMode::refine;
    CompoundStore compounds(scene.objects, tessellates ? InstanceMode::never : options.instances,
                            options.brute_force);
    flattener.share(compounds);
    flattener.reserve(scene.objects);
    for (ObjectPtr& object : scene.objects) {
        flattener.add(object);
        object = nullptr;
    }
    scene.objects = {};
    FlatGeometry flat = flattener.finish();
    // `automatic` is exact: every shape so far has a closed form that is faster than its facets.
    if (tessellates) tessellate_leaves(flat, scene.camera, options);
    world.geometry = make_geometry(std::move(flat), options.brute_force);
    return world;
}

}  // namespace rb
