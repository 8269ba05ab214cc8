#pragma once
#include "block/reader.h"
#include "shapes/outline.h"

namespace rb {

/// Takes `linear_spline`, `quadratic_spline`, `cubic_spline` or `bezier_spline` if it is next.
inline bool take_spline_kind(BlockReader& in, OutlineSpline& kind) {
    if (in.take_word("linear_spline")) {
        kind = OutlineSpline::linear;
    } else if (in.take_word("quadratic_spline")) {
        kind = OutlineSpline::quadratic;
    } else if (in.take_word("cubic_spline")) {
        kind = OutlineSpline::cubic;
    } else if (in.take_word("bezier_spline")) {
        kind = OutlineSpline::bezier;
    } else {
        return false;
    }
    return true;
}

}  // namespace rb
