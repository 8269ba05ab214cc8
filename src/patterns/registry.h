#pragma once
#include "block/reader.h"
#include "scene/pattern.h"

#include <span>
#include <string_view>

namespace rb {

/// One pattern of the language. Adding a pattern: `patterns/<keyword>.cpp` with its PatternKind, one row in
/// patterns.def, one scene.
struct PatternKind {
    std::string_view keyword;
    /// Reads what must stand directly after the keyword (`gradient <v>`), the keyword itself is already
    /// taken; only a keyword that opens a block (`slope { ... }`) is left for it.
    PatternPtr (*read)(BlockReader& in);
    /// For patterns whose own parameters may stand among the modifiers (`brick_size`, `control0`): takes the
    /// next parameter and returns the changed pattern, or null if the next item is not one of its parameters.
    PatternPtr (*read_parameter)(BlockReader& in, const PatternPtr& so_far) = nullptr;
    /// What is wrong with the parameters together, once all have been taken; empty: nothing.
    std::string (*check)(const Pattern& pattern) = nullptr;
    /// Number of list entries for patterns with a list of colours or textures (checker 2, hexagon 3); 0:
    /// continuous.
    int list_size = 0;
    std::span<const Color> default_list = {};  ///< colours of missing list entries
    ColorMap (*default_map)() = nullptr;       ///< null: black to white
    Wave default_wave = Wave::ramp;
    float default_frequency = 1;
    std::string_view only_in = {};  ///< the one kind of statement that takes it; empty: all
    std::string_view example = {};
};

std::span<const PatternKind* const> all_patterns();

/// Null if the keyword is no pattern.
const PatternKind* find_pattern(std::string_view keyword);

}  // namespace rb
