#pragma once
#include "math/vec.h"
#include "scene/color.h"

#include <algorithm>
#include <array>
#include <limits>
#include <span>
#include <vector>

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

/// How far from some places as many photons were found as are gathered at once: a place near by need not look
/// farther than that and the way there.
class KnownReaches {
public:
    /// A distance within which as many are; infinite if nothing is known.
    double at(const Vec3& p) const {
        double least = std::numeric_limits<double>::infinity();
        for (const Place& place : std::span(places_).first(count_))
            least = std::min(least, glm::distance(p, place.point) + place.reach);
        constexpr double rounding = 1e-9;
        constexpr double coordinate_rounding = 1e-14;
        return least * (1.0 + rounding) + coordinate_rounding * largest_magnitude(p);
    }
    void add(const Vec3& p, double reach) {
        places_[next_] = {p, reach};
        next_ = (next_ + 1) % places_.size();
        count_ = std::max(count_, next_ == 0 ? places_.size() : next_);
    }

private:
    struct Place {
        Vec3 point{0.0};
        double reach = 0;
    };
    std::array<Place, 64> places_;
    size_t count_ = 0;
    size_t next_ = 0;
};

/// The photons of a surface that were found last, where there were as many as are gathered at once: near by
/// only what is no farther than the farthest of them need be looked at.
struct KnownPhotons {
    std::vector<uint32_t> indices;
};

/// The light that photons left in a world, as shading asks for it. Immutable; safe to ask from many threads.
class PhotonLight {
public:
    virtual ~PhotonLight() = default;

    virtual bool on_surfaces() const = 0;  ///< there are any
    virtual bool in_media() const = 0;

    /// The largest number of photons gathered at one place.
    virtual size_t capacity() const = 0;
    /// On a surface with this normal. `memory` has `capacity()` elements. `known`: null, or what was found
    /// before, which saves work; the answer is the same.
    virtual GatheredPhotons around(const Vec3& point, const Vec3& normal, std::span<NearPhoton> memory,
                                   KnownPhotons* known) const = 0;
    /// In media.
    virtual GatheredPhotons around(const Vec3& point, std::span<NearPhoton> memory,
                                   KnownReaches* known) const = 0;
};

}  // namespace rb
