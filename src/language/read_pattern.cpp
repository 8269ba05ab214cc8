// Patterns and their modifiers. Language spec 18.5, 18.6.
#include "language/read_pattern.h"

#include "language/session.h"
#include "language/skipped.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

namespace rb {

namespace {

/// Words of patterns that have no PatternKind.
constexpr std::array<std::string_view, 6> other_pattern_words{"average",         "material_map", "object",
                                                              "pigment_pattern", "tiles",        "potential"};

bool is_pattern_word(std::string_view word) {
    return find_pattern(word) != nullptr ||
           std::ranges::find(other_pattern_words, word) != other_pattern_words.end();
}

TurbulenceWarp& classic(PatternModifiers& modifiers) {
    auto* last = modifiers.warps.empty() ? nullptr : std::get_if<TurbulenceWarp>(&modifiers.warps.back());
    if (last && last->classic) return *last;
    TurbulenceWarp added;
    added.classic = true;
    modifiers.warps.emplace_back(added);
    return std::get<TurbulenceWarp>(modifiers.warps.back());
}

bool take_turbulence_part(BlockReader& in, TurbulenceWarp& warp) {
    if (in.take_word("octaves")) {
        warp.octaves = std::clamp(in.integer(), 1, 10);
    } else if (in.take_word("omega")) {
        warp.omega = static_cast<float>(in.number());
    } else if (in.take_word("lambda")) {
        warp.lambda = static_cast<float>(in.number());
    } else {
        return false;
    }
    return true;
}

Warp take_repeat(BlockReader& in) {
    RepeatWarp warp;
    const SourceRange at = in.where();
    const Vec3 v = in.vec3();
    int axes = 0;
    for (int k = 0; k < 3; ++k) {
        if (v[k] == 0.0) continue;
        ++axes;
        warp.axis = k;
        warp.width = static_cast<float>(v[k]);
    }
    if (axes == 0) in.fail_at(at, "No axis specified in repeat.");
    if (axes > 1) in.fail_at(at, "Can only repeat along 1 axis.");
    while (true) {
        if (in.take_word("offset")) {
            warp.offset = in.vec3();
        } else if (in.take_word("flip")) {
            const Vec3 flips = in.vec3();
            for (int k = 0; k < 3; ++k) warp.flip[k] = flips[k] != 0.0 ? -1.0 : 1.0;
        } else {
            return warp;
        }
    }
}

/// A black hole that repeats must lie within its block.
void make_room(BlackHoleWarp& warp, Diagnostics& diagnostics, SourceRange at) {
    for (int k = 0; k < 3; ++k) {
        if (warp.repeat[k] <= 0.0) continue;
        warp.center[k] = std::max(warp.center[k], warp.radius);
        const double least = warp.center[k] + warp.radius + warp.turbulence[k];
        if (warp.repeat[k] >= least) continue;
        warp.repeat[k] = least;
        diagnostics.warning(
            at, fmt::format("Black Hole repeat vector {} too small; increased to {:g}.", "XYZ"[k], least));
    }
}

Warp take_black_hole(BlockReader& in) {
    BlackHoleWarp warp;
    warp.center = in.vec3();
    warp.radius = in.number();
    while (true) {
        if (in.take_word("strength")) {
            warp.strength = in.number();
        } else if (in.take_word("falloff")) {
            warp.falloff = in.number();
        } else if (in.take_word("inverse")) {
            warp.inverse = true;
        } else if (in.take_word("type")) {
            warp.acts = in.integer() == 0;
        } else if (in.at_word("repeat") || in.at_word("turbulence")) {
            const bool repeat = in.take_word("repeat");
            if (!repeat) in.take_word("turbulence");
            const SourceRange at = in.where();
            (repeat ? warp.repeat : warp.turbulence) = in.vec3();
            make_room(warp, in.diagnostics(), at);
        } else {
            return warp;
        }
    }
}

Warp take_mapping(BlockReader& in, Mapping kind) {
    MappingWarp warp;
    warp.kind = kind;
    if (kind == Mapping::planar && in.at_number()) {
        warp.orientation = in.vec3();
        warp.offset = in.number();
    }
    while (true) {
        if (in.take_word("orientation")) {
            warp.orientation = in.vec3();
        } else if (in.take_word("dist_exp")) {
            warp.dist_exp = in.number();
        } else if (in.take_word("major_radius")) {
            warp.major_radius = in.number();
        } else {
            break;
        }
    }
    if (glm::dot(warp.orientation, warp.orientation) > 0) warp.orientation = glm::normalize(warp.orientation);
    return warp;
}

Warp read_warp(const Block& block, const ReadContext& context) {
    BlockReader in(block, context);
    Warp warp;
    if (in.take_word("turbulence")) {
        TurbulenceWarp turbulence;
        turbulence.amount = in.vec3();
        while (take_turbulence_part(in, turbulence)) {
        }
        warp = turbulence;
    } else if (in.take_word("repeat")) {
        warp = take_repeat(in);
    } else if (in.take_word("black_hole")) {
        warp = take_black_hole(in);
    } else if (in.take_word("cylindrical")) {
        warp = take_mapping(in, Mapping::cylindrical);
    } else if (in.take_word("spherical")) {
        warp = take_mapping(in, Mapping::spherical);
    } else if (in.take_word("toroidal")) {
        warp = take_mapping(in, Mapping::toroidal);
    } else if (in.take_word("planar")) {
        warp = take_mapping(in, Mapping::planar);
    } else if (in.take_word("cubic")) {
        warp = CubicWarp{};
    } else {
        in.fail(fmt::format("Expected 'warp type', {} found instead", in.found()));
    }
    in.finish();
    return warp;
}

bool take_wave(BlockReader& in, PatternModifiers& modifiers) {
    constexpr std::array<std::pair<std::string_view, Wave>, 5> waves{{{"ramp_wave", Wave::ramp},
                                                                      {"triangle_wave", Wave::triangle},
                                                                      {"sine_wave", Wave::sine},
                                                                      {"scallop_wave", Wave::scallop},
                                                                      {"cubic_wave", Wave::cubic}}};
    for (const auto& [word, wave] : waves) {
        if (!in.take_word(word)) continue;
        modifiers.wave = wave;
        return true;
    }
    if (!in.take_word("poly_wave")) return false;
    modifiers.wave = Wave::poly;
    modifiers.poly_exponent = in.at_number() ? static_cast<float>(in.number()) : 1.0f;
    return true;
}

/// Leaves out the arguments of a pattern that is not known.
PatternPtr skip_pattern(BlockReader& in) {
    const std::string word(in.peek_word());
    auto pattern = std::make_shared<UnsupportedPattern>(word, in.where());
    if (in.at_any_block()) {
        BlockReader inside(*in.peek().block, in.context());
        while (!inside.at_end()) skip_item(inside);
        in.skip_item();
        return pattern;
    }
    in.skip_item();
    while (in.at_number() || in.at_text()) skip_item(in);
    return pattern;
}

/// object { OBJECT [transformations] list }
void take_object_pattern(BlockReader& outer, TakenPattern& out) {
    const SourceRange at = outer.where();
    const Block& block = outer.block("object");
    const ReadContext& context = outer.context();
    BlockReader in(block, context);
    ObjectPtr object;
    if (in.at_thing<ObjectPtr>()) {
        object = in.thing<ObjectPtr>();
    } else if (in.at_any_block() && is_object_keyword(in.peek().block->keyword)) {
        object = read_object(*in.peek().block, context);
        in.skip_item();
    } else {
        in.fail(fmt::format("Expected 'object', {} found instead", in.found()));
    }
    Transform map;
    while (take_transformation(in, map)) {
    }
    auto moved = make_object(*object);
    transform_object(*moved, map);
    GeometryOracle* oracle = context.session->options.oracle;
    if (oracle) out.pattern = oracle->object_pattern(moved);
    if (!out.pattern) out.pattern = std::make_shared<UnsupportedPattern>("object", at);
    auto list = std::make_shared<Block>();
    list->where = block.where;
    list->keyword = block.keyword;
    list->numbers = block.numbers;
    while (!in.at_end()) {
        list->items.push_back(in.peek());
        in.skip_item();
    }
    out.list = std::move(list);
}

}  // namespace

bool at_pattern(const BlockReader& in) {
    if (in.at_thing<FunctionPtr>()) return true;
    const std::string_view word = in.peek_word();
    return !word.empty() && (is_pattern_word(word) || word == "function");
}

TakenPattern take_pattern(BlockReader& in, std::string_view statement, PatternModifiers& modifiers) {
    TakenPattern out;
    if (!at_pattern(in)) return out;
    out.taken = true;
    if (in.take_word("average")) {
        out.average = true;
        return out;
    }
    if (in.at_word("function")) in.skip_item();
    if (in.at_thing<FunctionPtr>()) {
        const SourceRange at = in.where();
        const FunctionPtr function = in.thing<FunctionPtr>();
        if (function->result_count() != 1 || function->parameter_count() > 3) {
            in.fail_at(at, "Expected a float function of x, y, z.");
        }
        out.pattern = function_pattern(function);
        return out;
    }
    const std::string word(in.peek_word());
    out.kind = find_pattern(word);
    if (out.kind) {
        const std::string_view only_in = out.kind->only_in;
        if (!only_in.empty() && statement != only_in)
            in.fail(fmt::format("Keyword '{}' can only be used in a {} statement.", word, only_in));
        if (in.at_word()) in.skip_item();
        out.pattern = out.kind->read(in);
        if (out.kind->default_wave != Wave::ramp) modifiers.wave = out.kind->default_wave;
        if (out.kind->default_frequency != 1) modifiers.frequency = out.kind->default_frequency;
        return out;
    }
    if (word == "pigment_pattern" && in.at_any_block()) {
        const ReadContext& context = in.context();
        out.pattern =
            pigment_pattern(read_pigment(in.block(word), context, context.default_texture->front().pigment),
                            *context.settings);
        return out;
    }
    if (word == "object" && in.at_any_block()) {
        take_object_pattern(in, out);
        modifiers.frequency = 0;
        return out;
    }
    out.pattern = skip_pattern(in);
    if (word == "object") modifiers.frequency = 0;
    return out;
}

bool take_modifier(BlockReader& in, PatternModifiers& modifiers) {
    Transform map;
    if (take_transformation(in, map)) {
        modifiers = transformed(modifiers, map);
    } else if (in.take_word("turbulence")) {
        classic(modifiers).amount = in.vec3();
    } else if (in.at_word("octaves") || in.at_word("omega") || in.at_word("lambda")) {
        take_turbulence_part(in, classic(modifiers));
    } else if (in.take_word("frequency")) {
        modifiers.frequency = static_cast<float>(in.number());
    } else if (in.take_word("phase")) {
        modifiers.phase = static_cast<float>(in.number());
    } else if (in.take_word("agate_turb")) {
        modifiers.agate_turbulence = static_cast<float>(in.number());
        classic(modifiers);
    } else if (in.take_word("noise_generator")) {
        const SourceRange at = in.where();
        modifiers.noise_generator = in.integer();
        if (modifiers.noise_generator < 0 || modifiers.noise_generator > 3) {
            in.fail_at(at, "noise_generator must be 0, 1, 2 or 3.");
        }
    } else if (in.at_block("warp")) {
        modifiers.warps.insert(modifiers.warps.begin(), read_warp(in.block("warp"), in.context()));
    } else {
        return take_wave(in, modifiers);
    }
    return true;
}

bool take_parameter(BlockReader& in, PatternPtr& pattern) {
    if (!pattern) return false;
    if (const PatternKind* kind = find_pattern(pattern->keyword()); kind && kind->read_parameter) {
        if (PatternPtr changed = kind->read_parameter(in, pattern)) {
            pattern = std::move(changed);
            return true;
        }
    }
    return false;
}

void check_parameters(const BlockReader& in, const PatternPtr& pattern) {
    const PatternKind* kind = pattern ? find_pattern(pattern->keyword()) : nullptr;
    if (!kind || !kind->check) return;
    if (std::string problem = kind->check(*pattern); !problem.empty()) in.fail(std::move(problem));
}

void UnsupportedPattern::evaluate(const PatternContext&, std::span<const Vec3>,
                                  std::span<double> values) const {
    std::fill(values.begin(), values.end(), 0.5);
}

}  // namespace rb
