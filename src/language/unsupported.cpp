#include "language/unsupported.h"

#include "language/read_pattern.h"

#include <unordered_set>

#include <fmt/format.h>

namespace rb {

namespace {

class Walk {
public:
    explicit Walk(Diagnostics& diagnostics) : diagnostics_(diagnostics) {}

    void object(const ObjectPtr& object) {
        if (!object || !is_new(object)) return;
        if (object->texture) layers(object->texture->layers);
        if (object->interior_texture) layers(object->interior_texture->layers);
        if (object->fallback_texture) layers(object->fallback_texture);
        if (object->interior && is_new(object->interior)) media(object->interior->media);
        if (const auto* shape = std::get_if<UnsupportedShape>(&object->geometry)) {
            diagnostics_.unsupported(object->where, shape->keyword, "the object is left out");
        }
        if (const auto* csg = std::get_if<Csg>(&object->geometry); csg && csg->children) {
            // Copies of a compound share their children.
            if (is_new(csg->children)) {
                for (const ObjectPtr& child : *csg->children) this->object(child);
            }
        }
        if (const auto* light = std::get_if<LightPtr>(&object->geometry); light && is_new(*light)) {
            this->object((*light)->looks_like);
            this->object((*light)->projected_through);
        }
        if (const auto* shape = std::get_if<ShapePtr>(&object->geometry); shape && *shape && is_new(*shape)) {
            for (const TexturePtr& texture : (*shape)->textures()) layers(texture);
        }
    }

    void pigment(const PigmentPtr& pigment) {
        if (!pigment || !is_new(pigment)) return;
        if (const auto* p = std::get_if<PatternPtr>(&pigment->source)) pattern(*p);
        if (const auto* map = std::get_if<BlendMap<PigmentPtr>>(&pigment->map)) {
            for (const auto& entry : *map) this->pigment(entry.value);
        }
    }

    void media(const std::vector<MediaPtr>& all) {
        for (const MediaPtr& medium : all) {
            for (const DensityPtr& density : medium->densities) pigment(density);
        }
    }

    void normal(const NormalPtr& normal) {
        if (!normal || !is_new(normal)) return;
        pattern(normal->pattern);
        if (const auto* map = std::get_if<BlendMap<NormalPtr>>(&normal->map)) {
            for (const auto& entry : *map) this->normal(entry.value);
        }
    }

private:
    /// What nobody else holds is met once, if that is true of everything on the way to it.
    template <class T>
    bool is_new(const std::shared_ptr<const T>& thing) {
        return thing.use_count() == 1 || seen_.insert(thing.get()).second;
    }

    void layers(const TexturePtr& layers) {
        if (!layers || !is_new(layers)) return;
        for (const Texture& layer : *layers) {
            pigment(layer.pigment);
            normal(layer.normal);
            pattern(layer.pattern);
            for (const auto& entry : layer.map) this->layers(entry.value);
        }
    }

    void pattern(const PatternPtr& pattern) {
        const auto* unknown = dynamic_cast<const UnsupportedPattern*>(pattern.get());
        if (!unknown) return;
        diagnostics_.unsupported(unknown->where, fmt::format("pattern {}", unknown->keyword()),
                                 "its value is 0.5 everywhere");
    }

    Diagnostics& diagnostics_;
    std::unordered_set<const void*> seen_;
};

}  // namespace

void report_unsupported(const Scene& scene, Diagnostics& diagnostics) {
    Walk walk(diagnostics);
    walk.normal(scene.camera.normal);
    walk.pigment(scene.camera.bokeh);
    for (const ObjectPtr& object : scene.objects) walk.object(object);
    walk.media(scene.atmosphere);
    if (scene.sky_sphere) {
        for (const PigmentPtr& pigment : scene.sky_sphere->pigments) walk.pigment(pigment);
    }
}

}  // namespace rb
