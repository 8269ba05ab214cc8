#pragma once
#include "language/words.h"

#include <optional>

namespace rb {

/// Truncation through a 32-bit integer, as the language does it: -2147483648 where it does not fit (spec:
/// language 8.2).
double whole_part(double value);

/// The float functions of one argument as C computes them, domain errors included; empty for other words.
/// Scenes check the domain first, user functions do not (spec: language 14.2).
std::optional<double> float_function(Keyword word, double a);

/// The same for `atan2`, `mod`, `pow` and `div`.
std::optional<double> float_function(Keyword word, double a, double b);

}  // namespace rb
