#pragma once
#include "block/reader.h"
#include "shapes/outline.h"

namespace rb {

/// Takes `linear_spline`, `quadratic_spline`, `cubic_spline` or `bezier_spline` if it is next.
inline bool take_spline_kind(BlockReader& in, SplineKind& kind) {
    if (in.take_word("linear_spline")) {
        kind = SplineKind::linear;
    } else if (in.take_word("quadratic_spline")) {
        kind = SplineKind::quadratic;
    } else if (in.take_word("cubic_spline")) {
        kind = SplineKind::cubic;
    } else if (in.take_word("bezier_spline")) {
        kind = SplineKind::bezier;
    } else {
        return false;
    }
    return true;
}

}  // namespace rb
