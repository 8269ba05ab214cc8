#include "photons/photon_stream.h"

#include "math/random.h"
#include "shade/draws.h"

#include <algorithm>
#include <cmath>

namespace rb {

PhotonStream::PhotonStream(const ShadingProgram& program, StreamState& state, const PhotonMission& mission,
                           std::span<const uint32_t> inside)
    : RayStream(program, state), mission_(mission), inside_(inside), filters_(program, state) {}

void PhotonStream::follow(std::span<const PhotonStart> photons, uint64_t seed, PhotonHarvest& harvest) {
    start(photons, seed);
    while (!state_.rays.empty()) run_wave(harvest);
}

void PhotonStream::start(std::span<const PhotonStart> photons, uint64_t seed) {
    const GlobalSettings& settings = program_.world.settings;
    const PhotonSettings& own = *settings.photons;
    state_.limits = {own.max_trace_level >= 0 ? own.max_trace_level : settings.max_trace_level,
                     own.adc_bailout >= 0 ? static_cast<float>(own.adc_bailout) : settings.adc_bailout};
    state_.carries_photons = true;
    state_.wants_light = false;
    state_.rays.clear();
    state_.next.clear();
    state_.interiors.clear();
    paths_.clear();
    if (state_.limits.max_trace_level < 1 || !(1.0f >= state_.limits.adc_bailout)) return;
    const InteriorList inside = state_.interiors.add(inside_);
    for (const PhotonStart& photon : photons) {
        PathRay& ray = state_.rays.emplace_back();
        ray.ray = photon.ray;
        ray.weight = photon.color;
        ray.inside = inside;
        ray.seed = mixed(seed, state_.rays.size());
        paths_.push_back({photon.passed, photon.ring, false});
    }
}

void PhotonStream::run_wave(PhotonHarvest& harvest) {
    state_.hits.clear();
    state_.permits.clear();
    // What surfaces would shine by themselves is added up and not looked at.
    state_.slots.assign(state_.rays.size(), LightSlot{});
    Hit hit;
    for (uint32_t i = 0; i < state_.rays.size(); ++i) {
        PathRay& ray = state_.rays[i];
        ray.slot = i;
        RayQuery query;
        StreamState::ask(ray, ray.reflected ? seen_by_mirrored_photons : seen_by_photons, query);
        if (program_.geometry.closest(query, hit)) arrive(i, hit, harvest);
    }
    shade_hits();
    next_paths_.clear();
    for (const PathRay& ray : state_.next) next_paths_.push_back(paths_[ray.slot]);
    std::swap(paths_, next_paths_);
    std::swap(state_.rays, state_.next);
    state_.next.clear();
}

void PhotonStream::arrive(uint32_t index, const Hit& hit, PhotonHarvest& harvest) {
    const PathRay& ray = state_.rays[index];
    Path& path = paths_[index];
    const PhotonRole& role = program_.surface_of(hit).photons;
    path.length += hit.t;
    if (!path.has_met_target && role.target != mission_.target) {
        if (role.pass_through) pass_straight(index, hit);
        return;
    }
    const Rgb color = arriving(index, hit, harvest);
    if (!path.has_met_target) {
        path.has_met_target = true;
        harvest.rings_that_hit.push_back(path.ring);
    } else if (role.collect) {
        harvest.on_surfaces.push_back(deposit(ray, color, hit.point, path.length, path.ring));
    }
    const PhotonWays& light = mission_.light->light().photons.ways;
    const PhotonPermit permit{photons_pass(light.refraction, role.ways.refraction),
                              photons_pass(light.reflection, role.ways.reflection)};
    if (permit.refraction || permit.reflection) send_on(index, hit, color, permit);
}

/// The light of a photon after its way through interiors.
Rgb PhotonStream::arriving(uint32_t index, const Hit& hit, PhotonHarvest& harvest) {
    const PathRay& ray = state_.rays[index];
    const auto inside = state_.interiors.view(ray.inside);
    if (inside.empty()) return ray.weight;
    const Rgb color = ray.weight * filters_.fade_of(hit, inside);
    if (!program_.media.fills_interiors()) return color;
    if (paths_[index].has_met_target && state_.in_the_open(program_.world, ray.inside)) {
        program_.media.mix_of(inside, mix_);
        if (!mix_.empty() && mix_.scatters() && mix_.collects()) leave_in_media(index, hit.t, harvest);
    }
    return color * filters_.media_filter(ray.ray, hit.t, inside, ray.seed);
}

/// Deposits about as far apart as photons are from one another (spec: shading 14.6).
void PhotonStream::leave_in_media(uint32_t index, double length, PhotonHarvest& harvest) {
    const PathRay& ray = state_.rays[index];
    const PhotonSettings& settings = *program_.world.settings.photons;
    if (settings.media_steps == 0) return;
    const double start = paths_[index].length - length;
    const double step = settings.media_factor * width_at(start);
    const uint64_t seed = mixed(ray.seed, draw_photons_left_in_media);
    const double wanted = length / step;
    const double count = std::min(std::floor(wanted), static_cast<double>(settings.media_steps));
    const double longer = std::max(1.0, wanted / static_cast<double>(settings.media_steps));
    // Measured: what the media take of the photon shows at the end of its way only.
    for (uint64_t i = 0; static_cast<double>(i) < count; ++i) {
        const double place = length * (static_cast<double>(i) + unit_random(mixed(seed, i))) / count;
        const double weight = settings.media_factor * width_at(start + place) * longer;
        harvest.in_media.push_back(deposit(ray, ray.weight * static_cast<float>(weight), ray.ray.at(place),
                                           start + place, paths_[index].ring));
    }
}

/// Through something that only tints photons on their way to the target.
void PhotonStream::pass_straight(uint32_t index, const Hit& hit) {
    const PathRay& ray = state_.rays[index];
    const auto inside = state_.interiors.view(ray.inside);
    Rgb color = ray.weight * filters_.filter_of(hit, ray.ray, inside);
    if (program_.media.fills_interiors() && !inside.empty())
        color *= filters_.media_filter(ray.ray, hit.t, inside, ray.seed);
    if (is_black(color)) return;
    PathRay& next = state_.next.emplace_back(ray);
    next.ray.origin = hit.point;
    next.origin_leaf = hit.leaf;
    next.origin_part = hit.crossing.part;
    next.origin_member = hit.crossing.member;
    next.origin_error = hit.error;
    next.weight = color;
    if (!program_.tracks_interiors) return;
    const uint32_t interior = program_.surface_of(hit).interior;
    const auto found = std::ranges::find(inside, interior);
    next.inside = found == inside.end()
                      ? state_.interiors.with(ray.inside, interior)
                      : state_.interiors.without(ray.inside, static_cast<size_t>(found - inside.begin()));
}

double PhotonStream::width_at(double path_length) const {
    return mission_.light->is_directed() ? mission_.spread : mission_.spread * path_length;
}

Deposit PhotonStream::deposit(const PathRay& ray, const Rgb& color, const Vec3& place, double path_length,
                              uint32_t ring) const {
    const double width = width_at(path_length);
    Deposit left;
    left.photon.place = {static_cast<float>(place.x), static_cast<float>(place.y),
                         static_cast<float>(place.z)};
    left.photon.color = color * static_cast<float>(mission_.light->fading(path_length) * width * width);
    left.photon.origin = PackedDirection(-ray.ray.direction);
    left.ring = ring;
    return left;
}

/// The surfaces of the hit are shaded with the rest of the wave.
void PhotonStream::send_on(uint32_t index, const Hit& hit, const Rgb& color, PhotonPermit permit) {
    program_.geometry.surfaces_at(hit, worn_);
    for (const auto& [worn, share] : worn_) {
        if (worn_.size() > 1 && share < state_.limits.adc_bailout) continue;
        add_point(index, hit, program_.surfaces[worn], color * share, 1.0f);
        state_.permits.push_back(permit);
    }
}

}  // namespace rb
