#pragma once
#include "block/reader.h"

#include <memory>

#include <fmt/format.h>

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
        if (map->size() > most_entries) in.fail("Too many entries in a map.");
    }
    in.finish();
    if (map->empty())
        in.fail_at(block.where, fmt::format("Must have at least one entry in '{}'.", block.keyword));
    return map;
}

}  // namespace rb
