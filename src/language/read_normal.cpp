// normal, normal_map, slope_map. Language spec 18.2, 18.4.
#include "language/read_map.h"
#include "language/read_pattern.h"

namespace rb {

namespace {

void read_list(BlockReader& in, size_t size, Normal& normal) {
    if (!in.at_block("normal")) return;
    BlendMap<NormalPtr> list;
    const NormalPtr base = in.context().default_texture->front().normal;
    while (list.size() < size && in.at_block("normal")) {
        NormalPtr child = read_normal(in.block("normal"), in.context(), base);
        list.push_back({static_cast<float>(list.size()), std::move(child)});
    }
    const NormalPtr rest = base ? base : std::make_shared<const Normal>();
    while (list.size() < size) list.push_back({static_cast<float>(list.size()), rest});
    normal.map = std::move(list);
}

bool take_map(BlockReader& in, Normal& normal) {
    if (in.at_block("slope_map")) {
        normal.map = *read_slope_map(in.block("slope_map"), in.context());
        return true;
    }
    if (in.at_block("normal_map")) {
        normal.map = *read_normal_map(in.block("normal_map"), in.context(), normal.average);
        return true;
    }
    return false;
}

bool take_number(BlockReader& in, Normal& normal) {
    if (in.take_word("bump_size")) {
        normal.amount = static_cast<float>(in.number());
    } else if (in.take_word("accuracy")) {
        normal.accuracy = static_cast<float>(in.positive("accuracy"));
    } else if (in.take_word("no_bump_scale")) {
        normal.no_bump_scale = true;
    } else {
        return false;
    }
    return true;
}

}  // namespace

SlopeMapPtr read_slope_map(const Block& block, const ReadContext& context) {
    return read_map<BlendMap<HeightSlope>>(block, context, [](BlockReader& in, BlendMap<HeightSlope>& map) {
        const auto position = static_cast<float>(in.number());
        const Vec2 v = in.vec2();
        map.push_back({position, {static_cast<float>(v.x), static_cast<float>(v.y)}});
    });
}

NormalMapPtr read_normal_map(const Block& block, const ReadContext& context, bool average) {
    return read_map<BlendMap<NormalPtr>>(block, context, [&](BlockReader& in, BlendMap<NormalPtr>& map) {
        const bool has_weight = in.at_number() || !average;
        const float position = has_weight ? static_cast<float>(in.number()) : 1.0f;
        auto child = std::make_shared<Normal>();
        if (const NormalPtr base = context.default_texture->front().normal) *child = *base;
        child->where = in.block_where();
        read_normal_body(in, *child);
        map.push_back({position, std::move(child)});
    });
}

void read_normal_body(BlockReader& in, Normal& normal) {
    if (in.at_thing<NormalPtr>()) normal = *in.thing<NormalPtr>();
    if (in.take_word("uv_mapping")) normal.uv_mapping = true;
    const TakenPattern taken = take_pattern(in, "normal", normal.modifiers);
    if (taken.taken) {
        normal.average = taken.average;
        normal.pattern = taken.pattern;
        if (taken.kind && taken.kind->list_size > 0) {
            normal.map = std::monostate{};
            read_list(in, static_cast<size_t>(taken.kind->list_size), normal);
        }
        if (taken.list) {
            BlockReader list(*taken.list, in.context());
            read_list(list, 2, normal);
            list.finish();
        }
    }
    if (in.at_number()) normal.amount = static_cast<float>(in.number());
    while (!in.at_end()) {
        if (take_map(in, normal) || take_number(in, normal)) continue;
        if (take_parameter(in, normal.pattern)) continue;
        if (!take_modifier(in, normal.modifiers)) break;
    }
    check_parameters(in, normal.pattern);
    if (normal.average && std::holds_alternative<std::monostate>(normal.map))
        in.fail("Average must have map.");
}

NormalPtr read_normal(const Block& block, const ReadContext& context, const NormalPtr& base) {
    BlockReader in(block, context);
    auto normal = std::make_shared<Normal>();
    if (base) *normal = *base;
    normal->where = block.where;
    read_normal_body(in, *normal);
    in.finish();
    return normal;
}

}  // namespace rb
