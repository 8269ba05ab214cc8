#pragma once
#include "block/reader.h"

#include <memory>

namespace rb {

/// A `*_map { [...] [...] }` whose entries `read_entry` adds, or the map of an identifier.
template <class Map, class ReadEntry>
std::shared_ptr<const Map> read_map(const Block& block, const ReadContext& context, ReadEntry read_entry) {
    using Shared = std::shared_ptr<const Map>;
    constexpr size_t most_entries = 256;
    BlockReader in(block, context);
    if (in.at_thing<Shared>()) {
        Shared known = in.thing<Shared>();
        in.finish();
        return known;
    }
    auto map = std::make_shared<Map>();
    while (in.at_block("[")) {
        BlockReader entry(in.block("["), context);
        read_entry(entry, *map);
        entry.finish();
        if (map->size() > most_entries)
            in.fail("Too many entries in map. The maximum is 256 entries per map.");
    }
    in.finish();
    if (map->empty()) {
        const bool colors = block.keyword == "color_map" || block.keyword == "colour_map";
        in.fail_at(block.where, colors ? "Must have at least one color in color map."
                                       : "Must have at least one entry in map.");
    }
    return map;
}

}  // namespace rb
