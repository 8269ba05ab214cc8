#pragma once
#include "scene/shape.h"

#include <cmath>

namespace rb {

/// A displaced sphere of about `count` triangles: "bumpy" of the measurements.
inline TriangleMesh bumpy(size_t count) {
    TriangleMesh mesh;
    const auto rings = static_cast<uint32_t>(std::sqrt(static_cast<double>(count) / 4.0));
    const uint32_t turns = 2 * rings;
    for (uint32_t i = 0; i <= rings; ++i) {
        for (uint32_t j = 0; j < turns; ++j) {
            const double a = pi * i / rings;
            const double b = 2 * pi * j / turns;
            const double r =
                1 + 0.05 * std::sin(9 * a) * std::sin(11 * b) + 0.01 * std::sin(70 * a) * std::cos(80 * b);
            mesh.vertices.emplace_back(
                Vec3{r * std::sin(a) * std::cos(b), r * std::cos(a), r * std::sin(a) * std::sin(b)});
        }
    }
    for (uint32_t i = 0; i < rings; ++i) {
        for (uint32_t j = 0; j < turns; ++j) {
            const uint32_t p = i * turns + j;
            const uint32_t q = i * turns + (j + 1) % turns;
            mesh.faces.push_back({p, q + turns, q});
            mesh.faces.push_back({p, p + turns, q + turns});
        }
    }
    return mesh;
}

}  // namespace rb
