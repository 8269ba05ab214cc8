#pragma once
#include "patterns/blend.h"
#include "scene/texture.h"

#include <memory>

namespace rb {

/// A pigment compiled for batches: warps, pattern, map and children as a tree of steps that each run over
/// all points (manual 3.4.6.1). A plain colour, which most are, has no such tree.
class PigmentProgram {
public:
    /// With `quick` the quick_color stands for the whole pigment where one was given.
    PigmentProgram(const Pigment& pigment, const PatternSettings& settings, bool quick = false);

    bool is_constant() const { return map_ == nullptr; }
    const Color& constant() const { return color_; }
    /// True if some colour of it has filter or transmit.
    bool passes_light() const;
    /// What evaluate() asks of PatternSamples::surface.
    SurfaceNeed surface_need() const;

    void evaluate(const PatternSamples& samples, std::span<Color> out) const;
    /// Holds one term of the colour (0: red ... 4: transmit) along a line.
    IntervalSlope bound(const LinePlace& place, int term) const;
    /// Holds it everywhere.
    Interval range(int term) const;

private:
    struct Map;
    Color color_;  ///< without a map
    std::shared_ptr<const Map> map_;
};

}  // namespace rb
