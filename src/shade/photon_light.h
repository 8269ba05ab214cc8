#pragma once
#include "math/vec.h"
#include "scene/color.h"

#include <span>

namespace rb {

/// A photon where it is looked at.
struct NearPhoton {
    Rgb color{0.0f};      ///< light times the area that the photon stands for
    Vec3 direction{0.0};  ///< unit, towards where it came from
};

/// Photons around a place, and the area (on a surface) or volume (in media) that they are spread over.
struct GatheredPhotons {
    std::span<const NearPhoton> photons;
    double extent = 0;
};

/// The light that photons left in a world, as shading asks for it. Immutable; safe to ask from many threads.
class PhotonLight {
public:
    virtual ~PhotonLight() = default;

    virtual bool on_surfaces() const = 0;  ///< there are any
    virtual bool in_media() const = 0;

    /// The largest number of photons gathered at one place.
    virtual size_t capacity() const = 0;
    /// On a surface with this normal. `memory` has `capacity()` elements.
    virtual GatheredPhotons around(const Vec3& point, const Vec3& normal,
                                   std::span<NearPhoton> memory) const = 0;
    virtual GatheredPhotons around(const Vec3& point, std::span<NearPhoton> memory) const = 0;
};

}  // namespace rb
