#pragma once
#include "photons/photon.h"

#include <span>
#include <vector>

namespace rb {

/// A box around photons.
struct PhotonBox {
    std::array<float, 3> lo{};
    std::array<float, 3> hi{};
};

/// How near a photon is to a place. Photons beside the surface count as farther away than those on it, by
/// a factor of 1 + 16 |normal . difference| on the square (spec: shading 14.5); without a normal (0) space is
/// round.
struct PhotonMetric {
    Vec3 place{0.0};
    Vec3 normal{0.0};

    double square(const std::array<float, 3>& photon) const {
        const Vec3 away = Vec3{photon[0], photon[1], photon[2]} - place;
        return glm::dot(away, away) * (1.0 + 16.0 * std::abs(glm::dot(normal, away)));
    }
    bool is_round() const { return normal == Vec3{0.0}; }
    /// No photon in the box has a smaller square.
    double least_square(const PhotonBox& box) const;
};

/// A photon by its place in the map, and how near it is. Of two that are equally near the first counts as
/// nearer, so that the nearest ones are the same however they are searched.
struct FoundPhoton {
    double square = 0;
    uint32_t index = 0;

    // NOLINTNEXTLINE(modernize-use-nullptr): there is no pointer
    friend auto operator<=>(const FoundPhoton&, const FoundPhoton&) = default;
};

/// Photons in a balanced kd-tree without pointers (Bentley 1975): sorted so that the halves of each range lie
/// apart along its longest side, and so on. Each range has its box, since photons lie on surfaces, and most
/// of what is near in space is empty. The same photons in the same order give the same tree.
class PhotonMap {
public:
    explicit PhotonMap(std::vector<Photon> photons);

    bool empty() const { return places_.empty(); }
    size_t size() const { return places_.size(); }
    const std::array<float, 3>& place(size_t i) const { return places_[i]; }
    const Rgb& color(size_t i) const { return lights_[i].color; }
    Vec3 origin(size_t i) const { return lights_[i].origin.unpacked(); }

    /// Those nearer than `radius`, the nearest `nearest.size()` of them if there are more. Returns how many.
    /// Their order depends on the metric alone: a smaller radius leaves out the others.
    size_t find(const PhotonMetric& metric, double radius, std::span<FoundPhoton> nearest) const;
    /// The same, but quickly where as many known photons as are looked for are near.
    size_t find_near(std::span<const uint32_t> known, const PhotonMetric& metric, double radius,
                     std::span<FoundPhoton> nearest) const;
    /// The same by looking at each photon.
    size_t find_slowly(const PhotonMetric& metric, double radius, std::span<FoundPhoton> nearest) const;

private:
    class Search;
    /// Those that count as nearer than `limit`.
    size_t find_below(const FoundPhoton& limit, const PhotonMetric& metric,
                      std::span<FoundPhoton> nearest) const;
    /// What is asked for only once a photon is found, kept apart from the places.
    struct Light {
        Rgb color{0.0f};
        PackedDirection origin;
    };
    void sort(std::span<Photon> photons, size_t node);

    std::vector<std::array<float, 3>> places_;
    std::vector<Light> lights_;
    std::vector<PhotonBox> boxes_;  ///< of ranges; the halves of range i are ranges 2i + 1 and 2i + 2
};

}  // namespace rb
