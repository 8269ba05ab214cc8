#pragma once
#include "math/vec.h"

#include <array>
#include <cstdint>
#include <vector>

namespace rb {

/// Triangles that cover what closed polygons enclose by the even-odd rule. The polygons may touch and cross
/// themselves and each other. Coordinates are single precision numbers.
struct RegionMesh {
    std::vector<Vec2> points;
    std::vector<std::array<uint32_t, 3>> triangles;  ///< counter-clockwise
    std::vector<std::array<uint32_t, 2>> border;     ///< edges with the region on their left
};

/// Cuts the region into strips at every vertex and intersection, so that neighbours share whole edges.
RegionMesh triangulate(const std::vector<std::vector<Vec2>>& loops);

}  // namespace rb
