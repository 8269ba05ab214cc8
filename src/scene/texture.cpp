#include "scene/texture.h"

namespace rb {

const TurbulenceWarp* PatternModifiers::classic_turbulence() const {
    if (warps.empty()) return nullptr;
    const auto* last = std::get_if<TurbulenceWarp>(&warps.back());
    return last && last->classic ? last : nullptr;
}

TexturePtr plain_texture(Pigment pigment) {
    Texture layer;
    layer.pigment = std::make_shared<const Pigment>(std::move(pigment));
    layer.finish = std::make_shared<const Finish>();
    return std::make_shared<const TextureLayers>(TextureLayers{std::move(layer)});
}

PatternModifiers transformed(const PatternModifiers& modifiers, const Transform& map) {
    PatternModifiers out = modifiers;
    if (!out.warps.empty() && std::holds_alternative<Transform>(out.warps.front())) {
        auto& front = std::get<Transform>(out.warps.front());
        front = then(front, map);
    } else {
        out.warps.insert(out.warps.begin(), map);
    }
    return out;
}

Texture transformed(const Texture& texture, const Transform& map) {
    Texture out = texture;
    if (texture.is_patterned()) {
        out.modifiers = transformed(texture.modifiers, map);
        return out;
    }
    // What is mapped by surface coordinates does not move with the object.
    if (texture.pigment && !texture.pigment->uv_mapping &&
        !std::holds_alternative<Color>(texture.pigment->source)) {
        auto pigment = std::make_shared<Pigment>(*texture.pigment);
        pigment->modifiers = transformed(pigment->modifiers, map);
        out.pigment = std::move(pigment);
    }
    if (texture.normal && !texture.normal->uv_mapping) {
        auto normal = std::make_shared<Normal>(*texture.normal);
        normal->modifiers = transformed(normal->modifiers, map);
        out.normal = std::move(normal);
    }
    return out;
}

TexturePtr transformed(const TexturePtr& layers, const Transform& map) {
    if (!layers || map.is_identity()) return layers;
    auto out = std::make_shared<TextureLayers>();
    out->reserve(layers->size());
    for (const Texture& layer : *layers) out->push_back(transformed(layer, map));
    return out;
}

}  // namespace rb
