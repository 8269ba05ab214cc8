// media, density, density_map. Language spec 19.
#include "language/read_map.h"
#include "language/read_pattern.h"

#include <fmt/format.h>

namespace rb {

namespace {

Scattering read_scattering(const Block& block, const ReadContext& context) {
    BlockReader in(block, context);
    Scattering scattering;
    const SourceRange at = in.where();
    scattering.type = in.integer();
    if (scattering.type < 1 || scattering.type > 5) {
        in.diagnostics().warning(at, "Unknown atmospheric scattering type.");
        scattering.type = 1;
    }
    scattering.color = in.rgb_color();
    while (in.at_word("eccentricity") || in.at_word("extinction")) {
        const SourceRange word = in.where();
        if (in.take_word("eccentricity")) {
            if (scattering.type != 5) {
                in.fail_at(word, "Eccentricity cannot be used with this scattering type.");
            }
            scattering.eccentricity = in.number();
        } else if (in.take_word("extinction")) {
            scattering.extinction = static_cast<float>(in.number());
        }
    }
    in.finish();
    return scattering;
}

int whole(BlockReader& in, int low, const char* error) {
    const SourceRange at = in.where();
    const int value = in.integer();
    if (value < low) in.fail_at(at, error);
    return value;
}

/// What says how a ray's way is sampled.
bool take_sampling(BlockReader& in, Media& media) {
    if (in.take_word("method")) {
        const SourceRange at = in.where();
        media.method = in.integer();
        if (media.method < 1 || media.method > 3) in.fail_at(at, "Sample method choices are 1, 2, or 3.");
    } else if (in.take_word("intervals")) {
        media.intervals = whole(in, 1, "At least one interval is needed in media.");
    } else if (in.take_word("samples")) {
        media.min_samples = whole(in, 1, "At least one sample per interval is needed in media.");
        media.max_samples = media.min_samples;
        if (in.at_number()) {
            media.max_samples = whole(in, media.min_samples,
                                      "Maximum number of samples per interval smaller than minimum number.");
        }
    } else if (in.take_word("aa_level")) {
        media.aa_level = whole(in, 1, "aa_level in media must be at least one.");
    } else if (in.take_word("aa_threshold")) {
        const SourceRange at = in.where();
        media.aa_threshold = in.number();
        if (!(media.aa_threshold > 0)) in.fail_at(at, "aa_threshold in media must be greater than zero.");
    } else if (in.take_word("confidence")) {
        const SourceRange at = in.where();
        media.confidence = in.number();
        if (!(media.confidence >= 0 && media.confidence < 1)) {
            in.fail_at(at, "Illegal confidence value in media.");
        }
    } else if (in.take_word("variance")) {
        media.variance = in.number();
    } else if (in.take_word("ratio")) {
        media.ratio = in.number();
    } else if (in.take_word("jitter")) {
        media.jitter = in.number();
    } else {
        return false;
    }
    return true;
}

bool take_medium(BlockReader& in, Media& media) {
    if (in.take_word("absorption")) {
        media.absorption = in.rgb_color();
    } else if (in.take_word("emission")) {
        media.emission = in.rgb_color();
    } else if (in.at_block("scattering")) {
        media.scattering = read_scattering(in.block("scattering"), in.context());
    } else if (in.take_word("collect")) {
        media.collect = in.optional_switch();
    } else {
        return false;
    }
    return true;
}

/// Densities behind a list pattern, which has none of its own.
void read_list(BlockReader& in, const PatternKind& kind, Density& density) {
    BlendMap<PigmentPtr> list;
    const auto size = static_cast<size_t>(kind.list_size);
    while (list.size() < size && in.at_block("density")) {
        DensityPtr child = read_density(in.block("density"), in.context());
        list.push_back({static_cast<float>(list.size()), std::move(child)});
    }
    if (list.size() < size) in.fail(fmt::format("Expected 'density', {} found instead", in.found()));
    density.map = std::move(list);
}

void read_kind(BlockReader& in, Density& density) {
    if (in.at_color()) {
        const SourceRange where = density.where;
        density = Density{};
        density.where = where;
        density.source = in.full_color();
        return;
    }
    const TakenPattern taken = take_pattern(in, "density", density.modifiers);
    if (!taken.taken) return;
    density.average = taken.average;
    density.source = std::monostate{};
    density.map = std::monostate{};
    if (taken.pattern) density.source = taken.pattern;
    if (taken.kind && taken.kind->list_size > 0) read_list(in, *taken.kind, density);
    if (taken.list) {
        BlockReader list(*taken.list, in.context());
        PatternKind two;
        two.list_size = 2;
        read_list(list, two, density);
        list.finish();
    }
}

bool takes_map(const Density& density) {
    const auto* pattern = std::get_if<PatternPtr>(&density.source);
    if (density.average || !pattern) return density.average;
    const PatternKind* kind = find_pattern((*pattern)->keyword());
    return !(kind && kind->list_size > 0);
}

bool take_map(BlockReader& in, Density& density) {
    if (in.at_block("color_map") || in.at_block("colour_map")) {
        if (!takes_map(density) || density.average) in.fail("Cannot use color_map with this pattern type.");
        density.map = *read_color_map(in.block(in.peek_word()), in.context());
        return true;
    }
    if (in.at_block("density_map")) {
        if (!takes_map(density)) in.fail("Keyword 'density_map' cannot be used with this density type.");
        density.map = read_density_map(in.block("density_map"), in.context())->entries;
        return true;
    }
    return false;
}

void read_density_body(BlockReader& in, Density& density) {
    if (in.at_thing<DensityPtr>()) density = *in.thing<DensityPtr>();
    read_kind(in, density);
    while (!in.at_end()) {
        if (take_map(in, density)) continue;
        if (auto* pattern = std::get_if<PatternPtr>(&density.source); pattern && take_parameter(in, *pattern))
            continue;
        if (!take_modifier(in, density.modifiers)) break;
    }
    if (const auto* pattern = std::get_if<PatternPtr>(&density.source)) check_parameters(in, *pattern);
    if (density.average && std::holds_alternative<std::monostate>(density.map)) {
        in.fail("Average must have map.");
    }
}

/// Media without an identifier begin with these. Before 3.5: spec shading 11.1.
Media default_media(const ReadContext& context) {
    Media media;
    if (context.language_version < 350) {
        media.method = 1;
        media.intervals = 10;
        media.min_samples = media.max_samples = 1;
    }
    return media;
}

}  // namespace

DensityMapPtr read_density_map(const Block& block, const ReadContext& context) {
    BlockReader known(block, context);
    if (known.at_thing<DensityMapPtr>()) {
        DensityMapPtr map = known.thing<DensityMapPtr>();
        known.finish();
        return map;
    }
    auto map = std::make_shared<DensityMap>();
    map->entries =
        *read_map<BlendMap<PigmentPtr>>(block, context, [](BlockReader& in, BlendMap<PigmentPtr>& entries) {
            const auto position = static_cast<float>(in.number());
            auto child = std::make_shared<Density>();
            child->where = in.block_where();
            read_density_body(in, *child);
            entries.push_back({position, std::move(child)});
        });
    return map;
}

DensityPtr read_density(const Block& block, const ReadContext& context) {
    BlockReader in(block, context);
    auto density = std::make_shared<Density>();
    density->where = block.where;
    read_density_body(in, *density);
    in.finish();
    return density;
}

MediaPtr read_media(const Block& block, const ReadContext& context) {
    BlockReader in(block, context);
    auto media = std::make_shared<Media>(default_media(context));
    if (in.at_thing<MediaPtr>()) *media = *in.thing<MediaPtr>();
    media->where = block.where;
    while (!in.at_end()) {
        Transform map;
        if (in.at_block("density")) {
            media->densities.push_back(read_density(in.block("density"), context));
        } else if (take_transformation(in, map)) {
            media = std::make_shared<Media>(*transformed(MediaPtr(media), map));
        } else if (!take_medium(in, *media) && !take_sampling(in, *media)) {
            break;
        }
    }
    in.finish();
    return media;
}

}  // namespace rb
