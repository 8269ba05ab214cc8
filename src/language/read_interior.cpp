// interior, material, media, density. Language spec 18.9, 19.
#include "language/read.h"
#include "language/read_pattern.h"

#include <fmt/format.h>

namespace rb {

InteriorPtr read_interior(const Block& block, const ReadContext& context, const InteriorPtr& base) {
    BlockReader in(block, context);
    auto interior = std::make_shared<Interior>();
    if (base) *interior = *base;
    if (in.at_thing<InteriorPtr>()) *interior = *in.thing<InteriorPtr>();
    interior->where = block.where;
    while (!in.at_end()) {
        if (in.take_word("ior")) {
            interior->ior = in.number();
        } else if (in.take_word("dispersion")) {
            interior->dispersion = in.number();
        } else if (in.take_word("dispersion_samples")) {
            const SourceRange at = in.where();
            interior->dispersion_samples = in.integer();
            if (interior->dispersion_samples < 2) in.fail_at(at, "dispersion_samples must be at least 2.");
        } else if (in.take_word("caustics")) {
            interior->caustics = in.number();
        } else if (in.take_word("fade_distance")) {
            interior->fade_distance = in.number();
        } else if (in.take_word("fade_power")) {
            interior->fade_power = in.number();
        } else if (in.take_word("fade_color") || in.take_word("fade_colour")) {
            interior->fade_color = in.rgb_color();
        } else if (in.at_block("media")) {
            read_media(in.block("media"), context);
            interior->has_media = true;
        } else if (in.at_thing<ParsedOnlyPtr>() && in.peek().thing.index() > 0) {
            in.skip_item();
            interior->has_media = true;
        } else if (in.take_word("refraction")) {
            in.diagnostics().warning(in.where(), "Use of 'refraction' keyword is obsolete.");
            in.number();
        } else {
            break;
        }
    }
    in.finish();
    return interior;
}

std::shared_ptr<const Material> read_material(const Block& block, const ReadContext& context) {
    BlockReader in(block, context);
    auto material = std::make_shared<Material>();
    material->where = block.where;
    using Shared = std::shared_ptr<const Material>;
    if (in.at_thing<Shared>()) *material = *in.thing<Shared>();
    while (!in.at_end()) {
        Transform map;
        const SourceRange at = in.where();
        if (in.at_block("texture")) {
            material->texture = layered(material->texture, read_texture(in.block("texture"), context), at);
        } else if (in.at_block("interior_texture")) {
            material->interior_texture =
                layered(material->interior_texture, read_texture(in.block("interior_texture"), context), at);
        } else if (in.at_block("interior")) {
            material->interior = read_interior(in.block("interior"), context, material->interior);
        } else if (take_transformation(in, map)) {
            material->texture = transformed(material->texture, map);
        } else {
            break;
        }
    }
    in.finish();
    return material;
}

namespace {

ParsedOnlyPtr parsed_only(const Block& block) {
    auto only = std::make_shared<ParsedOnly>();
    only->keyword = block.keyword;
    only->where = block.where;
    return only;
}

bool take_known(BlockReader& in) {
    if (!in.at_thing<ParsedOnlyPtr>()) return false;
    in.skip_item();
    return true;
}

void read_scattering(const Block& block, const ReadContext& context) {
    BlockReader in(block, context);
    const SourceRange at = in.where();
    const int type = in.integer();
    if (type < 1 || type > 5) in.diagnostics().warning(at, "Unknown atmospheric scattering type.");
    in.rgb_color();
    while (in.at_word("eccentricity") || in.at_word("extinction")) {
        const SourceRange word = in.where();
        if (in.take_word("eccentricity") && type != 5) {
            in.fail_at(word, "Eccentricity cannot be used with this scattering type.");
        }
        in.take_word("extinction");
        in.number();
    }
    in.finish();
}

double checked(BlockReader& in, double low, const char* error) {
    const SourceRange at = in.where();
    const double value = in.number();
    if (!(value >= low)) in.fail_at(at, error);
    return value;
}

bool take_media_number(BlockReader& in) {
    if (in.take_word("method")) {
        const SourceRange at = in.where();
        const int method = in.integer();
        if (method < 1 || method > 3) in.fail_at(at, "Sample method choices are 1, 2, or 3.");
    } else if (in.take_word("intervals")) {
        checked(in, 1, "At least one interval is needed in media.");
    } else if (in.take_word("samples")) {
        const double least = checked(in, 1, "At least one sample per interval is needed in media.");
        if (in.at_number()) {
            checked(in, least, "Maximum number of samples per interval smaller than minimum number.");
        }
    } else if (in.take_word("aa_level")) {
        checked(in, 1, "aa_level in media must be at least one.");
    } else if (in.take_word("aa_threshold")) {
        const SourceRange at = in.where();
        if (!(in.number() > 0)) in.fail_at(at, "aa_threshold in media must be greater than zero.");
    } else if (in.take_word("confidence")) {
        const SourceRange at = in.where();
        const double value = in.number();
        if (!(value >= 0 && value < 1)) in.fail_at(at, "Illegal confidence value in media.");
    } else if (in.take_word("variance") || in.take_word("ratio") || in.take_word("jitter")) {
        in.number();
    } else if (in.take_word("absorption") || in.take_word("emission")) {
        in.rgb_color();
    } else if (in.take_word("collect")) {
        in.optional_switch();
    } else {
        return false;
    }
    return true;
}

void read_density_map(const Block& block, const ReadContext& context) {
    BlockReader in(block, context);
    if (take_known(in)) return in.finish();
    while (in.at_block("[")) {
        const Block& inner = in.block("[");
        BlockReader entry(inner, context);
        entry.number();
        // The rest is the content of a density.
        Block rest = inner;
        rest.items.erase(rest.items.begin());
        rest.keyword = "density";
        if (inner.items.front().count > 1) continue;
        read_density(rest, context);
    }
    in.finish();
}

}  // namespace

ParsedOnlyPtr read_density(const Block& block, const ReadContext& context) {
    BlockReader in(block, context);
    take_known(in);
    PatternModifiers modifiers;
    PatternPtr pattern;
    if (in.at_color()) {
        in.full_color();
    } else {
        pattern = take_pattern(in, "density", modifiers).pattern;
        while (in.at_block("density")) read_density(in.block("density"), context);
        while (in.at_color()) in.full_color();
    }
    while (!in.at_end()) {
        if (in.at_block("color_map") || in.at_block("colour_map")) {
            read_color_map(in.block(in.peek_word()), context);
        } else if (in.at_block("density_map")) {
            read_density_map(in.block("density_map"), context);
        } else if (!take_parameter(in, pattern) && !take_modifier(in, modifiers)) {
            break;
        }
    }
    check_parameters(in, pattern);
    in.finish();
    return parsed_only(block);
}

ParsedOnlyPtr read_media(const Block& block, const ReadContext& context) {
    BlockReader in(block, context);
    take_known(in);
    while (!in.at_end()) {
        Transform map;
        if (in.at_block("density")) {
            read_density(in.block("density"), context);
        } else if (in.at_block("scattering")) {
            read_scattering(in.block("scattering"), context);
        } else if (!take_media_number(in) && !take_transformation(in, map) && !take_known(in)) {
            break;
        }
    }
    in.finish();
    return parsed_only(block);
}

}  // namespace rb
