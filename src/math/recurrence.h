#pragma once
#include <cmath>

namespace rb {

inline double fraction(double v) { return v - std::floor(v); }

/// Step of the additive recurrence that spreads points most evenly over a unit interval: the golden ratio.
inline constexpr double golden_step = 0.6180339887498949;

}  // namespace rb
