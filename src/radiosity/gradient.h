#pragma once
#include "math/vec.h"
#include "scene/color.h"

#include <array>
#include <cmath>

namespace rb {

/// How a colour changes along a direction.
struct Gradient {
    std::array<Rgb, 3> per_axis{Rgb(0.0f), Rgb(0.0f), Rgb(0.0f)};

    void add(const Vec3& direction, const Rgb& amount) {
        for (size_t i = 0; i < 3; ++i)
            per_axis[i] += static_cast<float>(direction[static_cast<int>(i)]) * amount;
    }
    /// Makes of a gradient along directions the one of turns from an axis towards them.
    void turn_about(const Vec3& axis) {
        const auto row = [this](size_t i, size_t j, const Vec3& a) {
            return static_cast<float>(a[static_cast<int>(i)]) * per_axis[j] -
                   static_cast<float>(a[static_cast<int>(j)]) * per_axis[i];
        };
        per_axis = {row(1, 2, axis), row(2, 0, axis), row(0, 1, axis)};
    }
    /// Largest change of the grey along any direction.
    double steepness() const {
        double square = 0;
        for (const Rgb& change : per_axis)
            square += static_cast<double>(grey(change)) * static_cast<double>(grey(change));
        return std::sqrt(square);
    }
    Rgb along(const Vec3& way) const {
        return static_cast<float>(way.x) * per_axis[0] + static_cast<float>(way.y) * per_axis[1] +
               static_cast<float>(way.z) * per_axis[2];
    }
};

}  // namespace rb
