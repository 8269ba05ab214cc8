#include "shade/direct_light.h"

#include "shade/area_sampler.h"
#include "shade/random.h"

#include <cmath>

namespace rb {

namespace {

constexpr double facing_limit = 1e-10;

bool is_black(const Rgb& c) {
    return std::abs(c.x) < 1e-10f && std::abs(c.y) < 1e-10f && std::abs(c.z) < 1e-10f;
}

}  // namespace

ShadowMemory::ShadowMemory(size_t rows, size_t lights, bool keep, Scratch::Scope& memory)
    : keep_(keep), lights_(lights) {
    if (!keep) return;
    colors_ = memory.take<Rgb>(rows * lights);
    known_ = memory.take<uint8_t>(rows * lights, uint8_t{0});
}

void DirectLight::add(const FinishProgram& finish, std::span<LitRow> rows, ShadowMemory& memory) {
    for (size_t light = 0; light < program_.lights.size(); ++light) {
        for (LitRow& row : rows) add_one(finish, light, row, memory);
    }
}

void DirectLight::add_one(const FinishProgram& finish, size_t light, LitRow& row, ShadowMemory& memory) {
    const LightProgram& source = program_.lights[light];
    const HitPoint& hit = state_.hits[row.hit];
    const LightVector way = source.toward(hit.point, Vec3{0.0});
    Rgb light_sum = source.area_illumination() ? from_area(finish, light, row, way, memory)
                                               : from_center(finish, light, row, way, memory);
    if (light_sum == Rgb(0.0f)) return;
    if (finish.finish.irid_amount > 0.0f) {
        const double cosines = std::abs(glm::dot(row.place.normal, way.direction)) +
                               std::abs(glm::dot(row.place.normal, row.place.direction));
        light_sum *=
            iridescence(finish, program_.world.settings.irid_wavelength, row.place.irid_thickness, cosines);
    }
    row.light += light_sum;
}

/// The place with its draw for crand.
LitPlace DirectLight::roughened(size_t light, const LitRow& row) const {
    LitPlace place = row.place;
    if (place.crand != 0.0) {
        place.crand *= unit_random(mixed(state_.ray_of(state_.hits[row.hit]).seed, 0x10000 + light));
    }
    return place;
}

Rgb DirectLight::from_center(const FinishProgram& finish, size_t light, const LitRow& row,
                             const LightVector& way, ShadowMemory& memory) {
    const LightProgram& source = program_.lights[light];
    const HitPoint& hit = state_.hits[row.hit];
    LightMeeting meeting{way.direction, Rgb(1.0f), false, !source.is_shadowless()};
    if (!hit.double_illuminate && glm::dot(row.place.normal, way.direction) < facing_limit) {
        if (finish.finish.diffuse_back == 0.0f) return Rgb(0.0f);
        meeting.backside = true;
    }
    const Rgb color = source.color() * static_cast<float>(source.attenuation(hit.point, way));
    if (is_black(color)) return Rgb(0.0f);
    const LitPlace place = roughened(light, row);
    // The light's share first: where it is nothing (a highlight elsewhere), no shadow ray is needed.
    const Rgb share = reflected_light(finish, place, meeting);
    if (share == Rgb(0.0f)) return share;
    return share * arriving(light, row, way, color, memory);
}

Rgb DirectLight::from_area(const FinishProgram& finish, size_t light, const LitRow& row,
                           const LightVector& way, ShadowMemory& memory) {
    const LightProgram& source = program_.lights[light];
    const HitPoint& hit = state_.hits[row.hit];
    const Rgb arrived = arriving(light, row, way, source.color(), memory);
    if (is_black(arrived)) return Rgb(0.0f);
    const AreaGrid& grid = source.light().area;
    const Rgb per_sample = arrived / static_cast<float>(source.sample_count());
    Scratch::Scope scratch(thread_scratch());
    const AreaSampler sampler(source, light, state_.ray_of(hit).seed, way.direction, 1, scratch);
    const LitPlace place = roughened(light, row);
    Rgb sum(0.0f);
    for (int v = 0; v < grid.size2; ++v) {
        for (int u = 0; u < grid.size1; ++u) {
            const Vec3 offset = sampler.offset(u, v);
            const LightVector ray = source.toward(hit.point, offset);
            LightMeeting meeting{ray.direction, Rgb(1.0f), false, !source.is_shadowless()};
            if (!hit.double_illuminate && glm::dot(row.place.normal, ray.direction) < facing_limit) {
                if (finish.finish.diffuse_back == 0.0f) continue;
                meeting.backside = true;
            }
            meeting.color = per_sample * static_cast<float>(source.attenuation(hit.point, ray));
            if (is_black(meeting.color)) continue;
            sum += reflected_light(finish, place, meeting);
        }
    }
    return sum;
}

Rgb DirectLight::arriving(size_t light, const LitRow& row, const LightVector& way, const Rgb& color,
                          ShadowMemory& memory) {
    if (const Rgb* known = memory.find(row.root, light)) return *known;
    const Rgb arrived = shadows_.arriving(light, state_.hits[row.hit], way, color);
    memory.store(row.root, light, arrived);
    return arrived;
}

}  // namespace rb
