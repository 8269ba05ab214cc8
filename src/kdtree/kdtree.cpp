#include "kdtree/kdtree.h"

#include <algorithm>

namespace rb {

BoxF rounded_outward(const Bounds& b) {
    BoxF out{};
    constexpr float inf = std::numeric_limits<float>::infinity();
    for (int i = 0; i < 3; ++i) {
        auto lo = static_cast<float>(b.lo[i]);
        auto hi = static_cast<float>(b.hi[i]);
        if (static_cast<double>(lo) > b.lo[i]) lo = std::nextafter(lo, -inf);
        if (static_cast<double>(hi) < b.hi[i]) hi = std::nextafter(hi, inf);
        out.lo[i] = lo;
        out.hi[i] = hi;
    }
    return out;
}

}  // namespace rb
