#include "photons/shoot.h"

#include "base/diagnostics.h"
#include "base/parallel.h"
#include "math/random.h"
#include "photons/photon_stream.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace rb {

namespace {

/// Photons that travel together.
constexpr size_t stream_size = 512;

/// More would take days.
constexpr double most_photons = 4e9;
/// More would take more memory than most machines have.
constexpr size_t most_stored = 100'000'000;

/// A light and what it shoots photons at.
struct Pair {
    uint32_t light = 0;
    uint32_t target = 0;
};

/// A part of a ring.
struct RingPart {
    uint32_t ring = 0;
    uint32_t first = 0;
    uint32_t count = 0;
};

std::vector<Pair> pairs_of(const ShadingProgram& program) {
    std::vector<Pair> pairs;
    const World& world = program.world;
    for (uint32_t light = 0; light < program.lights.size(); ++light) {
        if (!world.lights[light].is_global || program.lights[light].is_shadowless()) continue;
        const PhotonWays& ways = program.lights[light].light().photons.ways;
        for (uint32_t k = 0; k < world.photon_targets.size(); ++k) {
            const PhotonTarget& target = world.photon_targets[k];
            if (target.box.is_empty() || !target.global_lights) continue;
            if (photons_pass(ways.refraction, target.ways.refraction) ||
                photons_pass(ways.reflection, target.ways.reflection))
                pairs.push_back({light, k});
        }
    }
    return pairs;
}

/// How many photons a spacing brings about, as the language's `count` estimates it (spec: shading 14.2).
double estimated_count(const ShadingProgram& program, const std::vector<Pair>& pairs, double spacing) {
    double sum = 0;
    for (const Pair& pair : pairs) {
        const PhotonTarget& target = program.world.photon_targets[pair.target];
        const PhotonWays& ways = program.lights[pair.light].light().photons.ways;
        const bool refracts = photons_pass(ways.refraction, target.ways.refraction);
        const bool reflects = photons_pass(ways.reflection, target.ways.reflection);
        const double radius =
            0.5 * glm::length(target.box.size()) / (static_cast<double>(target.spacing_factor) * spacing);
        double count = 0.5 * pi * radius * radius;
        if (refracts && reflects) count *= 1.5;
        if (target.collect && refracts) count *= reflects ? 3.0 : 2.0;
        sum += count;
    }
    return sum;
}

double spacing_of(const ShadingProgram& program, const std::vector<Pair>& pairs) {
    const PhotonSettings& settings = *program.world.settings.photons;
    if (!(settings.count > 0.0)) return settings.spacing;
    return std::sqrt(estimated_count(program, pairs, 1.0) / settings.count);
}

/// Moves a photon to where it leaves what its light is projected through, the last time; false if it misses
/// that.
bool project(const Geometry& object, PhotonStart& start) {
    RayQuery query;
    query.ray = start.ray;
    query.mask = seen_by_trace;
    Hit hit;
    while (object.closest(query, hit)) {
        start.passed += hit.t;
        start.ray.origin = hit.point;
        query.ray.origin = hit.point;
        query.origin_leaf = hit.leaf;
        query.origin_part = hit.crossing.part;
        query.origin_member = hit.crossing.member;
        query.origin_error = hit.error;
    }
    return start.passed > 0.0;
}

/// Shoots from one light at one target.
class Volley {
public:
    Volley(const ShadingProgram& program, const Pair& pair, double spacing, uint64_t seed)
        : program_(program),
          light_(program.lights[pair.light]),
          pattern_(light_, program.world.photon_targets[pair.target],
                   spacing * static_cast<double>(program.world.photon_targets[pair.target].spacing_factor),
                   *program.world.settings.photons, seed),
          seed_(seed) {
        mission_ = {&light_, pair.target, pattern_.spread()};
        if (program.tracks_interiors) inside_ = program.geometry.interiors_at(light_.light().location);
    }

    double start_count() const { return pattern_.start_count(); }

    void shoot(int threads, const std::atomic<bool>& stop, StoredPhotons& photons, PhotonCounters& counters) {
        const auto rings = static_cast<uint32_t>(std::min(pattern_.ring_count(), 4e9));
        size_t wanted = 4096;
        for (uint32_t ring = 0; ring < rings && !stop.load(std::memory_order_relaxed);) {
            const uint32_t first = ring;
            const std::vector<RingPart> parts = next_parts(ring, rings, wanted);
            std::vector<PhotonHarvest> harvests(parts.size());
            parallel_for(parts.size(), threads, stop, [&](size_t i) { follow(parts[i], harvests[i]); });
            const uint32_t end = find_end(first, ring, harvests);
            for (const PhotonHarvest& harvest : harvests) {
                keep(harvest.on_surfaces, end, photons.on_surfaces);
                keep(harvest.in_media, end, photons.in_media);
            }
            if (photons.size() > most_stored) return;
            for (const RingPart& part : parts)
                counters.shot += part.ring < end ? uint64_t{part.count} * pattern_.sample_count() : 0;
            if (end < ring) return;
            wanted = std::min(2 * wanted, size_t{1} << 17);
        }
    }

private:
    /// Whole rings with about as many photons as wanted, in parts.
    std::vector<RingPart> next_parts(uint32_t& ring, uint32_t rings, size_t wanted) const {
        const auto longest =
            static_cast<uint32_t>(std::max<size_t>(1, stream_size / pattern_.sample_count()));
        std::vector<RingPart> parts;
        for (size_t count = 0; ring < rings && count < wanted; ++ring) {
            const uint32_t size = pattern_.ring_size(ring);
            for (uint32_t first = 0; first < size; first += longest)
                parts.push_back({ring, first, std::min(longest, size - first)});
            count += size_t{size} * pattern_.sample_count();
        }
        return parts;
    }

    void follow(const RingPart& part, PhotonHarvest& harvest) const {
        thread_local StreamState state;
        thread_local std::vector<PhotonStart> starts;
        starts.clear();
        PhotonStart start;
        for (uint32_t place = part.first; place < part.first + part.count; ++place) {
            for (uint32_t sample = 0; sample < pattern_.sample_count(); ++sample) {
                if (!pattern_.start(part.ring, place, sample, start)) continue;
                const Geometry* object = light_.projected_through();
                if (!object || project(*object, start)) starts.push_back(start);
            }
        }
        PhotonStream(program_, state, mission_, inside_)
            .follow(starts, mixed(mixed(seed_, part.ring), part.first), harvest);
    }

    /// The first ring whose photons do not count; `ring` if all of them do.
    uint32_t find_end(uint32_t first, uint32_t ring, const std::vector<PhotonHarvest>& harvests) {
        std::vector<bool> hits(ring - first);
        for (const PhotonHarvest& harvest : harvests) {
            for (const uint32_t hit : harvest.rings_that_hit) hits[hit - first] = true;
        }
        for (uint32_t r = first; r < ring; ++r) {
            if (hits[r - first]) {
                has_hit_ = true;
            } else if (has_hit_ && pattern_.may_stop_at(r)) {
                return r + 1;
            }
        }
        return ring;
    }

    static void keep(const std::vector<Deposit>& deposits, uint32_t end, std::vector<Photon>& photons) {
        for (const Deposit& deposit : deposits) {
            if (deposit.ring < end) photons.push_back(deposit.photon);
        }
    }

    const ShadingProgram& program_;
    const LightProgram& light_;
    PhotonPattern pattern_;
    PhotonMission mission_;
    std::vector<uint32_t> inside_;
    uint64_t seed_;
    bool has_hit_ = false;
};

StoredPhotons shoot(const ShadingProgram& program, int threads, uint64_t seed, const std::atomic<bool>& stop,
                    PhotonCounters& counters) {
    const std::vector<Pair> pairs = pairs_of(program);
    const double spacing = spacing_of(program, pairs);
    std::vector<Volley> volleys;
    double expected = 0;
    for (size_t i = 0; i < pairs.size(); ++i) {
        volleys.emplace_back(program, pairs[i], spacing, mixed(seed, 0x73686F6F74 + i));
        expected += volleys.back().start_count();
    }
    if (!pairs.empty() && !(spacing > 0.0 && expected < most_photons)) {
        throw SceneError(program.world.settings.photons->where,
                         fmt::format("A spacing of {:.6g} asks for {:.3g} photons, which is too many.",
                                     spacing, expected));
    }
    StoredPhotons photons;
    for (Volley& volley : volleys) volley.shoot(threads, stop, photons, counters);
    if (photons.size() > most_stored) {
        throw SceneError(program.world.settings.photons->where,
                         fmt::format("A spacing of {:.6g} brings more than {} photons, which is too many.",
                                     spacing, most_stored));
    }
    return photons;
}

}  // namespace

std::shared_ptr<const PhotonMaps> photon_light(const ShadingProgram& program, int threads, uint64_t seed,
                                               const std::atomic<bool>& stop, PhotonCounters& counters) {
    const PhotonSettings& settings = *program.world.settings.photons;
    const auto check = [&](const std::string& problem) {
        if (!problem.empty()) throw SceneError(settings.where, problem);
    };
    StoredPhotons photons;
    if (!settings.load_file.empty()) {
        check(read_photons(settings.load_file, photons));
    } else {
        photons = shoot(program, threads, seed, stop, counters);
    }
    if (stop.load(std::memory_order_relaxed)) return nullptr;
    if (!settings.save_file.empty()) check(write_photons(settings.save_file, photons));
    counters.on_surfaces = photons.on_surfaces.size();
    counters.in_media = photons.in_media.size();
    if (photons.on_surfaces.empty() && photons.in_media.empty()) return nullptr;
    return std::make_shared<PhotonMaps>(std::move(photons), settings);
}

}  // namespace rb
