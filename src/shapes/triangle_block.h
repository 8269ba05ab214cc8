#pragma once
#include "math/vec.h"

#include <cstdint>

namespace rb {

/// Eight triangles, coordinate by coordinate: five cache lines.
struct alignas(64) TriangleBlock {
    static constexpr uint32_t size = 8;
    float corners[3][3][size];  ///< by corner, axis, triangle
    uint32_t face[size];

    void set(size_t i, uint32_t number, const Vec3f& a, const Vec3f& b, const Vec3f& c) {
        face[i] = number;
        for (int axis = 0; axis < 3; ++axis) {
            corners[0][axis][i] = a[axis];
            corners[1][axis][i] = b[axis];
            corners[2][axis][i] = c[axis];
        }
    }
};

}  // namespace rb
