#pragma once
#include "photons/photon_file.h"
#include "photons/photon_map.h"
#include "scene/photons.h"
#include "shade/photon_light.h"

#include <algorithm>

namespace rb {

/// How photons of a map are gathered around a place.
struct GatherRule {
    size_t min = 20;
    size_t max = 100;
    double radius = 1;
    double expand_increase = 0.2;
    double expand_count = 35;
};

/// A radius within which most places of a map find `max` photons, or more where their density varies much
/// (spec: shading 14.5). `in_space`: photons lie in a volume, not on surfaces.
double automatic_radius(const PhotonMap& map, size_t max, bool in_space);

/// The photons of surfaces and those of media.
class PhotonMaps final : public PhotonLight {
public:
    PhotonMaps(StoredPhotons photons, const PhotonSettings& settings);

    bool on_surfaces() const override { return !surfaces_.empty(); }
    bool in_media() const override { return !media_.empty(); }
    size_t capacity() const override {
        return std::min(surface_rule_.max, std::max(surfaces_.size(), media_.size()));
    }
    GatheredPhotons around(const Vec3& point, const Vec3& normal, std::span<NearPhoton> memory,
                           KnownPhotons* known) const override;
    GatheredPhotons around(const Vec3& point, std::span<NearPhoton> memory,
                           KnownReaches* known) const override;

    const PhotonMap& surface_map() const { return surfaces_; }
    const PhotonMap& media_map() const { return media_; }

private:
    PhotonMap surfaces_;
    PhotonMap media_;
    GatherRule surface_rule_;
    GatherRule media_rule_;
};

}  // namespace rb
