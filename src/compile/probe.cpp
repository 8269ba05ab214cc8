#include "compile/probe.h"

#include "compile/geometry_parts.h"

#include <algorithm>

namespace rb {

namespace {

constexpr double min_depth = 1e-4;  ///< the language's smallest depth
constexpr double huge_half = 1e10;  ///< its infinite boxes
constexpr double critical = 1e6;    ///< a compound's longer box is infinite

/// Its only use here is that geometry can be flattened without a scene.
TexturePtr blank_texture() {
    auto pigment = std::make_shared<Pigment>();
    Texture layer;
    layer.pigment = std::move(pigment);
    layer.finish = std::make_shared<Finish>();
    return std::make_shared<TextureLayers>(TextureLayers{std::move(layer)});
}

Bounds language_box(const Object& object, const Transform& world_from_parent);

/// The box of a list of bounds or clips replaces the object's own if it is smaller.
void tighten(Bounds& box, const std::vector<ObjectPtr>& list, const Transform& world_from_parent) {
    if (list.empty()) return;
    Bounds common = Bounds::everything();
    for (const ObjectPtr& object : list) {
        if (!object->inverse) common = intersection(common, language_box(*object, world_from_parent));
    }
    const auto volume = [](const Bounds& b) {
        const Vec3 s = b.size();
        return s.x * s.y * s.z;
    };
    if (common.is_empty() || !common.is_finite()) return;
    if (!box.is_finite()) {
        box = intersection(box, common);
    } else if (volume(common) < volume(box)) {
        box = common;
    }
}

Bounds compound_box(const Csg& csg, bool invert, const Transform& inner) {
    const bool all = (csg.kind == CsgKind::intersection || csg.kind == CsgKind::difference) != invert;
    Bounds box = all ? Bounds::everything() : Bounds{};
    for (size_t i = 0; i < csg.children->size(); ++i) {
        const Object& child = *(*csg.children)[i];
        if (std::holds_alternative<LightPtr>(child.geometry)) continue;
        const bool subtracted = csg.kind == CsgKind::difference && i > 0;
        const bool inverted = (child.inverse != subtracted) != invert;
        if (!all) {
            box.include(language_box(child, inner));
        } else if (!inverted) {
            const auto* shape = std::get_if<ShapePtr>(&child.geometry);
            const Transform place = then(child.world_from_object, inner);
            const ShapePtr plane =
                shape && (*shape)->keyword() == "plane" ? (*shape)->transformed(place) : nullptr;
            box = intersection(box, plane ? plane->solid_bounds() : language_box(child, inner));
        }
    }
    if (all && box.is_empty()) box = Bounds::everything();
    for (int i = 0; i < 3; ++i) {
        if (box.hi[i] - box.lo[i] > critical) {
            box.lo[i] = -huge_half;
            box.hi[i] = huge_half;
        }
    }
    return box;
}

Bounds language_box(const Object& object, const Transform& world_from_parent) {
    const Transform place = then(object.world_from_object, world_from_parent);
    Bounds box;
    if (const auto* shape = std::get_if<ShapePtr>(&object.geometry)) {
        const ShapePtr moved = place.is_identity() ? *shape : (*shape)->transformed(place);
        box = moved ? moved->language_extent() : transformed((*shape)->language_extent(), place.forward);
    } else if (const auto* csg = std::get_if<Csg>(&object.geometry)) {
        box = compound_box(*csg, object.inverse, place);
    }
    tighten(box, object.bounded_by, world_from_parent);
    tighten(box, object.clipped_by, world_from_parent);
    return box;
}

}  // namespace

struct ObjectProbe::Prepared {
    ObjectPtr object;  ///< keeps the key alive
    World world;
};

ObjectProbe::ObjectProbe(Diagnostics& diagnostics) : diagnostics_(diagnostics) {}
ObjectProbe::~ObjectProbe() = default;

const ObjectProbe::Prepared& ObjectProbe::prepare(const ObjectPtr& object) {
    std::unique_ptr<Prepared>& entry = prepared_[object.get()];
    if (entry) return *entry;
    entry = std::make_unique<Prepared>();
    entry->object = object;
    static const TexturePtr blank = blank_texture();
    Flattener flattener(entry->world, blank, diagnostics_);
    flattener.keep_all_bounds();
    flattener.add_whole(object);
    entry->world.geometry = make_geometry(flattener.finish(), false);
    return *entry;
}

std::optional<Traced> ObjectProbe::trace(const ObjectPtr& object, const Vec3& origin, const Vec3& direction) {
    RayQuery query;
    query.ray = {origin, glm::normalize(direction)};
    query.mask = seen_by_trace;
    query.t_min = min_depth;
    Hit hit;
    if (!prepare(object).world.geometry->closest(query, hit)) return std::nullopt;
    return Traced{hit.point, hit.normal};
}

bool ObjectProbe::inside(const ObjectPtr& object, const Vec3& p) {
    const FlatGeometry& flat = prepare(object).world.geometry->parts->flat;
    return std::any_of(flat.tops.begin(), flat.tops.end(),
                       [&](const TopSolid& top) { return flat.solids.inside(top.node, p); });
}

Bounds ObjectProbe::extent(const ObjectPtr& object) {
    Bounds box = language_box(*object, Transform{});
    if (box.is_empty()) return {Vec3{0.0}, Vec3{0.0}};
    for (int i = 0; i < 3; ++i) {
        // Kept as a corner and a length, both in single precision.
        const double lo = std::clamp(box.lo[i], -huge_half, huge_half);
        const double hi = std::clamp(box.hi[i], -huge_half, huge_half);
        const auto corner = static_cast<float>(lo);
        const auto length = static_cast<float>(hi - lo);
        box.lo[i] = corner;
        box.hi[i] = static_cast<double>(corner) + static_cast<double>(length);
    }
    return box;
}

bool ObjectProbe::has_inside(const Object& object) {
    if (const auto* shape = std::get_if<ShapePtr>(&object.geometry)) return !(*shape)->is_patch();
    const auto* csg = std::get_if<Csg>(&object.geometry);
    if (!csg) return true;
    return std::all_of(csg->children->begin(), csg->children->end(),
                       [](const ObjectPtr& child) { return has_inside(*child); });
}

}  // namespace rb
