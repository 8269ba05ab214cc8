// texture, texture_map, layers. Language spec 18.1.
#include "language/read_map.h"
#include "language/read_pattern.h"
#include "patterns/material_map.h"

#include <fmt/format.h>

namespace rb {

namespace {

void read_list(BlockReader& in, int list_size, Texture& texture) {
    const auto size = static_cast<size_t>(list_size);
    while (texture.map.size() < size && in.at_block("texture")) {
        TexturePtr child = read_texture(in.block("texture"), in.context());
        texture.map.push_back({static_cast<float>(texture.map.size()), std::move(child)});
    }
    while (texture.map.size() < size) {
        texture.map.push_back({static_cast<float>(texture.map.size()), in.context().default_texture});
    }
}

/// tiles { texture ... tile2 texture ... }: a checker whose first texture is on the odd cells.
void read_tiles(const Block& block, const ReadContext& context, Texture& texture) {
    BlockReader in(block, context);
    TexturePtr first;
    while (in.at_block("texture")) {
        const SourceRange at = in.where();
        first = layered(first, read_texture(in.block("texture"), context), at);
    }
    if (!in.take_word("tile2")) in.fail(fmt::format("Expected 'tile2', {} found instead", in.found()));
    TexturePtr second;
    while (in.at_block("texture")) {
        const SourceRange at = in.where();
        second = layered(second, read_texture(in.block("texture"), context), at);
    }
    in.finish();
    texture.map = {{0.0f, second ? second : context.default_texture},
                   {1.0f, first ? first : context.default_texture}};
    const PatternKind* checker = find_pattern("checker");
    Block words;
    words.where = block.where;
    words.keyword = "checker";
    BlockReader nothing(words, context);
    texture.pattern = checker->read(nothing);
    texture.modifiers.frequency = 0;
}

/// material_map { PICTURE texture ... }: a list of textures, chosen pixel by pixel.
void read_material_map(const Block& block, const ReadContext& context, Texture& texture) {
    BlockReader in(block, context);
    ImageField field = take_image_field(in);
    if (!in.at_block("texture")) in.fail(fmt::format("Expected 'texture', {} found instead", in.found()));
    while (in.at_block("texture")) {
        TexturePtr child = read_texture(in.block("texture"), context);
        texture.map.push_back({static_cast<float>(texture.map.size()), std::move(child)});
    }
    in.finish();
    texture.pattern = material_map_pattern(std::move(field), texture.map.size());
    texture.modifiers.frequency = 0;
}

void read_patterned(BlockReader& in, TextureLayers& layers) {
    Texture texture;
    texture.where = in.block_where();
    if (in.at_block("material_map")) {
        read_material_map(in.block("material_map"), in.context(), texture);
        Transform map;
        while (take_transformation(in, map)) {
        }
        layers = {transformed(texture, map)};
        return;
    }
    if (in.at_block("tiles")) {
        read_tiles(in.block("tiles"), in.context(), texture);
    } else {
        const TakenPattern taken = take_pattern(in, "texture", texture.modifiers);
        texture.pattern = taken.pattern;
        texture.average = taken.average;
        if (taken.kind && taken.kind->list_size > 0) read_list(in, taken.kind->list_size, texture);
        if (taken.list) {
            BlockReader list(*taken.list, in.context());
            read_list(list, 2, texture);
            list.finish();
        }
        while (!in.at_end()) {
            if (in.at_block("texture_map")) {
                texture.map = *read_texture_map(in.block("texture_map"), in.context(), texture.average);
            } else if (!take_parameter(in, texture.pattern)) {
                if (!take_modifier(in, texture.modifiers)) break;
            }
        }
        check_parameters(in, texture.pattern);
        if (texture.map.empty()) in.fail("Patterned texture must have texture_map.");
    }
    while (take_modifier(in, texture.modifiers)) {
    }
    layers = {std::move(texture)};
}

bool take_plain_identifier(BlockReader& in, Texture& top) {
    if (in.at_thing<PigmentPtr>()) {
        top.pigment = in.thing<PigmentPtr>();
    } else if (in.at_thing<NormalPtr>()) {
        top.normal = in.thing<NormalPtr>();
    } else if (in.at_thing<FinishPtr>()) {
        top.finish = in.thing<FinishPtr>();
    } else {
        return false;
    }
    return true;
}

bool take_plain_block(BlockReader& in, Texture& top) {
    const ReadContext& context = in.context();
    if (in.at_block("pigment")) {
        top.pigment = read_pigment(in.block("pigment"), context, top.pigment);
    } else if (in.at_block("normal")) {
        top.normal = read_normal(in.block("normal"), context, top.normal);
    } else if (in.at_block("finish")) {
        top.finish = read_finish(in.block("finish"), context, top.finish);
    } else {
        return false;
    }
    return true;
}

void set_no_bump_scale(TextureLayers& layers) {
    for (Texture& layer : layers) {
        if (!layer.normal) continue;
        auto normal = std::make_shared<Normal>(*layer.normal);
        normal->no_bump_scale = true;
        layer.normal = std::move(normal);
    }
}

/// What is mapped by surface coordinates is the only entry of a texture around it, whose transforms move
/// normals alone.
TextureLayers mapped_by_uv(TextureLayers layers) {
    Texture mapped;
    mapped.where = layers.front().where;
    mapped.average = true;
    mapped.uv_mapping = true;
    mapped.map = {{1.0f, std::make_shared<TextureLayers>(std::move(layers))}};
    return {std::move(mapped)};
}

}  // namespace

TextureMapPtr read_texture_map(const Block& block, const ReadContext& context, bool average) {
    return read_map<BlendMap<TexturePtr>>(block, context, [&](BlockReader& in, BlendMap<TexturePtr>& map) {
        const bool has_weight = in.at_number() || !average;
        const float position = has_weight ? static_cast<float>(in.number()) : 1.0f;
        auto layers = std::make_shared<TextureLayers>();
        if (in.at_block("texture")) {
            // `[0 texture{...} texture{...}]` is layered.
            TexturePtr all;
            while (in.at_block("texture")) {
                const SourceRange at = in.where();
                all = layered(all, read_texture(in.block("texture"), context), at);
            }
            map.push_back({position, std::move(all)});
            return;
        }
        *layers = *context.default_texture;
        read_texture_body(in, *layers);
        map.push_back({position, std::move(layers)});
    });
}

void read_texture_body(BlockReader& in, TextureLayers& layers) {
    bool changed = false;
    const bool by_uv = in.take_word("uv_mapping");
    if (in.at_thing<TexturePtr>()) {
        layers = *in.thing<TexturePtr>();
        changed = true;
    }
    const bool plain = !layers.back().is_patterned();
    while (!in.at_end()) {
        Transform map;
        if (plain && (take_plain_identifier(in, layers.back()) || take_plain_block(in, layers.back()))) {
            changed = true;
        } else if (take_transformation(in, map)) {
            for (Texture& layer : layers) layer = transformed(layer, map);
            changed = true;
        } else if (in.take_word("no_bump_scale")) {
            set_no_bump_scale(layers);
            changed = true;
        } else {
            break;
        }
    }
    if (!changed && (at_pattern(in) || in.at_block("tiles") || in.at_block("material_map"))) {
        read_patterned(in, layers);
    }
    if (by_uv) layers = mapped_by_uv(std::move(layers));
}

TexturePtr read_texture(const Block& block, const ReadContext& context) {
    BlockReader in(block, context);
    auto layers = std::make_shared<TextureLayers>(*context.default_texture);
    layers->back().where = block.where;
    read_texture_body(in, *layers);
    in.finish();
    return layers;
}

TexturePtr layered(const TexturePtr& lower, const TexturePtr& upper, SourceRange where) {
    if (!lower || lower->empty()) return upper;
    if (lower->back().is_patterned() || upper->front().is_patterned()) {
        throw SceneError(where, "Cannot layer over a patterned texture.");
    }
    auto layers = std::make_shared<TextureLayers>(*lower);
    layers->insert(layers->end(), upper->begin(), upper->end());
    return layers;
}

void edit_texture(const Block& block, const ReadContext& context, TexturePtr& layers) {
    auto edited = std::make_shared<TextureLayers>(layers ? *layers : *context.default_texture);
    if (edited->back().is_patterned()) {
        throw SceneError(block.where, "Cannot layer over a patterned texture.");
    }
    Texture& top = edited->back();
    if (block.keyword == "pigment") {
        top.pigment = read_pigment(block, context, top.pigment);
    } else if (block.keyword == "normal") {
        top.normal = read_normal(block, context, top.normal);
    } else {
        top.finish = read_finish(block, context, top.finish);
    }
    layers = std::move(edited);
}

bool take_texture(BlockReader& in, TexturePtr& layers) {
    const SourceRange at = in.where();
    if (in.at_block("texture")) {
        layers = layered(layers, read_texture(in.block("texture"), in.context()), at);
    } else if (in.at_block("pigment") || in.at_block("normal") || in.at_block("finish")) {
        edit_texture(in.block(in.peek_word()), in.context(), layers);
    } else {
        return false;
    }
    return true;
}

}  // namespace rb
