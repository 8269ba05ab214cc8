#include "scene/object.h"

namespace rb {

namespace {

std::vector<ObjectPtr> transformed(const std::vector<ObjectPtr>& objects, const Transform& map) {
    std::vector<ObjectPtr> out;
    out.reserve(objects.size());
    for (const ObjectPtr& object : objects) {
        auto moved = make_object(*object);
        transform_object(*moved, map);
        out.push_back(std::move(moved));
    }
    return out;
}

}  // namespace

const std::vector<ObjectPtr> ObjectList::none;

ObjectList::ObjectList(std::vector<ObjectPtr> objects) {
    if (!objects.empty()) objects_ = std::make_shared<const std::vector<ObjectPtr>>(std::move(objects));
}

InteriorPtr transformed(const InteriorPtr& interior, const Transform& map) {
    if (!interior || interior->media.empty()) return interior;
    auto out = std::make_shared<Interior>(*interior);
    out->media = transformed(std::move(out->media), map);
    return out;
}

Light transformed(const Light& light, const Transform& map) {
    Light out = light;
    out.location = map.point(light.location);
    out.point_at = map.point(light.point_at);
    out.area.axis1 = map.direction(light.area.axis1);
    out.area.axis2 = map.direction(light.area.axis2);
    for (auto* carried : {&out.looks_like, &out.projected_through}) {
        if (!*carried) continue;
        auto moved = make_object(**carried);
        transform_object(*moved, map);
        *carried = std::move(moved);
    }
    return out;
}

void transform_object(Object& object, const Transform& map) {
    if (auto* light = std::get_if<LightPtr>(&object.geometry)) {
        *light = std::make_shared<Light>(transformed(**light, map));
        return;
    }
    object.world_from_object =
        object.world_from_object.is_identity() ? map : then(object.world_from_object, map);
    if (!object.bounded_by.empty()) object.bounded_by = transformed(object.bounded_by, map);
    if (!object.clipped_by.empty()) object.clipped_by = transformed(object.clipped_by, map);
    object.interior = transformed(object.interior, map);
    if (object.uv_mapping) return;
    if (object.texture) object.texture->world_from_texture = then(object.texture->world_from_texture, map);
    if (object.interior_texture) {
        object.interior_texture->world_from_texture = then(object.interior_texture->world_from_texture, map);
    }
}

}  // namespace rb
