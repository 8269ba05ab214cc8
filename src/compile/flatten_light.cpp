#include "compile/flatten_parts.h"
#include "compile/geometry_parts.h"

#include <algorithm>

namespace rb {

void Flattener::add_light(const Light& light, const Inherited& from) {
    WorldLight placed{
        from.world_from_parent.is_identity() ? light : transformed(light, from.world_from_parent),
        from.lights_here == 0, nullptr};
    if (placed.light.projected_through) placed.projected_through = shape_of(placed.light.projected_through);
    placed.light.projected_through = nullptr;
    const ObjectPtr looks_like = std::exchange(placed.light.looks_like, nullptr);
    if (!placed.is_global) {
        world_.light_groups[from.lights_here].push_back(static_cast<uint32_t>(world_.lights.size()));
    }
    world_.lights.push_back(std::move(placed));
    ++draft_->top_objects;
    if (!looks_like) return;
    Inherited looks;
    looks.fallback_texture = from.fallback_texture;
    looks.no_shadow = true;
    // Measured: whatever the group says, the global lights shine on it.
    looks.lights.group = from.lights.group;
    add_top(*looks_like, looks);
}

/// Measured (spec: shading 8): the outermost group decides about the global lights; a group without lights
/// of its own takes those around it, and one of nothing but lights gives them to nobody.
void Flattener::enter_light_group(const Csg& group, Inherited& own) {
    if (!own.in_light_group) own.lights.global = group.global_lights;
    own.in_light_group = true;
    const auto lights = std::ranges::count_if(
        *group.children, [](const ObjectPtr& child) { return as<LightPtr>(*child) != nullptr; });
    if (lights == 0) return;
    own.lights_here = static_cast<uint32_t>(world_.light_groups.size());
    world_.light_groups.emplace_back();
    if (static_cast<size_t>(lights) < group.children->size()) own.lights.group = own.lights_here;
}

/// A compound that stays whole is one target, whatever its children say.
void Flattener::become_target(Inherited& own) {
    if (!world_.settings.photons || own.photons.target == 0.0f || own.photon_target != no_target) return;
    own.photon_target = static_cast<uint32_t>(world_.photon_targets.size());
    world_.photon_targets.push_back(
        {{}, own.photons.target, own.photons.ways, own.photons.collect, own.lights.global});
}

/// The surfaces of an object that are not part of the scene. Lights in it are lost.
std::shared_ptr<const Geometry> Flattener::shape_of(const ObjectPtr& object) {
    World world;
    Flattener inner(world, default_texture_, diagnostics_);
    inner.add_whole(object);
    return make_geometry(inner.finish(), store_ && store_->brute_force());
}

}  // namespace rb
