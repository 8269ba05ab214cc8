#pragma once
#include "photons/photon.h"

#include <span>
#include <vector>

namespace rb {

/// How near a photon is to a place. Photons beside the surface count as farther away than those on it, by
/// a factor of 1 + 16 |normal . difference| on the square (spec: shading 14.5); without a normal (0) space is
/// round.
struct PhotonMetric {
    Vec3 place{0.0};
    Vec3 normal{0.0};

    double square(const Photon& photon) const {
        const Vec3 away = Vec3{photon.place[0], photon.place[1], photon.place[2]} - place;
        return glm::dot(away, away) * (1.0 + 16.0 * std::abs(glm::dot(normal, away)));
    }
};

/// A photon by its place in the map, and how near it is. Of two that are equally near the first counts as
/// nearer, so that the nearest ones are the same however they are searched.
struct FoundPhoton {
    double square = 0;
    uint32_t index = 0;

    friend auto operator<=>(const FoundPhoton&, const FoundPhoton&) = default;
};

/// Photons in a balanced kd-tree without pointers: the middle one of a range splits it, the lower ones lie
/// before it (Bentley 1975; Jensen 2001). The same photons in the same order give the same tree.
class PhotonMap {
public:
    explicit PhotonMap(std::vector<Photon> photons);

    bool empty() const { return photons_.empty(); }
    size_t size() const { return photons_.size(); }
    const Photon& operator[](size_t i) const { return photons_[i]; }

    /// Those nearer than `radius`, the nearest `nearest.size()` of them if there are more, in no order.
    /// Returns how many.
    size_t find(const PhotonMetric& metric, double radius, std::span<FoundPhoton> nearest) const;
    /// The same by looking at each photon.
    size_t find_slowly(const PhotonMetric& metric, double radius, std::span<FoundPhoton> nearest) const;

private:
    class Search;
    void build(size_t begin, size_t end);

    std::vector<Photon> photons_;
    std::vector<uint8_t> axes_;  ///< along which a photon splits its range
};

}  // namespace rb
