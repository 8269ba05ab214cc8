#include "patterns/registry.h"

#include <array>

namespace rb {

namespace patterns {
#define RB_PATTERN(name) extern const PatternKind name;
#include "patterns/patterns.def"
#undef RB_PATTERN
}  // namespace patterns

std::span<const PatternKind* const> all_patterns() {
    static constexpr std::array kinds{
#define RB_PATTERN(name) &patterns::name,
#include "patterns/patterns.def"
#undef RB_PATTERN
    };
    return kinds;
}

const PatternKind* find_pattern(std::string_view keyword) {
    for (const PatternKind* kind : all_patterns()) {
        if (kind->keyword == keyword) return kind;
    }
    return nullptr;
}

}  // namespace rb
