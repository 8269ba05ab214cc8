#pragma once
#include "patterns/blend.h"
#include "scene/texture.h"

#include <memory>
#include <vector>

namespace rb {

/// A pigment compiled for batches: warps, pattern, map and children as a tree of steps that each run over
/// all points (manual 3.4.6.1).
class PigmentProgram {
public:
    /// With `quick` the quick_color stands for the whole pigment where one was given.
    PigmentProgram(const Pigment& pigment, const PatternSettings& settings, bool quick = false);

    bool is_constant() const { return kind_ == Kind::constant; }
    const Color& constant() const { return color_; }
    /// True if some colour of it has filter or transmit.
    bool passes_light() const;
    /// True if evaluate() needs PatternSamples::surface.
    bool needs_surface() const;

    void evaluate(const PatternSamples& samples, std::span<Color> out) const;

private:
    enum class Kind { constant, colors, children, average };
    void use_map(const Pigment& pigment, const PatternSettings& settings);
    void set_colors(const ColorMap& map);
    void evaluate_colors(const PatternSamples& carried, std::span<Color> out) const;
    void evaluate_children(const PatternSamples& carried, std::span<Color> out) const;
    void evaluate_average(const PatternSamples& carried, std::span<Color> out) const;

    Kind kind_ = Kind::constant;
    bool uv_mapping_ = false;
    Color color_;
    PatternField field_;
    MapPositions positions_;
    std::vector<Color> colors_;
    std::vector<PigmentProgram> children_;
};

}  // namespace rb
