#pragma once
#include "scene/texture.h"

#include <string>

namespace rb {

struct WrittenPattern {
    PatternPtr pattern;
    PatternModifiers modifiers;
};

/// A pattern with its modifiers, as it stands in `pigment { ... }`.
WrittenPattern pattern_of(const std::string& text);

/// `normal { text }`.
Normal written_normal(const std::string& text);

}  // namespace rb
