// background, fog, rainbow, sky_sphere. Language spec 19.
#include "language/read.h"

#include <fmt/format.h>

namespace rb {

Color read_background(const Block& block, const ReadContext& context) {
    BlockReader in(block, context);
    const Color color = in.at_color() ? in.full_color() : Color{};
    in.finish();
    return color;
}

namespace {

bool take_fog_number(BlockReader& in, Fog& fog) {
    if (in.take_word("distance")) {
        fog.distance = in.number();
    } else if (in.take_word("fog_type")) {
        const SourceRange at = in.where();
        fog.type = in.integer();
        if (fog.type < 1 || fog.type > 2) {
            in.diagnostics().warning(at, "Unknown fog type.");
            fog.type = 1;
        }
    } else if (in.take_word("fog_offset")) {
        fog.offset = in.number();
    } else if (in.take_word("fog_alt")) {
        fog.alt = in.number();
    } else if (in.take_word("turb_depth")) {
        fog.turb_depth = in.number();
    } else if (in.take_word("up")) {
        fog.up = in.vec3();
    } else {
        return false;
    }
    return true;
}

bool take_fog_turbulence(BlockReader& in, Fog& fog) {
    const bool known =
        in.at_word("turbulence") || in.at_word("octaves") || in.at_word("omega") || in.at_word("lambda");
    if (!known) return false;
    if (!fog.turbulence) fog.turbulence.emplace();
    if (in.take_word("turbulence")) {
        fog.turbulence->amount = in.vec3();
    } else if (in.take_word("octaves")) {
        fog.turbulence->octaves = std::clamp(in.integer(), 1, 10);
    } else if (in.take_word("omega")) {
        fog.turbulence->omega = static_cast<float>(in.number());
    } else {
        in.take_word("lambda");
        fog.turbulence->lambda = static_cast<float>(in.number());
    }
    return true;
}

}  // namespace

std::shared_ptr<const Fog> read_fog(const Block& block, const ReadContext& context) {
    BlockReader in(block, context);
    auto fog = std::make_shared<Fog>();
    using Shared = std::shared_ptr<const Fog>;
    if (in.at_thing<Shared>()) *fog = *in.thing<Shared>();
    fog->where = block.where;
    while (!in.at_end()) {
        Transform map;
        const SourceRange at = in.where();
        if (take_fog_number(in, *fog) || take_fog_turbulence(in, *fog)) continue;
        if (in.at_word("translate"))
            in.diagnostics().warning(at, "translate does not affect the up vector in fog.");
        if (take_transformation(in, map)) {
            fog->up = map.direction(fog->up);
        } else if (in.at_number() && in.peek().terms == 1) {
            in.diagnostics().warning(at, "Should have 'distance' keyword.");
            fog->distance = in.number();
        } else if (in.at_color()) {
            fog->color = in.full_color();
        } else {
            break;
        }
    }
    in.finish();
    const double length = glm::length(fog->up);
    if (length > 0) fog->up /= length;
    return fog;
}

std::shared_ptr<const SkySphere> read_sky_sphere(const Block& block, const ReadContext& context) {
    BlockReader in(block, context);
    auto sky = std::make_shared<SkySphere>();
    using Shared = std::shared_ptr<const SkySphere>;
    if (in.at_thing<Shared>()) *sky = *in.thing<Shared>();
    sky->where = block.where;
    while (!in.at_end()) {
        if (in.at_block("pigment")) {
            sky->pigments.push_back(read_pigment(in.block("pigment"), context, nullptr));
        } else if (in.take_word("emission")) {
            sky->emission = in.rgb_color();
        } else if (!take_transformation(in, sky->world_from_sky)) {
            break;
        }
    }
    in.finish();
    if (sky->pigments.empty()) in.fail_at(block.where, "Empty sky_sphere statement.");
    return sky;
}

namespace {

constexpr double degree = pi / 180;

double rainbow_angle(BlockReader& in, const char* error) {
    const SourceRange at = in.where();
    const double angle = in.number();
    if (!(angle >= 0 && angle <= 360)) in.fail_at(at, error);
    return angle * degree;
}

/// What the statement itself says about the arc.
struct ArcWords {
    bool arc = false;
    bool falloff = false;
};

bool take_rainbow_part(BlockReader& in, Rainbow& rainbow, ArcWords& given) {
    if (in.take_word("direction")) {
        rainbow.direction = in.vec3();
    } else if (in.take_word("up")) {
        rainbow.up = in.vec3();
    } else if (in.take_word("angle")) {
        rainbow.angle = in.number() * degree;
    } else if (in.take_word("width")) {
        rainbow.width = in.number() * degree;
    } else if (in.take_word("distance")) {
        rainbow.distance = in.number();
    } else if (in.take_word("jitter")) {
        rainbow.jitter = in.number();
    } else if (in.take_word("arc_angle")) {
        rainbow.arc_angle =
            rainbow_angle(in, "Illegal arc angle in rainbow (Use value from 0 to 360 degrees).");
        given.arc = true;
    } else if (in.take_word("falloff_angle")) {
        rainbow.falloff_angle =
            rainbow_angle(in, "Illegal falloff angle in rainbow (Use value from 0 to 360 degrees).");
        given.falloff = true;
    } else if (in.at_block("color_map") || in.at_block("colour_map")) {
        rainbow.color_map = read_color_map(in.block(in.peek_word()), in.context());
    } else {
        return false;
    }
    return true;
}

void check(const BlockReader& in, const Rainbow& rainbow, const ArcWords& given) {
    const double direction = glm::dot(rainbow.direction, rainbow.direction);
    const double up = glm::dot(rainbow.up, rainbow.up);
    if (direction == 0) in.fail_at(in.block_where(), "Rainbow's direction vector is zero.");
    if (up == 0) in.fail_at(in.block_where(), "Rainbow's up vector is zero.");
    const double along = glm::dot(rainbow.direction, rainbow.up);
    if (along * along >= (1 - 1e-12) * direction * up) {
        in.fail_at(in.block_where(), "Rainbow's up and direction vector are co-linear.");
    }
    if (given.falloff && rainbow.arc_angle < rainbow.falloff_angle) {
        in.fail_at(in.block_where(), "Arc angle is smaller than falloff angle in rainbow.");
    }
}

}  // namespace

std::shared_ptr<const Rainbow> read_rainbow(const Block& block, const ReadContext& context) {
    BlockReader in(block, context);
    auto rainbow = std::make_shared<Rainbow>();
    using Shared = std::shared_ptr<const Rainbow>;
    if (in.at_thing<Shared>()) *rainbow = *in.thing<Shared>();
    rainbow->where = block.where;
    ArcWords given;
    while (take_rainbow_part(in, *rainbow, given)) {
    }
    in.finish();
    check(in, *rainbow, given);
    if (given.arc && !given.falloff) rainbow->falloff_angle = rainbow->arc_angle;
    return rainbow;
}

}  // namespace rb
