#pragma once
#include "language/read.h"
#include "patterns/registry.h"

#include <string>

namespace rb {

/// A pattern that the renderer does not draw yet: half everywhere. Reported when it reaches the scene.
class UnsupportedPattern final : public Pattern {
public:
    UnsupportedPattern(std::string keyword, SourceRange at) : where(at), keyword_(std::move(keyword)) {}
    std::string_view keyword() const override { return keyword_; }
    void evaluate(const PatternContext&, std::span<const Vec3>, std::span<double> values) const override;

    SourceRange where;

private:
    std::string keyword_;
};

/// `function { ... }` as a pattern.
PatternPtr function_pattern(const FunctionPtr& function);
/// `pigment_pattern { ... }`: the pigment's grey.
PatternPtr pigment_pattern(const PigmentPtr& pigment, const GlobalSettings& settings);

/// What stood where a pattern may stand.
struct TakenPattern {
    bool taken = false;
    bool average = false;
    PatternPtr pattern;
    const PatternKind* kind = nullptr;
    std::shared_ptr<const Block> list;  ///< of `object { OBJECT list }`: the list alone
};

/// Takes a pattern's keyword and what belongs to it, and sets its default wave and frequency. `statement` is
/// what the pattern is for: "pigment", "normal", "texture", ...
TakenPattern take_pattern(BlockReader& in, std::string_view statement, PatternModifiers& modifiers);
/// A pattern keyword, registered or not.
bool at_pattern(const BlockReader& in);

/// Takes a modifier that any pattern has (turbulence, frequency, warp, transformations, ...).
bool take_modifier(BlockReader& in, PatternModifiers& modifiers);
/// Takes a parameter of the pattern itself.
bool take_parameter(BlockReader& in, PatternPtr& pattern);
/// To be called behind the last parameter: parameters that do not go together are an error.
void check_parameters(const BlockReader& in, const PatternPtr& pattern);

}  // namespace rb
