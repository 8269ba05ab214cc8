#include "photons/gathering.h"

#include "base/scratch.h"
#include "math/random.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rb {

namespace {

/// The area of a disc or the volume of a ball.
double extent_of(double radius, bool in_space) {
    return in_space ? 4.0 / 3.0 * pi * radius * radius * radius : pi * radius * radius;
}

double radius_of(double extent, bool in_space) {
    return in_space ? std::cbrt(0.75 * extent / pi) : std::sqrt(extent / pi);
}

struct Found {
    size_t count = 0;
    double radius = 0;

    double density(bool in_space) const { return static_cast<double>(count) / extent_of(radius, in_space); }
};

/// What was found near by, in space or on a surface, or neither.
struct Known {
    KnownReaches* reaches = nullptr;
    KnownPhotons* photons = nullptr;

    size_t find(const PhotonMap& map, const PhotonMetric& metric, double radius,
                std::span<FoundPhoton> nearest) const {
        if (reaches) radius = std::min(radius, reaches->at(metric.place));
        if (photons) return map.find_near(photons->indices, metric, radius, nearest);
        return map.find(metric, radius, nearest);
    }
    /// As many as are looked for; one of them is the farthest.
    void keep(const PhotonMetric& metric, std::span<const FoundPhoton> nearest, double farthest) const {
        if (reaches) reaches->add(metric.place, farthest);
        if (!photons) return;
        photons->indices.resize(nearest.size());
        std::ranges::transform(nearest, photons->indices.begin(), &FoundPhoton::index);
    }
};

/// Of more than `max` the farthest are left out, and the others fill a part of the ball only. `nearest` has
/// room for one more than are wanted.
Found find(const PhotonMap& map, const PhotonMetric& metric, double radius, std::span<FoundPhoton> nearest,
           const Known& known) {
    const size_t max = nearest.size() - 1;
    const size_t count = known.find(map, metric, radius, nearest);
    if (count <= max) return {count, radius};
    const auto farthest = std::ranges::max_element(nearest);
    known.keep(metric, nearest, std::sqrt(farthest->square));
    std::shift_left(farthest, nearest.end(), 1);
    return {max, std::sqrt(std::ranges::max(nearest.first(max)).square)};
}

/// Looks farther where that finds about as many for the area, or where there are few at all. (Measured: for
/// the area in media, too.)
Found gather(const PhotonMap& map, const PhotonMetric& metric, const GatherRule& rule,
             std::span<FoundPhoton> nearest, const Known& known) {
    const Found first = find(map, metric, rule.radius, nearest, known);
    if (first.count >= rule.min) return first;
    Scratch::Scope memory(thread_scratch());
    const auto farther = memory.take<FoundPhoton>(nearest.size());
    const Found second = find(map, metric, 3.0 * rule.radius, farther, known);
    const double density = first.density(false);
    const bool is_even = second.density(false) - density < rule.expand_increase * density;
    const bool is_few = second.count > 0 && static_cast<double>(second.count) < rule.expand_count;
    if (!is_even && !is_few) return first;
    std::ranges::copy(farther.first(second.count), nearest.begin());
    return second;
}

GatheredPhotons look_at(const PhotonMap& map, const PhotonMetric& metric, const GatherRule& rule,
                        bool in_space, std::span<NearPhoton> memory, const Known& known) {
    Scratch::Scope scratch(thread_scratch());
    const auto nearest = scratch.take<FoundPhoton>(memory.size() + 1);
    const Found found = gather(map, metric, rule, nearest, known);
    for (size_t i = 0; i < found.count; ++i) {
        memory[i] = {map.color(nearest[i].index), map.origin(nearest[i].index)};
    }
    return {memory.first(found.count), extent_of(found.radius, in_space)};
}

GatherRule rule_of(const PhotonMap& map, const PhotonSettings& settings, const PhotonRadius& radius,
                   bool in_space) {
    GatherRule rule;
    rule.min = static_cast<size_t>(settings.gather_min);
    rule.max = static_cast<size_t>(settings.gather_max);
    rule.expand_increase = settings.expand_increase;
    rule.expand_count = settings.expand_count;
    const double found =
        radius.radius > 0.0 || map.empty() ? radius.radius : automatic_radius(map, rule.max, in_space);
    // Measured: in media it reaches twice as far, a written one, too.
    rule.radius = found * radius.multiplier * (in_space ? 2.0 : 1.0);
    return rule;
}

}  // namespace

double automatic_radius(const PhotonMap& map, size_t max, bool in_space) {
    constexpr size_t fewest_tests = 100;
    constexpr size_t most_tests = 1000;
    constexpr uint64_t seed = 0x70686F746F6E73;
    const size_t tests = std::clamp(map.size() / 20, fewest_tests, most_tests);
    Scratch::Scope memory(thread_scratch());
    const auto nearest = memory.take<FoundPhoton>(std::min(max, map.size()) + 1);
    const size_t most = nearest.size() - 1;
    const auto at = [&](size_t test) {
        const auto& place = map.place(mixed(seed, test) % map.size());
        return PhotonMetric{{place[0], place[1], place[2]}};
    };
    double density = 0;
    for (size_t i = 0; i < tests; ++i) {
        const size_t count = map.find(at(i), std::numeric_limits<double>::infinity(), nearest.first(most));
        const double square = std::ranges::max(nearest.first(count)).square;
        if (square > 0.0) density += static_cast<double>(count) / extent_of(std::sqrt(square), in_space);
    }
    density /= static_cast<double>(tests);
    if (!(density > 0.0)) return 1.0;
    const double radius = radius_of(static_cast<double>(max) / density, in_space);
    size_t thin = 0;
    for (size_t i = 0; i < tests; ++i) {
        const double there = find(map, at(i), radius, nearest, {}).density(in_space);
        if (there > 0.05 * density && there < 0.7 * density) ++thin;
    }
    return radius * (1.0 + 20.0 * static_cast<double>(thin) / static_cast<double>(tests));
}

PhotonMaps::PhotonMaps(StoredPhotons photons, const PhotonSettings& settings)
    : surfaces_(std::move(photons.on_surfaces)),
      media_(std::move(photons.in_media)),
      surface_rule_(rule_of(surfaces_, settings, settings.surface_radius, false)),
      media_rule_(rule_of(media_, settings, settings.media_radius, true)) {}

GatheredPhotons PhotonMaps::around(const Vec3& point, const Vec3& normal, std::span<NearPhoton> memory,
                                   KnownPhotons* known) const {
    return look_at(surfaces_, {point, normal}, surface_rule_, false, memory, {.photons = known});
}

GatheredPhotons PhotonMaps::around(const Vec3& point, std::span<NearPhoton> memory,
                                   KnownReaches* known) const {
    return look_at(media_, {point}, media_rule_, true, memory, {.reaches = known});
}

}  // namespace rb
