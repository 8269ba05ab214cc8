#pragma once
#include "scene/shape.h"

namespace rb {

/// Segments of a full turn so that the chords of a circle stay within `tolerance` of it (algorithms:
/// sagitta).
int turn_segments(double radius, double tolerance);

/// The mesh of a profile turned about the local z axis, then carried by `place`. A profile point is (distance
/// from the axis, height); walking it upwards on the outside gives outward faces. Points on the axis become
/// one vertex. A `closed_profile` joins its last point to its first. `error` is left to the caller but for
/// single-precision rounding.
TriangleMesh revolve(const std::vector<Vec2>& profile, bool closed_profile, int segments,
                     const Affine& place);

/// A torus about the local z axis (major radius 0: a sphere) within `tolerance` after `place`.
struct Roundness {
    double major = 0;
    double minor = 1;
    double tolerance = 0;
};
TriangleMesh round_mesh(const Roundness& shape, const Affine& place);

}  // namespace rb
