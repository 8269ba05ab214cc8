#include "shade/ray_stream.h"

#include "shade/surface_shader.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace rb {

namespace {

/// Length of a ray that hits nothing, for the atmosphere.
constexpr double missed_length = 2e10;

constexpr uint32_t bundle_size = 64;

}  // namespace

void RayStream::trace(std::span<const CameraRay> rays, std::span<Radiance> out) {
    start(rays);
    while (!state_.rays.empty()) run_wave();
    add_powers();
    for (size_t i = 0; i < rays.size(); ++i) {
        out[i] = rays[i].exists ? Radiance{state_.slots[i].rgb, state_.slots[i].transmit}
                                : Radiance{Rgb(0.0f), 1.0f};
    }
}

void RayStream::gather(std::span<const GatherRay> rays, int depth, const SurfelUse* surfels,
                       std::span<GatheredLight> out) {
    start(rays, depth);
    for (GatheredLight& light : out) light.distance = infinity;
    gathered_ = out;
    surfels_ = surfels;
    fresh_rays_.clear();
    run_wave();
    gathered_ = {};
    surfels_ = nullptr;
    while (!state_.rays.empty()) run_wave();
    add_powers();
    for (size_t i = 0; i < rays.size(); ++i) out[i].rgb = state_.slots[i].rgb;
    for (size_t k = 0; k < fresh_rays_.size(); ++k) {
        Surfel& fresh = (*surfels->fresh)[surfels->fresh->size() - fresh_rays_.size() + k];
        fresh.light = out[fresh_rays_[k]].rgb;
    }
}

/// The light of what a ray meets is known, and added; or it will be.
bool RayStream::is_known(uint32_t ray_index, const Hit& hit, uint32_t look, const Vec3& normal) {
    if (!program_.textures[program_.looks[look].texture].is_matt) return false;
    const Surfel surfel{hit.point, normal, hit.leaf, hit.crossing.member, look, surfels_->spread * hit.t};
    if (surfels_->known->find(surfel, state_.slots[state_.rays[ray_index].slot].rgb)) return true;
    if (surfels_->fresh) {
        surfels_->fresh->push_back(surfel);
        fresh_rays_.push_back(ray_index);
    }
    return false;
}

void RayStream::clear(size_t slots) {
    state_.rays.clear();
    state_.next.clear();
    state_.power_slots.clear();
    state_.interiors.clear();
    state_.slots.assign(slots, LightSlot{});
    state_.blockers.assign(program_.sample_count, no_leaf);
    state_.counters = {};
}

void RayStream::start(std::span<const GatherRay> rays, int depth) {
    clear(rays.size());
    const GlobalSettings& settings = program_.world.settings;
    const int level = 3 * depth / 2;
    state_.depth = depth;
    state_.reach = infinity;
    state_.limits = {std::max(settings.max_trace_level, level + 1), program_.adc_bailout};
    const float importance = std::max(
        program_.adc_bailout, std::pow(0.5f * settings.radiosity->brightness, static_cast<float>(depth)));
    state_.rays.reserve(rays.size());
    for (size_t i = 0; i < rays.size(); ++i) {
        PathRay& ray = state_.rays.emplace_back();
        ray.ray = rays[i].ray;
        ray.origin_leaf = rays[i].leaf;
        ray.origin_part = rays[i].part;
        ray.origin_member = rays[i].member;
        ray.origin_error = rays[i].error;
        ray.slot = static_cast<uint32_t>(i);
        ray.seed = rays[i].seed;
        ray.level = static_cast<uint16_t>(level);
        ray.importance = importance;
    }
}

/// Those that may contain where one of the rays begins.
std::vector<uint32_t> RayStream::solids_around(std::span<const CameraRay> rays) const {
    if (!program_.tracks_interiors) return {};
    Bounds origins;
    for (const CameraRay& ray : rays) {
        if (ray.exists && ray.ray.origin != program_.world.camera.location) origins.include(ray.ray.origin);
    }
    return origins.is_empty() ? std::vector<uint32_t>() : program_.geometry.solids_near(origins);
}

void RayStream::start(std::span<const CameraRay> rays) {
    clear(rays.size());
    state_.depth = 0;
    state_.limits = {program_.world.settings.max_trace_level, program_.adc_bailout};
    const MeshCamera* mesh = program_.world.camera.mesh.get();
    state_.reach = mesh && mesh->max_distance > 0.0 ? std::nextafter(mesh->max_distance, 0.0) : infinity;
    if (!(1.0f >= program_.adc_bailout)) return;

    const std::vector<uint32_t> solids = solids_around(rays);
    Vec3 origin = program_.world.camera.location;
    InteriorList inside = state_.interiors.add(program_.camera_interiors);
    state_.rays.reserve(rays.size());
    for (size_t i = 0; i < rays.size(); ++i) {
        if (!rays[i].exists) continue;
        if (program_.tracks_interiors && rays[i].ray.origin != origin) {
            origin = rays[i].ray.origin;
            inside = state_.interiors.add(program_.geometry.interiors_at(origin, solids));
        }
        PathRay& ray = state_.rays.emplace_back();
        ray.inside = inside;
        ray.ray = rays[i].ray;
        ray.slot = static_cast<uint32_t>(i);
        ray.seed = rays[i].seed;
        ray.share = rays[i].share;
    }
    state_.counters.camera = state_.rays.size();
}

void RayStream::run_wave() {
    intersect();
    shade_hits();
    state_.reach = infinity;
    std::swap(state_.rays, state_.next);
    state_.next.clear();
}

void RayStream::intersect() {
    state_.hits.clear();
    Scratch::Scope memory(thread_scratch());
    const auto misses = memory.take<uint32_t>(state_.rays.size());
    size_t miss_count = 0;
    // Together, since a processor waits for what it has only just stored in other pieces than it reads.
    std::array<RayQuery, bundle_size> queries;
    Hit hit;
    const auto count = static_cast<uint32_t>(state_.rays.size());
    for (uint32_t begin = 0; begin < count; begin += bundle_size) {
        const uint32_t end = std::min(begin + bundle_size, count);
        const Candidates* ahead = candidates(std::span(state_.rays).subspan(begin, end - begin));
        for (uint32_t i = begin; i < end; ++i) {
            const PathRay& ray = state_.rays[i];
            RayQuery& query = queries[i - begin];
            StreamState::ask(ray, mask_of(ray), query);
            query.t_max = state_.reach;
        }
        const bool all_miss = ahead && ahead->none();
        for (uint32_t i = begin; i < end; ++i) {
            if (!all_miss && program_.geometry.closest(queries[i - begin], hit, ahead)) {
                add_hit(i, hit);
            } else {
                misses[miss_count++] = i;
            }
        }
    }
    shade_sky(misses.first(miss_count));
}

RayMask RayStream::mask_of(const PathRay& ray) const {
    return program_.ray_masks[ray.reflected ? 2 : (ray.refracted ? 1 : 0)];
}

/// What rays that run side by side may meet; null if they do not, or if that is too much.
const Candidates* RayStream::candidates(std::span<const PathRay> rays) {
    constexpr size_t fewest = 4;
    if (!program_.options.skip_unneeded || rays.size() < fewest) return nullptr;
    Bounds origins;
    Bounds directions;
    RayMask mask = 0;
    for (const PathRay& ray : rays) {
        origins.include(ray.ray.origin);
        directions.include(ray.ray.direction);
        mask |= mask_of(ray);
    }
    constexpr double widest = 0.5;
    if (max_component(directions.size()) > widest) return nullptr;
    const RayBundle bundle = RayBundle::along(origins, directions);
    return program_.geometry.candidates(bundle, mask, no_leaf, candidates_) ? &candidates_ : nullptr;
}

void RayStream::add_hit(uint32_t ray_index, const Hit& hit) {
    const PathRay& ray = state_.rays[ray_index];
    if (!gathered_.empty()) gathered_[ray_index].distance = hit.t;
    Rgb weight = ray.weight;
    float alpha = ray.alpha;
    if (program_.has_air()) pass_air(ray_index, hit.t, lights_on(hit), weight, alpha);
    if (program_.media.fills_interiors()) pass_media(ray_index, hit.t, lights_on(hit), weight, alpha);
    const uint32_t surface = program_.leaf_surfaces[hit.leaf];
    if (surface != no_surface) {
        add_point(ray_index, hit, program_.surfaces[surface], weight, alpha);
        return;
    }
    // One hit point of each surface that a mesh or blob wears here.
    program_.geometry.surfaces_at(hit, worn_);
    for (const auto& [worn, share] : worn_) {
        if (worn_.size() > 1 && share < state_.limits.adc_bailout) continue;
        add_point(ray_index, hit, program_.surfaces[worn], weight * share, alpha * share);
    }
}

void RayStream::add_point(uint32_t ray_index, const Hit& hit, const SurfaceProgram& surface,
                          const Rgb& weight, float alpha) {
    const Vec3& direction = state_.rays[ray_index].ray.direction;
    const bool from_inside = glm::dot(hit.normal, direction) > 0.0;
    const uint32_t look = from_inside ? surface.interior_look : surface.look;
    const Vec3 normal = from_inside ? -hit.normal : hit.normal;
    if (surfels_ && weight == Rgb(1.0f) && is_known(ray_index, hit, look, normal)) return;
    const size_t index = state_.hits.size();
    // Piece by piece in its place: a copy would wait for what has only just been stored.
    HitPoint& kept = state_.hits.emplace_back();
    kept.point = hit.point;
    kept.normal = normal;
    kept.direction = direction;
    kept.t = hit.t;
    kept.error = hit.error;
    kept.ray = ray_index;
    kept.leaf = hit.leaf;
    kept.part = hit.crossing.part;
    kept.member = hit.crossing.member;
    kept.look = look;
    kept.interior = surface.interior;
    kept.weight = weight;
    kept.alpha = alpha;
    kept.uv_mapping = surface.uv_mapping;
    kept.double_illuminate = surface.double_illuminate;
    kept.from_inside = from_inside;
    kept.collects_photons = surface.photons.collect;
    if (!surface.needs_uv) return;
    if (state_.uv.size() <= index) state_.uv.resize(index + 1);
    state_.uv[index] = program_.geometry.uv(hit);
}

/// From the eye outward: what stands nearer is passed first.
void RayStream::pass(const PathRay& ray, const AirEffect& effect, Rgb& weight, float& alpha) {
    state_.slots[ray.slot].rgb += weight * effect.added;
    weight *= effect.attenuation;
    alpha *= grey(effect.attenuation);
}

std::span<const uint32_t> RayStream::lights_on(const Hit& hit) const {
    return program_.light_lists[program_.looks[program_.surface_of(hit).look].lights];
}

void RayStream::pass_air(uint32_t ray_index, double length, std::span<const uint32_t> lights, Rgb& weight,
                         float& alpha) {
    const PathRay& ray = state_.rays[ray_index];
    if (!state_.in_the_open(program_.world, ray.inside)) return;
    // Rainbows stand behind media and those behind the fog, however near it ends.
    pass(ray, program_.fog.along(ray.ray, length), weight, alpha);
    if (program_.media.fills_air()) pass(ray, media_.in_air(ray_index, length, lights), weight, alpha);
    if (program_.rainbow.empty()) return;
    pass(ray, program_.rainbow.along(ray.ray, length, ray.seed), weight, alpha);
}

/// Media of interiors are seen only before something that the ray meets (as in the reference).
void RayStream::pass_media(uint32_t ray_index, double length, std::span<const uint32_t> lights, Rgb& weight,
                           float& alpha) {
    const PathRay& ray = state_.rays[ray_index];
    if (ray.inside.count == 0 || !state_.in_the_open(program_.world, ray.inside)) return;
    pass(ray, media_.in_interiors(ray_index, length, lights), weight, alpha);
}

void RayStream::shade_sky(std::span<const uint32_t> misses) {
    if (misses.empty()) return;
    Scratch::Scope memory(thread_scratch());
    const auto shows_alpha = memory.take<uint8_t>(misses.size());
    for (size_t i = 0; i < misses.size(); ++i) {
        shows_alpha[i] = program_.options.alpha_output && !state_.rays[misses[i]].reflected ? 1 : 0;
    }
    std::span<SkyLight> light;
    if (!program_.sky.is_plain()) {
        const auto directions = memory.take<Vec3>(misses.size());
        for (size_t i = 0; i < misses.size(); ++i) directions[i] = state_.rays[misses[i]].ray.direction;
        light = memory.take<SkyLight>(misses.size());
        program_.sky.evaluate(directions, shows_alpha, light);
    }
    for (size_t i = 0; i < misses.size(); ++i) {
        const PathRay& ray = state_.rays[misses[i]];
        const SkyLight& seen = light.empty() ? program_.sky.plain(shows_alpha[i] != 0) : light[i];
        Rgb weight = ray.weight;
        float alpha = ray.alpha;
        if (program_.has_air())
            pass_air(misses[i], std::min(missed_length, state_.reach), program_.light_lists.front(), weight,
                     alpha);
        LightSlot& slot = state_.slots[ray.slot];
        slot.rgb += weight * seen.rgb;
        slot.transmit += alpha * seen.transmit;
    }
}

void RayStream::fill_samples() {
    if (!program_.needs_samples) return;
    const size_t count = state_.hits.size();
    state_.points.resize(count);
    state_.seen_normals.resize(count);
    state_.directions.resize(count);
    state_.uv.resize(count);
    for (size_t i = 0; i < count; ++i) {
        const HitPoint& hit = state_.hits[i];
        state_.points[i] = hit.point;
        state_.seen_normals[i] = hit.normal;
        state_.directions[i] = hit.direction;
    }
}

/// Hits by look, in the order of the wave within each.
std::span<const uint32_t> RayStream::group_hits(Scratch::Scope& memory) {
    const size_t count = state_.hits.size();
    state_.look_counts.resize(program_.looks.size());
    const auto used = memory.take<uint32_t>(std::min(count, program_.looks.size()));
    size_t used_count = 0;
    for (const HitPoint& hit : state_.hits) {
        if (state_.look_counts[hit.look]++ == 0) used[used_count++] = hit.look;
    }
    std::sort(used.begin(), used.begin() + static_cast<std::ptrdiff_t>(used_count));
    uint32_t start = 0;
    for (const uint32_t look : used.first(used_count)) {
        start += std::exchange(state_.look_counts[look], start);
    }
    const auto order = memory.take<uint32_t>(count);
    for (size_t i = 0; i < count; ++i) {
        order[state_.look_counts[state_.hits[i].look]++] = static_cast<uint32_t>(i);
    }
    for (const uint32_t look : used.first(used_count)) state_.look_counts[look] = 0;
    return order;
}

void RayStream::shade_hits() {
    if (state_.hits.empty()) return;
    fill_samples();
    Scratch::Scope memory(thread_scratch());
    const auto order = group_hits(memory);
    SurfaceShader shader(program_, state_);
    for (size_t begin = 0; begin < order.size();) {
        const uint32_t look = state_.hits[order[begin]].look;
        size_t end = begin + 1;
        while (end < order.size() && state_.hits[order[end]].look == look) ++end;
        shader.shade(program_.looks[look], order.subspan(begin, end - begin));
        begin = end;
    }
}

void RayStream::add_powers() {
    // Later slots belong to mirrors seen in earlier ones.
    for (size_t k = state_.power_slots.size(); k-- > 0;) {
        const PowerSlot& mirror = state_.power_slots[k];
        const Rgb& light = state_.slots[mirror.slot].rgb;
        const Rgb raised{std::pow(light.x, mirror.power), std::pow(light.y, mirror.power),
                         std::pow(light.z, mirror.power)};
        state_.slots[mirror.parent].rgb += mirror.weight * raised;
    }
}

}  // namespace rb
