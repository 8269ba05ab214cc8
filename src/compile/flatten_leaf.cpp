#include "compile/flatten_parts.h"

#include <algorithm>
#include <utility>

namespace rb {

void Flattener::add_leaf(const Object& object, const Inherited& own, uint32_t node) {
    const SolidNode& solid = flat_.solids.nodes[node];
    const PlacedShape& placed = flat_.solids.shapes[solid.placed];
    Leaf leaf;
    leaf.shape = placed.shape;
    leaf.object_from_world = placed.object_from_world;
    leaf.in_world_space = placed.in_world_space;
    leaf.inverted = solid.inverted;
    leaf.solid = node;

    Surface surface = surface_of(object, own);
    bool opaque = surface_table_.opaque(surface);
    const auto textures = leaf.shape->textures();
    for (const TexturePtr& texture : textures) opaque = opaque && surface_table_.opaque(texture);
    if (own.hollow) draft_->slots[own.slot].hollow = true;
    surface.interior = interior_index(own, opaque);
    if (!textures.empty()) {
        // Components that bring textures show them from within, too (spec: geometry 12.4).
        if (leaf.shape->keyword() == "blob") surface.interior_texture.reset();
        // The run of surfaces must be contiguous, so these are not shared with others.
        leaf.first_texture_surface = static_cast<uint32_t>(world_.surfaces.size());
        for (const TexturePtr& texture : textures) {
            Surface part = surface;
            part.texture.layers = texture;
            part.texture.world_from_texture = surface.uv_mapping ? Transform{} : own.world_from_parent;
            part.texture_stays = surface.uv_mapping;
            world_.surfaces.push_back(std::move(part));
        }
    }
    leaf.surface = surface_table_.add(std::move(surface));

    leaf.mask = seen_by_trace;
    if (!own.no_image) leaf.mask |= seen_by_image;
    if (!own.no_reflection) leaf.mask |= seen_by_reflection;
    if (!own.no_radiosity) leaf.mask |= seen_by_gather;
    if (!own.no_radiosity && !own.no_reflection) leaf.mask |= seen_by_gather_mirrored;
    if (!own.no_radiosity && !own.no_image) leaf.mask |= seen_by_gather_refracted;
    if (!own.no_shadow) leaf.mask |= opaque ? blocks_light : filters_light;
    if (!own.no_shadow && !own.no_image) leaf.mask |= seen_by_photons;
    if (!own.no_shadow && !own.no_reflection) leaf.mask |= seen_by_mirrored_photons;
    if (own.cutaway && !own.texture && textures.empty()) {
        draft_->cuts.push_back(static_cast<uint32_t>(flat_.leaves.size()));
    }
    flat_.leaves.push_back(std::move(leaf));
}

/// Finds what a leaf without texture may show, once its solid is complete.
void Flattener::cut_away(uint32_t index) {
    Leaf& leaf = flat_.leaves[index];
    Cutaway cut;
    cut.root = deciding_root(flat_.solids, leaf.solid);
    cut.nothing = leaf.surface;
    bool opaque = true;
    const size_t first = draft_->top_ends.empty() ? 0 : draft_->top_ends.back();
    for (size_t i = first; i < flat_.leaves.size(); ++i) {
        const Leaf& other = flat_.leaves[i];
        if (std::ranges::binary_search(draft_->cuts, i)) continue;
        if (!is_looked_at(flat_.solids, other.solid, cut.root)) continue;
        Surface shown = world_.surfaces[leaf.surface];
        shown.texture = world_.surfaces[other.surface].texture;
        shown.uv_mapping = world_.surfaces[other.surface].uv_mapping;
        opaque = opaque && surface_table_.opaque(shown);
        cut.worn.emplace_back(other.solid, surface_table_.add(std::move(shown)));
    }
    std::ranges::sort(cut.worn);
    if (!opaque && (leaf.mask & blocks_light)) leaf.mask ^= blocks_light | filters_light;
    leaf.cutaway = static_cast<uint32_t>(flat_.cutaways.size());
    flat_.cutaways.push_back(std::move(cut));
}

Surface Flattener::surface_of(const Object& object, const Inherited& own) {
    Surface surface;
    if (own.texture) {
        surface.texture = *own.texture;
    } else if (own.cutaway) {
        // Where nothing that wears a texture contains the cut.
        static const TexturePtr black = plain_texture();
        surface.texture.layers = black;
    } else {
        surface.texture.layers = own.fallback_texture;
    }
    surface.interior_texture = own.interior_texture;
    surface.texture_stays = own.texture_stays;
    surface.interior_texture_stays = own.interior_texture_stays;
    surface.uv_mapping = own.uv_mapping;
    surface.double_illuminate = own.double_illuminate;
    surface.lights = own.lights;
    if (world_.settings.photons) {
        surface.photons = {own.photon_target, own.photons.ways, own.photons.collect,
                           own.photons.pass_through};
    }
    surface.where = object.where;
    return surface;
}

uint32_t Flattener::add_interior(const InteriorPtr& interior, bool hollow) {
    world_.interiors.push_back({interior ? *interior : Interior{}, hollow});
    return static_cast<uint32_t>(world_.interiors.size() - 1);
}

/// Of opaque things: no ray enters through them, so identity does not matter and looks can be shared.
uint32_t Flattener::shared_interior(bool hollow) {
    uint32_t& shared = draft_->shared_interior[hollow ? 1 : 0];
    if (shared == no_surface) shared = add_interior(nullptr, hollow);
    return shared;
}

uint32_t Flattener::own_interior(uint32_t index) {
    InteriorSlot& slot = draft_->slots[index];
    const bool is_shared = slot.index != no_surface && (slot.index == draft_->shared_interior[0] ||
                                                        slot.index == draft_->shared_interior[1]);
    if (slot.index == no_surface || is_shared) slot.index = add_interior(slot.interior, slot.hollow);
    return slot.index;
}

uint32_t Flattener::interior_index(const Inherited& own, bool opaque) {
    InteriorSlot& slot = draft_->slots[own.slot];
    if (!slot.interior && opaque) {
        const uint32_t shared = shared_interior(own.hollow);
        if (slot.index == no_surface) slot.index = shared;
        return shared;
    }
    const uint32_t index = own_interior(own.slot);
    if (own.hollow) world_.interiors[index].hollow = true;
    return index;
}

}  // namespace rb
