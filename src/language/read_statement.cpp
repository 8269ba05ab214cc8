// Top-level statements, declared blocks, #default.
#include "language/read.h"

#include <fmt/format.h>

namespace rb {

namespace {

/// `object` is new: nobody else holds it.
void add_object(Session& session, std::shared_ptr<Object> object) {
    if (!std::holds_alternative<LightPtr>(object->geometry))
        object->fallback_texture = session.default_texture;
    session.scene.objects.push_back(std::move(object));
}

void read_background_statement(Session& session, const Block& block, const ReadContext& context) {
    Color color = read_background(block, context);
    if (session.effective_version() < 370) {
        color.filter = 0;
        color.transmit = 0;
    }
    session.scene.background = color;
}

void read_camera_statement(Session& session, const Block& block, const ReadContext& context) {
    if (++session.cameras == 2) {
        session.warn(block.where, "More than one camera in scene. Ignoring previous camera(s).");
    }
    session.scene.camera = *read_camera(block, context);
}

}  // namespace

bool begins_statement(std::string_view keyword) {
    constexpr std::string_view others[] = {"camera",     "fog",   "rainbow",        "sky_sphere",
                                           "background", "media", "global_settings"};
    for (std::string_view other : others) {
        if (keyword == other) return true;
    }
    return is_object_keyword(keyword);
}

void read_statement(Session& session, const Block& block) {
    const ReadContext context = session.context();
    const std::string_view keyword = block.keyword;
    if (is_object_keyword(keyword)) {
        add_object(session, read_new_object(block, context));
    } else if (keyword == "camera") {
        read_camera_statement(session, block, context);
    } else if (keyword == "global_settings") {
        read_global_settings(session, block);
    } else if (keyword == "background") {
        read_background_statement(session, block, context);
    } else if (keyword == "fog") {
        session.scene.fogs.push_back(*read_fog(block, context));
    } else if (keyword == "sky_sphere") {
        if (session.scene.sky_sphere)
            session.warn(block.where, "Multiple sky_spheres: only the last one counts.");
        session.scene.sky_sphere = *read_sky_sphere(block, context);
    } else if (keyword == "rainbow") {
        session.scene.rainbows.push_back(*read_rainbow(block, context));
    } else if (keyword == "media") {
        session.scene.atmosphere.push_back(read_media(block, context));
    } else {
        session.fail(block.where, fmt::format("Expected 'object or directive', {} found instead", keyword));
    }
}

Value read_value(Session& session, const Block& block, const ReadContext& context) {
    const std::string_view k = block.keyword;
    const Texture& defaults = context.default_texture->front();
    if (is_object_keyword(k)) return Thing(read_object(block, context));
    if (k == "texture") return Thing(read_texture(block, context));
    if (k == "pigment") return Thing(read_pigment(block, context, defaults.pigment));
    if (k == "normal") return Thing(read_normal(block, context, defaults.normal));
    if (k == "finish") return Thing(read_finish(block, context, defaults.finish));
    if (k == "interior") return Thing(read_interior(block, context, nullptr));
    if (k == "material") return Thing(read_material(block, context));
    if (k == "color_map" || k == "colour_map") return Thing(read_color_map(block, context));
    if (k == "pigment_map") return Thing(read_pigment_map(block, context));
    if (k == "normal_map") return Thing(read_normal_map(block, context));
    if (k == "texture_map") return Thing(read_texture_map(block, context));
    if (k == "slope_map") return Thing(read_slope_map(block, context));
    if (k == "camera") return Thing(read_camera(block, context));
    if (k == "transform") return Thing(read_transform(block, context));
    if (k == "fog") return Thing(read_fog(block, context));
    if (k == "sky_sphere") return Thing(read_sky_sphere(block, context));
    if (k == "media") return Thing(read_media(block, context));
    if (k == "density") return Thing(read_density(block, context));
    if (k == "density_map") return Thing(read_density_map(block, context));
    if (k == "rainbow") return Thing(read_rainbow(block, context));
    session.fail(block.where, fmt::format("Expected 'RValue to declare', {} found instead", k));
}

void read_default(Session& session, const Block& block) {
    const ReadContext context = session.context();
    BlockReader in(block, context);
    while (!in.at_end()) {
        ReadContext now = session.context();
        if (in.at_block("texture")) {
            const SourceRange at = in.where();
            const TexturePtr texture = read_texture(in.block("texture"), now);
            if (texture->size() > 1) in.fail_at(at, "Default texture cannot be layered.");
            if (texture->front().is_patterned()) {
                in.fail_at(at, "Default texture cannot be material map or tiles.");
            }
            session.default_texture = texture;
        } else if (in.at_block("pigment") || in.at_block("normal") || in.at_block("finish")) {
            TexturePtr layers = session.default_texture;
            edit_texture(in.block(in.peek_word()), now, layers);
            session.default_texture = layers;
        } else if (in.at_block("camera")) {
            read_camera_draft(in.block("camera"), now, session.default_camera, true);
        } else if (in.at_block("radiosity")) {
            const auto importance = read_importance(in.block("radiosity"), now);
            if (importance) session.default_importance = *importance;
        } else {
            break;
        }
    }
    in.finish();
}

}  // namespace rb
