#pragma once

namespace rb {

// The tilings 25 to 27 of `tiling`, which have no period: a point is carried down from a large tile to the
// small one that holds it, as tiles are divided into smaller ones of the same kinds (Penrose 1974). x, z in
// the plane.

/// Pentagons, star, boat and diamond; six classes, of which three are pentagons.
double penrose_pentagons(double x, double z);
/// Kites and darts.
double penrose_kites(double x, double z);
/// Thick and thin rhombs.
double penrose_rhombs(double x, double z);

}  // namespace rb
