// pigment, color_map, pigment_map. Language spec 18.2, 18.4.
#include "language/read_map.h"
#include "language/read_pattern.h"

#include <array>
#include <span>

#include <fmt/format.h>

namespace rb {

namespace {

Color entry_color(BlockReader& in) {
    if (in.at_number() && in.peek().terms != 5) {
        in.fail("Expected 'color', < found instead");
    }
    if (!in.at_color()) in.fail(fmt::format("Expected 'color', {} found instead", in.found()));
    return in.full_color();
}

/// Equal neighbours count once.
void add_entry(ColorMap& map, float position, const Color& color) {
    if (!map.empty() && map.back().position == position && map.back().value == color) return;
    map.push_back({position, color});
}

void read_color_entry(BlockReader& in, ColorMap& map) {
    const auto first = static_cast<float>(in.number());
    if (in.at_number() && in.peek().terms == 1) {
        const auto second = static_cast<float>(in.number());
        add_entry(map, first, in.full_color());
        add_entry(map, second, in.full_color());
    } else {
        add_entry(map, first, entry_color(in));
    }
}

float entry_position(BlockReader& in, bool average) {
    if (average && !(in.at_number() && in.peek().terms == 1)) return 1;
    return static_cast<float>(in.number());
}

/// What follows a list pattern: colours or pigments, as the first one decides.
void read_list(BlockReader& in, size_t size, std::span<const Color> defaults, Pigment& pigment) {
    if (in.at_block("pigment")) {
        BlendMap<PigmentPtr> list;
        const PigmentPtr& base = in.context().default_texture->front().pigment;
        while (list.size() < size && in.at_block("pigment")) {
            PigmentPtr child = read_pigment(in.block("pigment"), in.context(), base);
            list.push_back({static_cast<float>(list.size()), std::move(child)});
        }
        while (list.size() < size) list.push_back({static_cast<float>(list.size()), base});
        pigment.map = std::move(list);
        return;
    }
    if (!in.at_color()) return;
    ColorMap list;
    while (list.size() < size && in.at_color())
        list.push_back({static_cast<float>(list.size()), in.full_color()});
    while (list.size() < size && list.size() < defaults.size()) {
        list.push_back({static_cast<float>(list.size()), defaults[list.size()]});
    }
    pigment.map = std::move(list);
}

bool takes_color_map(const Pigment& pigment) {
    if (pigment.average) return false;
    const auto* pattern = std::get_if<PatternPtr>(&pigment.source);
    if (!pattern || !*pattern) return false;
    const PatternKind* kind = find_pattern((*pattern)->keyword());
    return !(kind && kind->list_size > 0) && !(*pattern)->has_colors();
}

bool take_map(BlockReader& in, Pigment& pigment) {
    if (in.at_block("color_map") || in.at_block("colour_map")) {
        if (!takes_color_map(pigment)) in.fail("Cannot use color_map with this pattern type.");
        pigment.map = *read_color_map(in.block(in.peek_word()), in.context());
        return true;
    }
    if (in.at_block("pigment_map")) {
        if (!takes_color_map(pigment) && !pigment.average) {
            in.fail("Keyword 'pigment_map' cannot be used with this pigment type.");
        }
        pigment.map = *read_pigment_map(in.block("pigment_map"), in.context(), pigment.average);
        return true;
    }
    return false;
}

void read_kind(BlockReader& in, Pigment& pigment) {
    if (in.at_color()) {
        pigment.source = in.full_color();
        pigment.map = std::monostate{};
        pigment.average = false;
        pigment.modifiers.warps.clear();
        return;
    }
    const TakenPattern taken = take_pattern(in, "pigment", pigment.modifiers);
    if (!taken.taken) return;
    pigment.average = taken.average;
    pigment.source = std::monostate{};
    if (taken.pattern) pigment.source = taken.pattern;
    if (taken.kind && taken.kind->list_size > 0) {
        pigment.map = std::monostate{};
        read_list(in, static_cast<size_t>(taken.kind->list_size), taken.kind->default_list, pigment);
    }
    if (taken.list) {
        constexpr std::array<Color, 2> blue_green{Color{0, 0, 1, 0, 0}, Color{0, 1, 0, 0, 0}};
        BlockReader list(*taken.list, in.context());
        pigment.map = ColorMap{{0.0f, blue_green[0]}, {1.0f, blue_green[1]}};
        read_list(list, 2, blue_green, pigment);
        list.finish();
    }
}

}  // namespace

std::shared_ptr<const ColorMap> read_color_map(const Block& block, const ReadContext& context) {
    return read_map<ColorMap>(block, context, read_color_entry);
}

PigmentMapPtr read_pigment_map(const Block& block, const ReadContext& context, bool average) {
    return read_map<BlendMap<PigmentPtr>>(block, context, [&](BlockReader& in, BlendMap<PigmentPtr>& map) {
        const float position = entry_position(in, average);
        auto child = std::make_shared<Pigment>(*context.default_texture->front().pigment);
        child->where = in.block_where();
        read_pigment_body(in, *child);
        map.push_back({position, std::move(child)});
    });
}

void read_pigment_body(BlockReader& in, Pigment& pigment) {
    const bool had_nothing = std::holds_alternative<std::monostate>(pigment.source);
    if (in.at_thing<PigmentPtr>()) pigment = *in.thing<PigmentPtr>();
    if (in.take_word("uv_mapping")) pigment.uv_mapping = true;
    read_kind(in, pigment);
    while (!in.at_end()) {
        if (take_map(in, pigment)) continue;
        if (in.take_word("quick_color") || in.take_word("quick_colour")) {
            pigment.quick_color = in.full_color();
            continue;
        }
        if (auto* pattern = std::get_if<PatternPtr>(&pigment.source)) {
            PatternPtr changed = *pattern;
            if (take_parameter(in, changed)) {
                pigment.source = std::move(changed);
                continue;
            }
        }
        if (!take_modifier(in, pigment.modifiers)) break;
    }
    if (const auto* pattern = std::get_if<PatternPtr>(&pigment.source)) check_parameters(in, *pattern);
    if (pigment.average && std::holds_alternative<std::monostate>(pigment.map)) {
        in.fail("Average must have map.");
    }
    if (had_nothing && !pigment.average && std::holds_alternative<std::monostate>(pigment.source)) {
        in.diagnostics().warning(in.block_where(), "Pigment type unspecified or not 1st item.");
    }
}

PigmentPtr read_pigment(const Block& block, const ReadContext& context, const PigmentPtr& base) {
    BlockReader in(block, context);
    auto pigment = std::make_shared<Pigment>();
    if (base) *pigment = *base;
    pigment->where = block.where;
    read_pigment_body(in, *pigment);
    in.finish();
    return pigment;
}

}  // namespace rb
