#include "photons/photon_map.h"

#include "base/parallel.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rb {

namespace {

/// Ranges no longer than this are looked through.
constexpr size_t few = 8;

/// Ranges longer than this are worth a thread.
constexpr size_t many = 16384;

uint8_t widest_axis(std::span<const Photon> photons) {
    std::array<float, 3> lo = photons.front().place;
    std::array<float, 3> hi = lo;
    for (const Photon& photon : photons) {
        for (size_t i = 0; i < 3; ++i) {
            lo[i] = std::min(lo[i], photon.place[i]);
            hi[i] = std::max(hi[i], photon.place[i]);
        }
    }
    size_t widest = 0;
    for (size_t i = 1; i < 3; ++i) {
        if (hi[i] - lo[i] > hi[widest] - lo[widest]) widest = i;
    }
    return static_cast<uint8_t>(widest);
}

}  // namespace

PhotonMap::PhotonMap(std::vector<Photon> photons) : photons_(std::move(photons)), axes_(photons_.size()) {
    build(0, photons_.size());
}

void PhotonMap::build(size_t begin, size_t end) {
    if (end - begin <= few) return;
    const size_t middle = begin + (end - begin) / 2;
    const uint8_t axis = widest_axis(std::span(photons_).subspan(begin, end - begin));
    const auto at = [this](size_t i) { return photons_.begin() + static_cast<std::ptrdiff_t>(i); };
    std::nth_element(at(begin), at(middle), at(end),
                     [axis](const Photon& a, const Photon& b) { return a.place[axis] < b.place[axis]; });
    axes_[middle] = axis;
    if (end - begin > many) {
        parallel_invoke([&] { build(begin, middle); }, [&] { build(middle + 1, end); });
    } else {
        build(begin, middle);
        build(middle + 1, end);
    }
}

/// Keeps the nearest photons as a heap with the farthest on top.
class PhotonMap::Search {
public:
    Search(const PhotonMap& map, const PhotonMetric& metric, double radius, std::span<FoundPhoton> nearest)
        : map_(map), metric_(metric), limit_{radius * radius, 0}, nearest_(nearest) {}

    void in(size_t begin, size_t end) {
        while (end - begin > few) {
            const size_t middle = begin + (end - begin) / 2;
            const uint8_t axis = map_.axes_[middle];
            const double away = metric_.place[axis] - static_cast<double>(map_[middle].place[axis]);
            // The nearer side first, as it may show that the other one is too far.
            const bool lower_first = away < 0.0;
            if (lower_first) {
                in(begin, middle);
                begin = middle + 1;
            } else {
                in(middle + 1, end);
                end = middle;
            }
            if (away * away > limit_.square) return;
            look(middle);
        }
        for (size_t i = begin; i < end; ++i) look(i);
    }

    void look(size_t index) {
        const FoundPhoton found{metric_.square(map_[index]), static_cast<uint32_t>(index)};
        if (!(found < limit_)) return;
        const auto first = nearest_.begin();
        if (count_ < nearest_.size()) {
            nearest_[count_++] = found;
            std::push_heap(first, first + static_cast<std::ptrdiff_t>(count_));
        } else {
            std::pop_heap(first, nearest_.end());
            nearest_.back() = found;
            std::push_heap(first, nearest_.end());
        }
        if (count_ == nearest_.size()) limit_ = nearest_.front();
    }

    size_t count() const { return count_; }

private:
    const PhotonMap& map_;
    const PhotonMetric& metric_;
    FoundPhoton limit_;  ///< what is not nearer does not count
    std::span<FoundPhoton> nearest_;
    size_t count_ = 0;
};

size_t PhotonMap::find(const PhotonMetric& metric, double radius, std::span<FoundPhoton> nearest) const {
    if (nearest.empty()) return 0;
    Search search(*this, metric, radius, nearest);
    search.in(0, size());
    return search.count();
}

size_t PhotonMap::find_slowly(const PhotonMetric& metric, double radius,
                              std::span<FoundPhoton> nearest) const {
    if (nearest.empty()) return 0;
    Search search(*this, metric, radius, nearest);
    for (size_t i = 0; i < size(); ++i) search.look(i);
    return search.count();
}

}  // namespace rb
