#pragma once
#include "scene/pattern.h"

#include <span>

namespace rb {

/// What all patterns of a scene share while rendering.
struct PatternSettings {
    int noise_generator = 2;
    int number_of_waves = 10;
};

/// A batch of points to evaluate, with the surface they lie on where there is one.
struct PatternSamples {
    std::span<const Vec3> points;
    const SurfaceSamples* surface = nullptr;
    std::span<const uint32_t> rows;  ///< as PatternContext::rows; used only with a surface

    PatternSamples at(std::span<const Vec3> other_points) const { return {other_points, surface, rows}; }
};

/// A pattern with its warps, frequency, phase and wave, ready to run over batches (manual 3.4.7).
class PatternField {
public:
    PatternField() = default;
    /// Without a pattern it only carries points (`average`).
    PatternField(PatternPtr pattern, const PatternModifiers& modifiers, const PatternSettings& settings);

    /// True if `carry` changes points.
    bool warps_points() const { return warp_count_ > 0; }
    /// Carries points through the warps, in place.
    void carry(std::span<Vec3> points) const;
    /// Values with frequency, phase and wave at points that have been carried.
    void values(const PatternSamples& carried, std::span<double> out) const;
    /// Holds the values along a line of points that have not been carried yet.
    IntervalSlope bound(LinePlace place) const;
    /// Pattern::perturb at points that have been carried.
    bool perturb(const PatternSamples& carried, float amount, std::span<Vec3> normals) const;

    /// Pattern::colors of patterns that have them.
    bool has_colors() const { return pattern_ && pattern_->has_colors(); }
    bool passes_light() const { return pattern_ && pattern_->passes_light(); }
    void colors(const PatternSamples& carried, std::span<Color> out) const {
        pattern_->colors(carried.points, out);
    }

    SurfaceNeed surface_need() const { return pattern_ ? pattern_->surface_need() : SurfaceNeed::none; }
    /// The transformations of the chain, which normals must be carried through.
    const PatternModifiers& modifiers() const { return modifiers_; }

private:
    PatternContext context(const PatternSamples& samples) const;
    void shape(std::span<double> values) const;
    IntervalSlope shaped(IntervalSlope v) const;

    PatternPtr pattern_;
    PatternModifiers modifiers_;
    PatternSettings settings_;
    size_t warp_count_ = 0;  ///< how many elements of the chain move points
};

/// Where a value falls in a map: `(1 - t) * first + t * second`.
struct MapPlace {
    uint32_t first = 0;
    uint32_t second = 0;
    double t = 0;
};

/// Finds a value among positions in written order, which need not be sorted (manual 3.4.6.1.3).
MapPlace find_in_map(std::span<const float> positions, bool sorted, double value);

}  // namespace rb
