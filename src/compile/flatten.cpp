#include "compile/flatten_parts.h"
#include "compile/leaf_order.h"

#include <algorithm>
#include <utility>

namespace rb {

namespace {

/// How many records a scene's objects will need, clips and bounds left out.
struct Counts {
    size_t shapes = 0;
    size_t compounds = 0;  ///< that stay whole
    size_t tops = 0;
    size_t instances = 0;
};

void count(const Object& object, bool is_top, const CompoundStore* store, Counts& counts) {
    const auto* csg = as<Csg>(object);
    const bool is_shared = is_top && store && store->shares(object);
    const bool is_split = is_top && !is_shared && splits(object);
    if (!csg && !as<ShapePtr>(object)) return;
    if (is_top && !is_split) ++counts.tops;
    if (!csg || is_shared) {
        if (is_shared) ++counts.instances;
        ++counts.shapes;
        return;
    }
    if (!is_split) ++counts.compounds;
    for (const ObjectPtr& child : *csg->children) count(*child, is_split, store, counts);
}

SolidNode::Kind node_kind(CsgKind kind, bool invert) {
    switch (kind) {
        case CsgKind::union_:
            return invert ? SolidNode::Kind::intersection : SolidNode::Kind::union_;
        case CsgKind::merge:
            return invert ? SolidNode::Kind::intersection : SolidNode::Kind::merge;
        case CsgKind::intersection:
        case CsgKind::difference:
            break;
    }
    return invert ? SolidNode::Kind::merge : SolidNode::Kind::intersection;
}

/// With Remove_Bounds, the default, only these keep a bound at top level (spec: geometry 6).
bool keeps_bounds(const Object& object) {
    if (as<Csg>(object)) return true;
    const auto* shape = as<ShapePtr>(object);
    if (!shape) return false;
    const std::string_view keyword = (*shape)->keyword();
    return keyword == "quadric" || keyword == "cubic" || keyword == "quartic" || keyword == "poly" ||
           keyword == "polynomial" || keyword == "text";
}

/// A union of nothing but lights and things without shadow has none either (spec: geometry 4.6).
bool casts_no_shadow(const Object& object) {
    if (object.no_shadow) return true;
    const auto* csg = as<Csg>(object);
    return csg && csg->kind == CsgKind::union_ && !csg->children->empty() &&
           std::ranges::all_of(*csg->children, [](const ObjectPtr& child) {
               return as<LightPtr>(*child) || casts_no_shadow(*child);
           });
}

/// A child cannot take back what its parent says about photons.
ObjectPhotons handed_down(const ObjectPhotons& parent, ObjectPhotons own) {
    if (parent.target > 0.0f) own.target = parent.target;
    if (parent.ways.refraction != PhotonSwitch::unsaid) own.ways.refraction = parent.ways.refraction;
    if (parent.ways.reflection != PhotonSwitch::unsaid) own.ways.reflection = parent.ways.reflection;
    own.collect = own.collect && parent.collect;
    own.pass_through = own.pass_through || parent.pass_through;
    return own;
}

/// The leaf's surface in the world, cut down to where its hits can count.
Bounds cut_box(const SolidForest& solids, const Leaf& leaf) {
    Bounds box = leaf.shape->bounds();
    if (box.is_empty()) return box;
    if (!leaf.in_world_space) {
        const auto forward = inverse_of(leaf.object_from_world);
        box = forward ? transformed(box, *forward) : Bounds::everything();
    }
    return solids.cut(leaf.solid, box);
}

}  // namespace

Flattener::Flattener(World& world, TexturePtr default_texture, Diagnostics& diagnostics)
    : world_(world),
      default_texture_(std::move(default_texture)),
      diagnostics_(diagnostics),
      surface_table_(world.surfaces),
      draft_(std::make_unique<Draft>()) {}

Flattener::~Flattener() = default;

void Flattener::reserve(const std::vector<ObjectPtr>& objects) {
    Counts counts;
    for (const ObjectPtr& object : objects) count(*object, true, store_, counts);
    flat_.leaves.reserve(counts.shapes);
    flat_.solids.shapes.reserve(counts.shapes);
    flat_.solids.nodes.reserve(counts.shapes + counts.compounds);
    flat_.solids.children.reserve(counts.shapes + counts.compounds - counts.tops);
    flat_.tops.reserve(counts.tops);
    flat_.instances.reserve(counts.instances);
    draft_->top_ends.reserve(counts.tops);
    draft_->slots.reserve(counts.tops);
}

void Flattener::add(const ObjectPtr& object) {
    Inherited from;
    from.fallback_texture = object->fallback_texture ? object->fallback_texture : default_texture_;
    add_top(*object, from);
}

void Flattener::add_whole(const ObjectPtr& object) {
    Inherited from;
    from.fallback_texture = default_texture_;
    add_solid(*object, from);
}

void Flattener::add_top(const Object& object, const Inherited& from) {
    if (const auto* light = as<LightPtr>(object)) return add_light(**light, from);
    if (const auto* missing = as<UnsupportedShape>(object)) {
        diagnostics_.unsupported(object.where, missing->keyword, "the object is left out");
        return;
    }
    if (!add_instance(object, from)) add_flattened(object, from);
}

void Flattener::add_flattened(const Object& object, const Inherited& from) {
    if (splits(object)) {
        const Inherited own = inherit(object, from);
        for (const ObjectPtr& child : *as<Csg>(object)->children) add_top(*child, own);
        return;
    }
    add_solid(object, from);
}

void Flattener::add_solid(const Object& object, const Inherited& from) {
    ++draft_->top_objects;
    const bool own_slot = object.interior || from.slot == no_surface;
    const uint32_t slot = own_slot ? static_cast<uint32_t>(draft_->slots.size()) : from.slot;
    std::vector<uint32_t> outer_cuts = std::exchange(draft_->cuts, {});
    const uint32_t node = build(object, from, false, no_node);
    if (node != no_node) {
        flat_.solids.set_regions(node);
        for (const uint32_t leaf : draft_->cuts) cut_away(leaf);
    }
    draft_->cuts = std::move(outer_cuts);
    if (node == no_node) return;
    flat_.tops.push_back({node, slot, no_surface, {}});
    draft_->top_ends.push_back(static_cast<uint32_t>(flat_.leaves.size()));
}

Flattener::Inherited Flattener::inherit(const Object& object, const Inherited& from) {
    Inherited own = from;
    const auto placed = [&](WornTexture worn) {
        if (!object.uv_mapping)
            worn.world_from_texture = then(worn.world_from_texture, from.world_from_parent);
        return worn;
    };
    own.world_from_parent = then(object.world_from_object, from.world_from_parent);
    if (object.texture) {
        own.texture = placed(*object.texture);
        own.texture_stays = object.uv_mapping;
        own.uv_mapping = object.uv_mapping;
    } else {
        own.uv_mapping = from.uv_mapping || object.uv_mapping;
    }
    if (object.interior_texture) {
        own.interior_texture = placed(*object.interior_texture);
        own.interior_texture_stays = object.uv_mapping;
    } else {
        // Measured: without an interior_texture of its own a child takes the parent's uv flag in any case.
        own.uv_mapping = own.uv_mapping || from.uv_mapping;
    }
    if (object.interior || from.slot == no_surface) {
        own.slot = static_cast<uint32_t>(draft_->slots.size());
        draft_->slots.push_back({transformed(object.interior, from.world_from_parent), false, no_surface});
    }
    own.hollow = object.hollow.value_or(from.hollow);
    own.no_shadow = from.no_shadow || (from.top && casts_no_shadow(object));
    if (!from.flags_fixed) {
        own.no_image = from.no_image || (object.no_image && !from.image_fixed);
        own.no_reflection = from.no_reflection || object.no_reflection;
        own.no_radiosity = from.no_radiosity || object.no_radiosity;
    }
    own.double_illuminate = from.double_illuminate || object.double_illuminate;
    own.photons = handed_down(from.photons, object.photons);
    own.lights_here = 0;
    if (const auto* csg = as<Csg>(object)) {
        own.cutaway = own.cutaway || csg->cutaway_textures;
        if (csg->is_light_group) enter_light_group(*csg, own);
    }
    return own;
}

uint32_t Flattener::build(const Object& object, const Inherited& from, bool invert, uint32_t parent) {
    if (as<LightPtr>(object)) {
        if (from.surfaces) add_light(**as<LightPtr>(object), from);
        return no_node;
    }
    if (const auto* missing = as<UnsupportedShape>(object)) {
        diagnostics_.unsupported(object.where, missing->keyword, "the object is left out");
        return no_node;
    }
    Inherited own = inherit(object, from);
    if (own.surfaces) become_target(own);
    invert = invert != object.inverse;
    if (const auto* shape = as<ShapePtr>(object)) {
        const uint32_t node = build_shape(object, *shape, own, invert, parent);
        add_lists(object, from, node);
        if (own.surfaces) add_leaf(object, own, node);
        return node;
    }
    const Csg& csg = *as<Csg>(object);
    const auto index = static_cast<uint32_t>(flat_.solids.nodes.size());
    SolidNode fresh;
    fresh.kind = node_kind(csg.kind, invert);
    fresh.parent = parent;
    fresh.difference = csg.kind == CsgKind::difference && fresh.kind == SolidNode::Kind::intersection;
    fresh.tests_hits =
        fresh.kind != SolidNode::Kind::union_ || (parent != no_node && flat_.solids.nodes[parent].tests_hits);
    flat_.solids.nodes.push_back(fresh);
    add_lists(object, from, index);
    own.top = false;
    own.image_fixed = own.image_fixed || flat_.solids.nodes[index].kind == SolidNode::Kind::union_;
    own.flags_fixed = own.flags_fixed || flat_.solids.nodes[index].kind == SolidNode::Kind::intersection;
    std::vector<uint32_t> children;
    for (size_t i = 0; i < csg.children->size(); ++i) {
        const bool subtracted = csg.kind == CsgKind::difference && i > 0;
        const uint32_t child = build(*(*csg.children)[i], own, invert != subtracted, index);
        if (child != no_node) children.push_back(child);
    }
    std::vector<uint32_t>& all = flat_.solids.children;
    flat_.solids.nodes[index].first_child = static_cast<uint32_t>(all.size());
    flat_.solids.nodes[index].child_count = static_cast<uint32_t>(children.size());
    all.insert(all.end(), children.begin(), children.end());
    return index;
}

void Flattener::add_lists(const Object& object, const Inherited& from, uint32_t node) {
    if (object.clipped_by.empty() && object.bounded_by.empty()) return;
    Inherited silent;
    silent.world_from_parent = from.world_from_parent;
    silent.surfaces = false;
    const auto build_all = [&](const std::vector<ObjectPtr>& list) {
        std::vector<uint32_t> nodes;
        for (const ObjectPtr& limit : list) {
            const uint32_t built = build(*limit, silent, false, no_node);
            if (built != no_node) nodes.push_back(built);
        }
        return nodes;
    };
    SolidLists lists;
    lists.clips = build_all(object.clipped_by);
    if (keep_all_bounds_ || !from.top || keeps_bounds(object)) lists.bounds = build_all(object.bounded_by);
    if (lists.clips.empty() && lists.bounds.empty()) return;
    SolidNode& target = flat_.solids.nodes[node];
    target.tests_hits = true;
    target.lists = static_cast<uint32_t>(flat_.solids.lists.size());
    flat_.solids.lists.push_back(std::move(lists));
}

uint32_t Flattener::build_shape(const Object&, const ShapePtr& shape, const Inherited& own, bool invert,
                                uint32_t parent) {
    PlacedShape placed{shape, {}, true};
    if (!own.world_from_parent.is_identity()) {
        if (auto moved = shape->transformed(own.world_from_parent)) {
            placed.shape = std::move(moved);
        } else {
            placed = {shape, own.world_from_parent.backward, false};
        }
    }
    placed.shape->prepare();
    SolidNode node;
    node.parent = parent;
    node.inverted = invert && !shape->is_patch();
    if (node.inverted) {
        if (auto complement = placed.shape->inverted()) {
            placed.shape = std::move(complement);
            node.inverted = false;
        }
    }
    node.tests_hits = parent != no_node && flat_.solids.nodes[parent].tests_hits;
    node.placed = static_cast<uint32_t>(flat_.solids.shapes.size());
    flat_.solids.shapes.push_back(std::move(placed));
    flat_.solids.nodes.push_back(node);
    return static_cast<uint32_t>(flat_.solids.nodes.size() - 1);
}

uint32_t Flattener::photon_target(const Leaf& leaf) const {
    return leaf.instance == no_surface ? world_.surfaces[leaf.surface].photons.target : no_target;
}

FlatGeometry Flattener::finish() {
    // A plane wins against a coincident finite object once there are at least three objects.
    std::vector<bool> infinite(draft_->top_ends.size());
    flat_.boxes.reserve(flat_.leaves.size());
    for (size_t i = 0; i < draft_->top_ends.size(); ++i) {
        const auto first = static_cast<std::ptrdiff_t>(flat_.boxes.size());
        const auto last = static_cast<std::ptrdiff_t>(draft_->top_ends[i]);
        put_seen_first(
            flat_.solids, flat_.tops[i].node,
            std::span(flat_.leaves).subspan(static_cast<size_t>(first), static_cast<size_t>(last - first)));
        for (auto leaf = flat_.leaves.begin() + first; leaf != flat_.leaves.begin() + last; ++leaf) {
            const Bounds box = cut_box(flat_.solids, *leaf);
            flat_.boxes.push_back(box);
            flat_.tops[i].box.include(box);
            if (const uint32_t target = photon_target(*leaf); target != no_target)
                world_.photon_targets[target].box.include(box);
            if (!box.is_empty() && !box.is_finite()) infinite[i] = true;
        }
    }
    if (draft_->top_objects >= 3) put_first(infinite, draft_->top_ends, flat_.leaves, flat_.boxes);
    for (TopSolid& top : flat_.tops) {
        if (top.instance != no_surface) continue;
        InteriorSlot& slot = draft_->slots[top.interior];
        if (slot.index == no_surface) slot.index = add_interior(slot.interior, slot.hollow);
        top.interior = slot.index;
    }
    return std::move(flat_);
}

}  // namespace rb
