#pragma once
#include "block/block.h"
#include "scene/texture.h"

#include <string>
#include <vector>

namespace rb {

/// `text` as a block of words, numbers, vectors and nested blocks: enough of the language to try patterns
/// without the front end.
Block block_of(const std::string& text);

struct WrittenPattern {
    PatternPtr pattern;
    PatternModifiers modifiers;
    float amount = 0.5f;
    float accuracy = 0.02f;
    bool no_bump_scale = false;
};

/// Reads a pattern with its modifiers, as it would stand in `pattern { ... }` or `normal { ... }`.
WrittenPattern pattern_of(const std::string& text);

}  // namespace rb
