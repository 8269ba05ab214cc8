#include "photons/photon_map.h"

#include "base/parallel.h"
#include "base/scratch.h"

#include <algorithm>
#include <cmath>

namespace rb {

namespace {

/// Ranges no longer than this are not sorted.
constexpr size_t few = 8;
/// Ranges no longer than this are looked through.
constexpr size_t looked_through = 20;

/// Ranges longer than this are worth a thread.
constexpr size_t many = 16384;

PhotonBox box_of(std::span<const Photon> photons) {
    PhotonBox box{photons.front().place, photons.front().place};
    for (const Photon& photon : photons) {
        for (size_t i = 0; i < 3; ++i) {
            box.lo[i] = std::min(box.lo[i], photon.place[i]);
            box.hi[i] = std::max(box.hi[i], photon.place[i]);
        }
    }
    return box;
}

size_t longest_side(const PhotonBox& box) {
    size_t longest = 0;
    for (size_t i = 1; i < 3; ++i) {
        if (box.hi[i] - box.lo[i] > box.hi[longest] - box.lo[longest]) longest = i;
    }
    return longest;
}

/// How many ranges a map has at the most.
size_t range_count(size_t photons) {
    size_t count = 1;
    for (; photons > few; photons = (photons + 1) / 2) count = 2 * count + 1;
    return photons == 0 ? 0 : count;
}

}  // namespace

double PhotonMetric::least_square(const PhotonBox& box) const {
    constexpr double slack = 1e-12;
    Vec3 apart{0.0};
    if (is_round()) {
        for (int i = 0; i < 3; ++i) {
            const auto side = static_cast<size_t>(i);
            apart[i] = std::max({static_cast<double>(box.lo[side]) - place[i],
                                 place[i] - static_cast<double>(box.hi[side]), 0.0});
        }
        return glm::dot(apart, apart) * (1.0 - slack);
    }
    double along = 0;
    double spread = 0;
    for (int i = 0; i < 3; ++i) {
        const double lo = static_cast<double>(box.lo[static_cast<size_t>(i)]) - place[i];
        const double hi = static_cast<double>(box.hi[static_cast<size_t>(i)]) - place[i];
        apart[i] = std::max({lo, -hi, 0.0});
        along += 0.5 * normal[i] * (lo + hi);
        spread += 0.5 * std::abs(normal[i]) * (hi - lo);
    }
    // A little less, for the sake of rounding.
    const double beside = std::abs(along) - spread - slack * (std::abs(along) + spread);
    return glm::dot(apart, apart) * (1.0 + 16.0 * std::max(beside, 0.0)) * (1.0 - slack);
}

PhotonMap::PhotonMap(std::vector<Photon> photons) : boxes_(range_count(photons.size())) {
    if (!photons.empty()) sort(photons, 0);
    places_.reserve(photons.size());
    lights_.reserve(photons.size());
    for (const Photon& photon : photons) {
        places_.push_back(photon.place);
        lights_.push_back({photon.color, photon.origin});
    }
}

void PhotonMap::sort(std::span<Photon> photons, size_t node) {
    boxes_[node] = box_of(photons);
    if (photons.size() <= few) return;
    const size_t half = photons.size() / 2;
    const size_t axis = longest_side(boxes_[node]);
    std::nth_element(photons.begin(), photons.begin() + static_cast<std::ptrdiff_t>(half), photons.end(),
                     [axis](const Photon& a, const Photon& b) { return a.place[axis] < b.place[axis]; });
    const auto lower = [&] { sort(photons.first(half), 2 * node + 1); };
    const auto upper = [&] { sort(photons.subspan(half), 2 * node + 2); };
    if (photons.size() > many) {
        parallel_invoke(lower, upper);
    } else {
        lower();
        upper();
    }
}

/// Collects photons that are near enough so far; whenever there are twice as many as wanted, the farther half
/// is thrown away. Those that stay keep their order.
class PhotonMap::Search {
public:
    Search(const PhotonMap& map, const PhotonMetric& metric, const FoundPhoton& limit,
           std::span<FoundPhoton> found, std::span<FoundPhoton> memory)
        : map_(map), metric_(metric), limit_(limit), found_(found), memory_(memory) {}

    void in(size_t begin, size_t end, size_t node, double least) {
        if (least > limit_.square) return;
        if (end - begin <= looked_through) {
            for (size_t i = begin; i < end; ++i) look(i);
            return;
        }
        const size_t middle = begin + (end - begin) / 2;
        const double lower = metric_.least_square(map_.boxes_[2 * node + 1]);
        const double upper = metric_.least_square(map_.boxes_[2 * node + 2]);
        // The nearer side first, as it may show that the other one is too far.
        if (lower <= upper) in(begin, middle, 2 * node + 1, lower);
        in(middle, end, 2 * node + 2, upper);
        if (lower > upper) in(begin, middle, 2 * node + 1, lower);
    }

    void look(size_t index) {
        const FoundPhoton found{metric_.square(map_.places_[index]), static_cast<uint32_t>(index)};
        if (!(found < limit_)) return;
        found_[count_++] = found;
        if (count_ == found_.size()) keep(count_ / 2);
    }

    /// Puts the nearest ones into `nearest`, as many as it holds, and returns how many there are.
    size_t take(std::span<FoundPhoton> nearest) {
        if (count_ > nearest.size()) keep(nearest.size());
        std::ranges::copy(found_.first(count_), nearest.begin());
        return count_;
    }

private:
    void keep(size_t wanted) {
        const auto sorted = memory_.first(count_);
        std::ranges::copy(found_.first(count_), sorted.begin());
        const auto last = sorted.begin() + static_cast<std::ptrdiff_t>(wanted - 1);
        std::nth_element(sorted.begin(), last, sorted.end());
        limit_ = *last;
        size_t kept = 0;
        for (const FoundPhoton& found : found_.first(count_)) {
            found_[kept] = found;
            kept += limit_ < found ? 0 : 1;
        }
        count_ = wanted;
    }

    const PhotonMap& map_;
    const PhotonMetric& metric_;
    FoundPhoton limit_;  ///< what is not nearer does not count
    std::span<FoundPhoton> found_;
    std::span<FoundPhoton> memory_;  ///< as large, to sort in
    size_t count_ = 0;
};

size_t PhotonMap::find(const PhotonMetric& metric, double radius, std::span<FoundPhoton> nearest) const {
    return find_below({radius * radius, 0}, metric, nearest);
}

size_t PhotonMap::find_near(std::span<const uint32_t> known, const PhotonMetric& metric, double radius,
                            std::span<FoundPhoton> nearest) const {
    FoundPhoton limit{radius * radius, 0};
    if (known.size() >= nearest.size()) {
        FoundPhoton farthest;
        for (const uint32_t index : known)
            farthest = std::max(farthest, FoundPhoton{metric.square(places_[index]), index});
        // All of the known ones are below that.
        ++farthest.index;
        limit = std::min(limit, farthest);
    }
    return find_below(limit, metric, nearest);
}

size_t PhotonMap::find_below(const FoundPhoton& limit, const PhotonMetric& metric,
                             std::span<FoundPhoton> nearest) const {
    if (nearest.empty() || empty()) return 0;
    Scratch::Scope memory(thread_scratch());
    Search search(*this, metric, limit, memory.take<FoundPhoton>(2 * nearest.size()),
                  memory.take<FoundPhoton>(2 * nearest.size()));
    search.in(0, size(), 0, 0.0);
    return search.take(nearest);
}

size_t PhotonMap::find_slowly(const PhotonMetric& metric, double radius,
                              std::span<FoundPhoton> nearest) const {
    std::vector<FoundPhoton> all;
    for (size_t i = 0; i < size(); ++i) {
        const double square = metric.square(places_[i]);
        if (square < radius * radius) all.push_back({square, static_cast<uint32_t>(i)});
    }
    std::ranges::sort(all);
    all.resize(std::min(all.size(), nearest.size()));
    std::ranges::copy(all, nearest.begin());
    return all.size();
}

}  // namespace rb
