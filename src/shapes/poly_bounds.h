#pragma once
#include "math/bounds.h"

#include <span>

namespace rb {

/// A box around where a polynomial in x, y, z (coefficients as of poly_size) is not above 0; everything() if
/// that is not finite, or not seen to be.
Bounds poly_bounds(int order, std::span<const double> coefficients);

}  // namespace rb
