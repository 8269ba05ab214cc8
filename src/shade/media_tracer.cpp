#include "shade/media_tracer.h"

#include "math/random.h"

#include <cmath>

namespace rb {

AirEffect MediaTracer::in_interiors(uint32_t ray_index, double length, std::span<const uint32_t> lights) {
    program_.media.mix_of(state_.interiors.view(state_.rays[ray_index].inside), mix_);
    return mix_.empty() ? AirEffect{} : along(ray_index, length, lights, draw_media_of_interiors);
}

AirEffect MediaTracer::in_air(uint32_t ray_index, double length, std::span<const uint32_t> lights) {
    program_.media.mix_of_air(mix_);
    return along(ray_index, length, lights, draw_media_of_air);
}

AirEffect MediaTracer::along(uint32_t ray_index, double length, std::span<const uint32_t> lights, Draw draw) {
    const PathRay& ray = state_.rays[ray_index];
    ray_index_ = ray_index;
    spans_.clear();
    for (const uint32_t light : state_.wants_light ? lights : std::span<const uint32_t>{}) {
        auto span = lit_span(program_.lights[light].light(), ray.ray, length);
        if (!span) continue;
        span->light = light;
        spans_.push_back(*span);
    }
    cut_by_light(spans_, length, pieces_);
    MediaLighting* lighting = mix_.scatters() ? this : nullptr;
    return MediaPath(mix_, ray.ray, mixed(ray.seed, draw), lighting).seen(pieces_);
}

void MediaTracer::add(std::span<const double> distances, std::span<const Vec3> points,
                      std::span<MediaSample> samples) {
    for (const LightSpan& span : spans_) add_light(span, distances, points, samples);
    if (shows_photons()) add_photons(points, samples);
}

void MediaTracer::add_photons(std::span<const Vec3> points, std::span<MediaSample> samples) {
    Scratch::Scope scratch(thread_scratch());
    const auto memory = scratch.take<NearPhoton>(program_.photons->capacity());
    const Vec3& direction = state_.rays[ray_index_].ray.direction;
    KnownReaches* known = program_.options.skip_unneeded ? &reaches_ : nullptr;
    for (size_t i = 0; i < points.size(); ++i) {
        if (samples[i].scattering == Rgb(0.0f)) continue;
        const GatheredPhotons found = program_.photons->around(points[i], memory, known);
        Rgb sum(0.0f);
        for (const NearPhoton& photon : found.photons) {
            sum += mix_.phase(glm::dot(photon.direction, direction)) * photon.color;
        }
        if (!found.photons.empty())
            samples[i].emission += samples[i].scattering * sum / static_cast<float>(found.extent);
    }
}

void MediaTracer::add_light(const LightSpan& span, std::span<const double> distances,
                            std::span<const Vec3> points, std::span<MediaSample> samples) {
    const LightProgram& source = program_.lights[span.light];
    const Candidates* between = candidates(source, points);
    const bool all_arrives = shadows_.passes_all(source, between);
    const PathRay& ray = state_.rays[ray_index_];
    HitPoint place;
    place.direction = ray.ray.direction;
    place.ray = ray_index_;
    place.collects_photons = mix_.collects();
    for (size_t i = 0; i < points.size(); ++i) {
        if (distances[i] < span.from || distances[i] > span.to) continue;
        if (samples[i].scattering == Rgb(0.0f)) continue;
        const LightVector way = source.toward(points[i], Vec3{0.0});
        Rgb color = source.color();
        // Measured: here the reference forgets cone and fading of lights with area_illumination.
        if (!source.area_illumination()) color *= static_cast<float>(source.attenuation(points[i], way));
        if (is_black(color)) continue;
        place.point = points[i];
        place.t = distances[i];
        // Method 3 looks where the way begins: on the surface that the ray has come through.
        const bool at_start = std::abs(distances[i]) <= ray.origin_error;
        place.leaf = at_start ? ray.origin_leaf : no_leaf;
        place.part = at_start ? ray.origin_part : any_part;
        place.member = at_start ? ray.origin_member : 0;
        place.error = at_start ? ray.origin_error : 0.0;
        if (!all_arrives) color = shadows_.arriving(span.light, place, way, color, between);
        const float phase = mix_.phase(glm::dot(way.direction, place.direction));
        samples[i].emission += phase * samples[i].scattering * color;
    }
}

/// What may be between the samples and a light; null if that is too much, or of no use.
const Candidates* MediaTracer::candidates(const LightProgram& source, std::span<const Vec3> points) {
    constexpr size_t fewest = 4;
    if (!program_.options.skip_unneeded || points.size() < fewest) return nullptr;
    // The directions of these differ from sample to sample.
    if (source.is_directed() && source.light().is_area) return nullptr;
    Bounds starts;
    Bounds ends;
    for (const Vec3& point : points) {
        starts.include(point);
        if (!source.is_directed()) continue;
        const LightVector way = source.toward(point, Vec3{0.0});
        ends.include(point + way.distance * way.direction);
    }
    if (!source.is_directed()) ends.include(source.light().location);
    ends.lo -= source.area_reach();
    ends.hi += source.area_reach();
    const RayBundle bundle = RayBundle::between(starts, ends);
    return program_.geometry.candidates(bundle, program_.shadow_mask, no_leaf, candidates_) ? &candidates_
                                                                                            : nullptr;
}

}  // namespace rb
