#pragma once
#include "math/bounds.h"

#include <algorithm>
#include <limits>

namespace rb {

/// Single precision box of an element, rounded outward.
struct BoxF {
    float lo[3];
    float hi[3];
};
BoxF rounded_outward(const Bounds& b);

inline constexpr BoxF empty_box_f{
    {std::numeric_limits<float>::infinity(), std::numeric_limits<float>::infinity(),
     std::numeric_limits<float>::infinity()},
    {-std::numeric_limits<float>::infinity(), -std::numeric_limits<float>::infinity(),
     -std::numeric_limits<float>::infinity()}};

inline void include(BoxF& box, const BoxF& other) {
    for (int i = 0; i < 3; ++i) {
        box.lo[i] = std::min(box.lo[i], other.lo[i]);
        box.hi[i] = std::max(box.hi[i], other.hi[i]);
    }
}

/// Half the surface, for the surface area heuristic.
inline double half_area(const BoxF& b) {
    const double x = static_cast<double>(b.hi[0]) - static_cast<double>(b.lo[0]);
    const double y = static_cast<double>(b.hi[1]) - static_cast<double>(b.lo[1]);
    const double z = static_cast<double>(b.hi[2]) - static_cast<double>(b.lo[2]);
    return x * y + y * z + z * x;
}

}  // namespace rb
