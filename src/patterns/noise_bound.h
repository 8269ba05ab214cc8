#pragma once
#include "math/bounds.h"
#include "math/interval.h"

#include <array>

namespace rb {

/// What noise() does within a box.
struct NoiseBound {
    Interval value;
    std::array<Interval, 3> slopes;  ///< every difference quotient along each axis
};

/// `box`: finite, its coordinates below 2e9. Over more than a few cells of the lattice only the range is
/// known.
NoiseBound bound_noise(const Bounds& box, int generator);

}  // namespace rb
