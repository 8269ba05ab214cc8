#pragma once
#include "math/vec.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace rb {

/// A point of a plane curve in pieces: where it is, and how far from the point that asked.
struct CurveContact {
    uint32_t piece = 0;
    double w = 0;  ///< parameter on the piece, 0..1
    double distance = 0;
};

/// The foot of `p` on a piece by Gauss' and Newton's method, from the parameter w whose point is `at`. For a
/// `p` on the curve, or so near that the second derivative does not matter. `slope_at(w, at)`: derivative of
/// the point by the parameter.
template <class Piece, class Slope>
CurveContact settle_on_curve(const Piece& piece, uint32_t index, const Vec2& p, double w, Vec2 at,
                             Slope&& slope_at) {
    CurveContact best{index, w, glm::length(at - p)};
    double before = w;
    for (int i = 0; i < 20; ++i) {
        const Vec2 along = slope_at(w, at);
        const double length = glm::dot(along, along);
        const bool tells = length > 0.0 && std::isfinite(length);
        if (!tells && w == before) break;
        // Where the curve stands still (at an end on the axis) the step was too long.
        const double next =
            tells ? std::clamp(w + glm::dot(p - at, along) / length, 0.0, 1.0) : 0.5 * (w + before);
        if (next == w) break;
        // The steps shrink quadratically.
        constexpr double settled = 1e-9;
        const bool last = std::abs(next - w) <= settled;
        if (tells) before = w;
        w = next;
        at = piece.at(w);
        const double d = glm::length(at - p);
        if (d < best.distance) best = {index, w, d};
        if (last) break;
    }
    return best;
}

}  // namespace rb
