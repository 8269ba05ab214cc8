#pragma once
#include "scene/pattern.h"

namespace rb {

// What the bounds of patterns share: formula.h and noise.h along lines.

/// A value in a range, which may jump.
inline IntervalSlope somewhere_in(double lo, double hi) { return IntervalSlope::jumping({lo, hi}); }
/// v - floor(v), from 0 to 1.
IntervalSlope fraction(const IntervalSlope& v);
/// triangle() of formula.h.
IntervalSlope triangle(const IntervalSlope& v);
/// faded() of formula.h for what is not negative.
IntervalSlope faded(const IntervalSlope& r);

/// clamp01() of formula.h.
inline IntervalSlope clamp01(const IntervalSlope& v) { return max(min(v, 1.0), IntervalSlope(0.0)); }

/// Of what a formula never makes negative, whatever the rounding of its bound.
inline IntervalSlope not_negative(IntervalSlope v) {
    v.value.lo = v.value.lo < 0.0 ? 0.0 : v.value.lo;
    return v;
}

/// Length of a vector. Its slope is no more than that of the vector, at 0 too.
IntervalSlope length(std::span<const IntervalSlope> v);

LinePlace scaled(const LinePlace& place, double factor);
LinePlace carried(const LinePlace& place, const Affine& map);

/// noise(). Of places that do not move only the range: a closer look costs as much as many values.
IntervalSlope bound_noise(const LinePlace& place, int generator);
/// sum_octaves() of octave_sums.h; `fold` gives what becomes of a noise value, which is not negative.
template <class Fold>
IntervalSlope bound_octaves(const LinePlace& place, const auto& octaves, int generator, const Fold& fold) {
    IntervalSlope sum(0.0);
    for (size_t i = 0; i < static_cast<size_t>(octaves.count); ++i)
        sum += octaves.weight[i] * fold(bound_noise(scaled(place, octaves.scale[i]), generator));
    return not_negative(sum);
}

}  // namespace rb
