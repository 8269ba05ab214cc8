#pragma once
#include "compile/flatten.h"

namespace rb {

/// An interior on its way into the world: made only when a surface needs an identity of its own.
struct InteriorSlot {
    InteriorPtr interior;
    bool hollow = false;
    uint32_t index = no_surface;
};

template <class T>
const T* as(const Object& object) {
    return std::get_if<T>(&object.geometry);
}

/// True for a union whose children become top-level objects of their own (spec: geometry 5.5).
inline bool splits(const Object& object) {
    const auto* csg = as<Csg>(object);
    return csg && csg->kind == CsgKind::union_ && csg->split_union && !object.inverse &&
           object.clipped_by.empty() && object.bounded_by.empty();
}

/// What a child receives from above (spec: geometry 3.3); everything is in world space.
struct Flattener::Inherited {
    Transform world_from_parent;
    std::optional<WornTexture> texture;
    bool uv_mapping = false;
    std::optional<WornTexture> interior_texture;
    bool texture_stays = false;  ///< it does not move with copies (Surface::texture_stays)
    bool interior_texture_stays = false;
    bool cutaway = false;  ///< leaves without texture show what contains them
    TexturePtr fallback_texture;
    LightChoice lights;
    bool in_light_group = false;
    uint32_t lights_here = 0;  ///< the group that lights standing here belong to; 0: they are global
    uint32_t slot = no_surface;
    bool hollow = false;
    bool no_shadow = false;
    bool no_image = false;
    bool no_reflection = false;
    bool no_radiosity = false;
    bool double_illuminate = false;
    ObjectPhotons photons;
    uint32_t photon_target = no_target;  ///< index into World::photon_targets
    bool top = true;                     ///< not inside a compound that stays whole
    bool flags_fixed = false;  ///< inside an intersection: children's own visibility flags do nothing
    bool image_fixed = false;  ///< inside a union that stays whole: children's no_image does nothing
    bool surfaces = true;      ///< false for clips and bounds: they only answer inside tests
};

struct Flattener::Draft {
    std::vector<InteriorSlot> slots;
    /// Of opaque things without interior; by hollow.
    std::array<uint32_t, 2> shared_interior{no_surface, no_surface};
    std::vector<uint32_t> top_ends;  ///< behind the last leaf of each top object
    size_t top_objects = 0;
    std::vector<uint32_t> cuts;  ///< leaves of the present solid that show what contains them
};

}  // namespace rb
