#include "compile/compound.h"
#include "compile/compound_store.h"
#include "compile/flatten_parts.h"
#include "compile/geometry_parts.h"

#include <algorithm>

namespace rb {

bool Flattener::add_instance(const Object& object, const Inherited& from) {
    if (!store_ || !store_->shares(object) || from.photons != ObjectPhotons{}) return false;
    const Inherited own = inherit(object, from);
    CompoundStore::Entry& entry = store_->entry(object, needs_of(own, object));
    if (!entry.known) {
        entry.compound = make_compound(object, own);
        entry.known = true;
    }
    if (!entry.compound) return false;
    const Compound& compound = *entry.compound;

    SolidNode node;
    node.placed = static_cast<uint32_t>(flat_.solids.shapes.size());
    flat_.solids.shapes.push_back({entry.compound, own.world_from_parent.backward, false});
    Leaf leaf;
    leaf.shape = entry.compound;
    leaf.object_from_world = flat_.solids.shapes.back().object_from_world;
    leaf.mask = compound.mask();
    leaf.solid = static_cast<uint32_t>(flat_.solids.nodes.size());
    leaf.instance = static_cast<uint32_t>(flat_.instances.size());
    flat_.solids.nodes.push_back(node);
    flat_.solids.set_regions(leaf.solid);
    flat_.tops.push_back({leaf.solid, own.slot, leaf.instance, {}});
    flat_.instances.push_back({entry.compound, look_of(entry, own), stretch(own.world_from_parent.forward)});
    flat_.leaves.push_back(std::move(leaf));
    draft_->top_ends.push_back(static_cast<uint32_t>(flat_.leaves.size()));
    draft_->top_objects += compound.looks().top_objects;
    return true;
}

/// What of a copy decides which crossings count and which rays see them.
uint32_t Flattener::needs_of(const Inherited& own, const Object& object) {
    const auto* csg = as<Csg>(object);
    const auto& worn = own.texture ? own.texture->layers : own.fallback_texture;
    uint32_t needs = static_cast<uint32_t>(csg->kind);
    for (const bool bit : {csg->split_union, own.uv_mapping, own.hollow, own.no_shadow, own.no_image,
                           own.no_reflection, own.no_radiosity, own.double_illuminate,
                           surface_table_.opaque(worn), own.interior_texture.has_value(),
                           own.interior_texture && surface_table_.opaque(own.interior_texture->layers),
                           draft_->slots[own.slot].interior != nullptr}) {
        needs = 2 * needs + (bit ? 1u : 0u);
    }
    return needs;
}

/// Null if that cannot be: its surfaces or its inside have no end.
CompoundPtr Flattener::make_compound(const Object& object, const Inherited& own) {
    World world;
    Flattener inner(world, default_texture_, diagnostics_);
    inner.share(*store_);
    static const InteriorPtr interior_of_copy = std::make_shared<Interior>();
    inner.draft_->slots.push_back(
        {draft_->slots[own.slot].interior ? interior_of_copy : nullptr, false, no_surface});
    Inherited from = own;
    from.world_from_parent = {};
    from.slot = 0;
    from.texture.reset();
    from.texture_stays = from.interior_texture_stays = false;
    from.fallback_texture = Compound::texture_of_copy(
        surface_table_.opaque(own.texture ? own.texture->layers : own.fallback_texture));
    if (own.interior_texture) {
        const bool opaque = surface_table_.opaque(own.interior_texture->layers);
        from.interior_texture = WornTexture{Compound::texture_of_copy(opaque), {}};
    }
    Object bare;
    bare.where = object.where;
    bare.geometry = object.geometry;
    inner.add_flattened(bare, from);
    FlatGeometry flat = inner.finish();
    const bool fits =
        std::ranges::all_of(flat.boxes, [](const Bounds& box) { return box.is_empty() || fits_tree(box); });
    // What is inside of a half-space (a disc's) ends at a box along the world's axes, other in each copy.
    const bool ends = std::ranges::all_of(flat.tops, [&](const TopSolid& top) {
        const Bounds& region = flat.solids.nodes[top.node].region;
        return region.is_empty() || region.is_finite();
    });
    if (!fits || !ends) return nullptr;

    CompoundLooks looks;
    looks.surfaces = std::move(world.surfaces);
    looks.interiors = std::move(world.interiors);
    looks.shared_interiors = inner.draft_->shared_interior;
    looks.interior_of_copy = inner.draft_->slots.front().index;
    looks.top_objects = inner.draft_->top_objects;
    for (const Surface& s : looks.surfaces) {
        const auto shows_place = [&](const TexturePtr& texture) {
            return !Compound::is_texture_of_copy(texture) && !surface_table_.same_everywhere(texture);
        };
        if (shows_place(s.texture.layers) || (s.interior_texture && shows_place(s.interior_texture->layers)))
            looks.same_in_all_copies = false;
    }
    for (uint32_t i = 0; i < looks.interiors.size(); ++i) {
        if (!looks.is_shared_interior(i)) looks.same_in_all_copies = false;
    }
    return std::make_shared<Compound>(make_geometry(std::move(flat), store_->brute_force()),
                                      std::move(looks));
}

/// Made anew for each copy only where copies differ.
std::shared_ptr<const InstanceLook> Flattener::look_of(CompoundStore::Entry& entry, const Inherited& own) {
    const CompoundLooks& looks = entry.compound->looks();
    const TexturePtr& texture = own.texture ? own.texture->layers : own.fallback_texture;
    const CompoundStore::Wear wear{list_, texture,
                                   own.interior_texture ? own.interior_texture->layers : nullptr, own.lights};
    const bool can_be_shared =
        looks.same_in_all_copies && surface_table_.same_everywhere(texture) &&
        (!own.interior_texture || surface_table_.same_everywhere(own.interior_texture->layers));
    if (can_be_shared && entry.last_wear == wear) return entry.last_look;

    InstanceLook look;
    look.interiors = interiors_of(looks, own);
    look.surfaces.reserve(looks.surfaces.size());
    for (const Surface& surface : looks.surfaces) {
        Surface worn = surface_of_copy(surface, own);
        worn.interior = look.interiors[surface.interior];
        look.surfaces.push_back(surface_table_.add(std::move(worn)));
    }
    auto made = std::make_shared<const InstanceLook>(std::move(look));
    if (can_be_shared) {
        entry.last_wear = wear;
        entry.last_look = made;
    }
    return made;
}

std::vector<uint32_t> Flattener::interiors_of(const CompoundLooks& looks, const Inherited& own) {
    std::vector<uint32_t> interiors;
    interiors.reserve(looks.interiors.size());
    for (uint32_t i = 0; i < looks.interiors.size(); ++i) {
        const WorldInterior& there = looks.interiors[i];
        if (looks.is_shared_interior(i)) {
            interiors.push_back(shared_interior(there.hollow));
        } else if (i == looks.interior_of_copy) {
            interiors.push_back(own_interior(own.slot));
            if (there.hollow) {
                draft_->slots[own.slot].hollow = true;
                world_.interiors[interiors.back()].hollow = true;
            }
        } else {
            world_.interiors.push_back(there);
            Interior& interior = world_.interiors.back().interior;
            interior.media = transformed(std::move(interior.media), own.world_from_parent);
            interiors.push_back(static_cast<uint32_t>(world_.interiors.size() - 1));
        }
    }
    return interiors;
}

/// A surface of a compound as it looks in a copy; its interior is left to the caller.
Surface Flattener::surface_of_copy(const Surface& surface, const Inherited& own) {
    Surface worn = surface;
    worn.lights = own.lights;
    if (Compound::is_texture_of_copy(worn.texture.layers)) {
        worn.texture = own.texture ? *own.texture : WornTexture{own.fallback_texture, {}};
        worn.texture_stays = own.texture_stays;
    } else if (!worn.texture_stays && !surface_table_.same_everywhere(worn.texture.layers)) {
        worn.texture.world_from_texture = then(worn.texture.world_from_texture, own.world_from_parent);
    }
    if (!worn.interior_texture) return worn;
    if (Compound::is_texture_of_copy(worn.interior_texture->layers)) {
        worn.interior_texture = own.interior_texture;
        worn.interior_texture_stays = own.interior_texture_stays;
    } else if (!worn.interior_texture_stays) {
        worn.interior_texture->world_from_texture =
            then(worn.interior_texture->world_from_texture, own.world_from_parent);
    }
    return worn;
}

}  // namespace rb
