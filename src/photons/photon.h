#pragma once
#include "math/vec.h"
#include "scene/color.h"

#include <array>
#include <cstdint>

namespace rb {

/// A unit vector in four bytes: the octahedron's faces unfolded to a square (Meyer et al. 2010).
class PackedDirection {
public:
    PackedDirection() = default;
    explicit PackedDirection(const Vec3& unit);
    Vec3 unpacked() const;

private:
    std::array<int16_t, 2> place_{};
};

/// Light that has come to rest.
struct Photon {
    std::array<float, 3> place{};
    Rgb color{0.0f};         ///< light times the area that it stands for (in media: the volume)
    PackedDirection origin;  ///< towards where it came from
};

}  // namespace rb
