// light_source. Language spec 20.2.
#include "language/read.h"

#include <algorithm>

#include <fmt/format.h>

namespace rb {

namespace {

/// `looks_like { OBJECT modifiers }` is an object statement under another name.
std::shared_ptr<Object> read_carried(const Block& block, const ReadContext& context) {
    Block statement = block;
    statement.keyword = "object";
    return make_object(*read_object(statement, context));
}

ObjectPtr read_looks_like(const Block& block, const ReadContext& context, const Light& light) {
    auto object = read_carried(block, context);
    transform_object(*object, Transform::translation(light.location));
    object->no_shadow = true;
    object->photons.pass_through = true;
    return object;
}

/// Its shape alone counts.
ObjectPtr read_projected_through(const Block& block, const ReadContext& context) {
    auto object = read_carried(block, context);
    const auto remove = [&](auto& worn, std::string_view name) {
        if (!worn) return;
        context.diagnostics->warning(
            block.where, fmt::format("Projected through objects can not have {}, {} removed.", name, name));
        worn = {};
    };
    remove(object->interior, "interior");
    remove(object->texture, "texture");
    object->interior_texture.reset();
    return object;
}

bool take_kind(BlockReader& in, Light& light) {
    if (in.take_word("spotlight")) {
        light.kind = LightKind::spotlight;
        light.radius = 30;
        light.falloff = 45;
        light.tightness = 0;
    } else if (in.take_word("cylinder")) {
        light.kind = LightKind::cylinder;
        light.radius = 0.75;
        light.falloff = 1;
        light.tightness = 0;
        light.parallel = true;
    } else if (in.take_word("shadowless")) {
        light.kind = LightKind::shadowless;
    } else if (in.take_word("parallel")) {
        light.parallel = true;
    } else {
        return false;
    }
    return true;
}

bool take_beam(BlockReader& in, Light& light) {
    const bool beam = light.kind == LightKind::spotlight || light.kind == LightKind::cylinder;
    const std::string word(in.at_word() ? in.peek_word() : std::string_view{});
    const bool numbers = word == "radius" || word == "falloff" || word == "tightness";
    if (!numbers && word != "point_at") return false;
    if (!beam && !(word == "point_at" && light.parallel)) {
        in.fail(fmt::format("Keyword '{}' cannot be used with standard light source.", word));
    }
    in.skip_item();
    if (word == "point_at") light.point_at = in.vec3();
    if (word == "radius") light.radius = in.number();
    if (word == "falloff") light.falloff = in.number();
    if (word == "tightness") light.tightness = in.number();
    return true;
}

int area_size(BlockReader& in) {
    const SourceRange at = in.where();
    const int size = in.integer();
    if (size == 0) in.fail_at(at, "Area size must be greater than zero.");
    return std::clamp(size < 0 ? -size : size, 1, 65536);
}

bool take_area(BlockReader& in, Light& light) {
    if (in.take_word("area_light")) {
        light.is_area = true;
        light.area.axis1 = in.vec3();
        light.area.axis2 = in.vec3();
        light.area.size1 = area_size(in);
        light.area.size2 = area_size(in);
    } else if (in.take_word("adaptive")) {
        light.area.adaptive = in.integer();
    } else if (in.take_word("jitter")) {
        light.area.jitter = true;
    } else if (in.at_word("circular") || in.at_word("orient") || in.at_word("area_illumination")) {
        const SourceRange at = in.where();
        const std::string word(in.word());
        if (!light.is_area) {
            in.diagnostics().warning(at, fmt::format("'{}' only affects area_light.", word));
        }
        if (word == "area_illumination") {
            light.area.area_illumination = in.optional_switch();
        } else if (word == "orient") {
            light.area.orient = true;
        } else {
            if (light.is_area && (light.area.size1 < 2 || light.area.size2 < 2)) {
                in.fail_at(at, "Circular area light must have more than 1 point per axis");
            }
            light.area.circular = true;
        }
    } else {
        return false;
    }
    return true;
}

bool take_other(BlockReader& in, Light& light) {
    const ReadContext& context = in.context();
    Transform map;
    if (in.take_word("fade_distance")) {
        light.fade_distance = in.number();
    } else if (in.take_word("fade_power")) {
        light.fade_power = in.number();
    } else if (in.take_word("media_attenuation")) {
        light.media_attenuation = in.optional_switch();
    } else if (in.take_word("media_interaction")) {
        light.media_interaction = in.optional_switch();
    } else if (in.at_block("looks_like")) {
        if (light.looks_like) in.fail("Only one looks_like allowed per light_source.");
        light.looks_like = read_looks_like(in.block("looks_like"), context, light);
    } else if (in.at_block("projected_through")) {
        if (light.projected_through) in.fail("Only one projected through allowed per light_source.");
        light.projected_through = read_projected_through(in.block("projected_through"), context);
    } else if (in.at_block("photons")) {
        read_light_photons(in.block("photons"), context, light.photons);
    } else if (in.at_block("color_map") || in.at_block("colour_map")) {
        const auto colors = read_color_map(in.block(in.peek_word()), context);
        Rgb sum{0.0f};
        for (const auto& entry : *colors) sum += entry.position * entry.value.rgb();
        light.color = sum;
    } else if (take_transformation(in, map)) {
        light = transformed(light, map);
    } else {
        return false;
    }
    return true;
}

}  // namespace

LightPtr read_light(BlockReader& in) {
    auto light = std::make_shared<Light>();
    light->where = in.block_where();
    light->location = in.vec3();
    light->color = in.rgb_color();
    while (!in.at_end()) {
        if (!take_kind(in, *light) && !take_beam(in, *light) && !take_area(in, *light) &&
            !take_other(in, *light)) {
            break;
        }
    }
    in.finish();
    return light;
}

}  // namespace rb
