#include "shade/direct_light.h"

#include "math/random.h"
#include "shade/area_sampler.h"
#include "shade/draws.h"

#include <algorithm>
#include <cmath>

namespace rb {

namespace {

constexpr double facing_limit = 1e-10;
constexpr size_t bundle_size = 32;

}  // namespace

ShadowMemory::ShadowMemory(size_t rows, size_t lights, bool keep, Scratch::Scope& memory)
    : keep_(keep), lights_(lights) {
    if (!keep) return;
    colors_ = memory.take<Rgb>(rows * lights);
    known_ = memory.take<uint8_t>(rows * lights, uint8_t{0});
}

/// Coordinates of the rows in arrays of their own: the loop over them is arithmetic and nothing else.
struct DirectLight::Columns {
    Columns(std::span<const LitRow> rows, std::span<const HitPoint> hits, Scratch::Scope& memory)
        : x(memory.take<double>(rows.size())),
          y(memory.take<double>(rows.size())),
          z(memory.take<double>(rows.size())),
          normal_x(memory.take<double>(rows.size())),
          normal_y(memory.take<double>(rows.size())),
          normal_z(memory.take<double>(rows.size())) {
        for (size_t i = 0; i < rows.size(); ++i) {
            const Vec3& point = hits[rows[i].hit].point;
            const Vec3& normal = rows[i].place.normal;
            x[i] = point.x, y[i] = point.y, z[i] = point.z;
            normal_x[i] = normal.x, normal_y[i] = normal.y, normal_z[i] = normal.z;
        }
    }
    Vec3 point(size_t i) const { return {x[i], y[i], z[i]}; }

    std::span<double> x, y, z;
    std::span<double> normal_x, normal_y, normal_z;
};

/// From each row to one light.
struct DirectLight::Ways {
    Ways(size_t count, Scratch::Scope& memory)
        : x(memory.take<double>(count)),
          y(memory.take<double>(count)),
          z(memory.take<double>(count)),
          distance(memory.take<double>(count)),
          cosine(memory.take<double>(count)) {}
    LightVector at(size_t i) const { return {{x[i], y[i], z[i]}, distance[i]}; }

    std::span<double> x, y, z;  ///< unit direction
    std::span<double> distance;
    std::span<double> cosine;  ///< between the way and the row's normal
};

/// A row that a light illuminates if nothing is between them.
struct DirectLight::Reached {
    uint32_t row;
    Rgb share;  ///< of what arrives
    Rgb color;  ///< of the light, after attenuation
};

void DirectLight::add(const FinishProgram& finish, std::span<LitRow> rows, std::span<const uint32_t> lights,
                      ShadowMemory& memory) {
    Scratch::Scope scratch(thread_scratch());
    const Columns columns(rows, state_.hits, scratch);
    Ways ways(rows.size(), scratch);
    const auto reached = scratch.take<Reached>(rows.size());
    const bool has_film = finish.finish.irid_amount > 0.0f;
    for (size_t k = 0; k < lights.size(); ++k) {
        const ListedLight light{lights[k], k};
        const LightProgram& source = program_.lights[light.index];
        if (source.area_illumination()) {
            for (LitRow& row : rows) {
                const LightVector way = source.toward(state_.hits[row.hit].point, Vec3{0.0});
                Rgb sum = from_area(finish, light, row, way, memory);
                if (has_film) sum *= thin_film(finish, row, way.direction);
                row.light += sum;
            }
            continue;
        }
        look_toward(source, columns, ways);
        const size_t lit = find_lit(finish, light.index, rows, columns, ways, reached);
        state_.counters.unreached += rows.size() - lit;
        for (size_t begin = 0; begin < lit; begin += bundle_size) {
            const auto places = reached.subspan(begin, std::min(bundle_size, lit - begin));
            // Layers above have mostly asked already.
            const Candidates* between = knows_all(rows, places, k, memory)
                                            ? nullptr
                                            : candidates(source, rows, places, columns, ways);
            const bool all_arrives = shadows_.passes_all(source, between);
            if (all_arrives) state_.counters.unhindered += places.size();
            for (const Reached& place : places) {
                LitRow& row = rows[place.row];
                const LightVector way = ways.at(place.row);
                if (all_arrives) memory.store(row.root, k, place.color);
                Rgb sum =
                    place.share *
                    (all_arrives ? place.color : arriving(light, row, way, place.color, between, memory));
                if (has_film) sum *= thin_film(finish, row, way.direction);
                row.light += sum;
            }
        }
    }
}

/// True if nothing of the light at these places is left to be found out.
bool DirectLight::knows_all(std::span<const LitRow> rows, std::span<const Reached> places, size_t light,
                            const ShadowMemory& memory) {
    return std::all_of(places.begin(), places.end(),
                       [&](const Reached& place) { return memory.knows(rows[place.row].root, light); });
}

/// What may be between a light and places that it reaches; null if that is too much, or of no use.
const Candidates* DirectLight::candidates(const LightProgram& source, std::span<const LitRow> rows,
                                          std::span<const Reached> places, const Columns& columns,
                                          const Ways& ways) {
    constexpr size_t fewest = 4;
    if (!program_.options.skip_unneeded || source.is_shadowless() || places.size() < fewest) return nullptr;
    // The directions of these differ from sample to sample.
    if (source.is_directed() && source.light().is_area) return nullptr;
    Bounds points;
    Bounds ends;
    uint32_t left = state_.hits[rows[places.front().row].hit].leaf;
    const bool is_flat = left != no_leaf && program_.geometry.leaves_for_good(left, false);
    for (const Reached& place : places) {
        const Vec3 point = columns.point(place.row);
        points.include(point);
        if (source.is_directed()) {
            const LightVector way = ways.at(place.row);
            ends.include(point + way.distance * way.direction);
        }
        if (left == no_leaf) continue;
        const HitPoint& hit = state_.hits[rows[place.row].hit];
        if (hit.leaf != left || !(is_flat || shadows_.leaves_for_good(source, hit, ways.at(place.row))))
            left = no_leaf;
    }
    if (!source.is_directed()) ends.include(source.light().location);
    ends.lo -= source.area_reach();
    ends.hi += source.area_reach();
    const RayBundle bundle = RayBundle::between(points, ends);
    return program_.geometry.candidates(bundle, program_.shadow_mask, left, candidates_) ? &candidates_
                                                                                         : nullptr;
}

/// The same arithmetic as LightProgram::toward(), over arrays.
void DirectLight::look_toward(const LightProgram& source, const Columns& rows, Ways& ways) {
    const size_t count = rows.x.size();
    if (source.is_directed()) {
        for (size_t i = 0; i < count; ++i) {
            const LightVector way = source.toward(rows.point(i), Vec3{0.0});
            ways.x[i] = way.direction.x, ways.y[i] = way.direction.y, ways.z[i] = way.direction.z;
            ways.distance[i] = way.distance;
        }
    } else {
        const Vec3 center = source.light().location;
        for (size_t i = 0; i < count; ++i) {
            const double x = center.x - rows.x[i];
            const double y = center.y - rows.y[i];
            const double z = center.z - rows.z[i];
            const double distance = std::sqrt(x * x + y * y + z * z);
            const double scale = distance > 0.0 ? 1.0 / distance : 1.0;
            ways.x[i] = x * scale;
            ways.y[i] = y * scale;
            ways.z[i] = z * scale;
            ways.distance[i] = distance;
        }
    }
    for (size_t i = 0; i < count; ++i) {
        ways.cosine[i] =
            rows.normal_x[i] * ways.x[i] + rows.normal_y[i] * ways.y[i] + rows.normal_z[i] * ways.z[i];
    }
}

/// Keeps the rows that show something of a light: for the others (turned away, a highlight elsewhere) no
/// shadow ray is needed.
size_t DirectLight::find_lit(const FinishProgram& finish, size_t light, std::span<const LitRow> rows,
                             const Columns& columns, const Ways& ways, std::span<Reached> reached) const {
    const LightProgram& source = program_.lights[light];
    if (!source.attenuates() && is_black(source.color())) return 0;
    const bool shows_back = finish.finish.diffuse_back != 0.0f;
    LightMeeting meeting;
    meeting.color = Rgb(1.0f);
    meeting.highlights = !source.is_shadowless();
    size_t count = 0;
    for (size_t i = 0; i < rows.size(); ++i) {
        const LitRow& row = rows[i];
        meeting.cosine = ways.cosine[i];
        meeting.backside = !row.double_illuminate && meeting.cosine < facing_limit;
        if (meeting.backside && !shows_back) continue;
        Reached& kept = reached[count];
        kept.row = static_cast<uint32_t>(i);
        kept.color = source.color();
        if (source.attenuates()) {
            kept.color *= static_cast<float>(source.attenuation(columns.point(i), ways.at(i)));
            if (is_black(kept.color)) continue;
        }
        meeting.direction = {ways.x[i], ways.y[i], ways.z[i]};
        meeting.crand = crand(finish, light, row);
        kept.share = reflected_light(finish, row.place, meeting);
        count += kept.share != Rgb(0.0f) ? 1 : 0;
    }
    return count;
}

double DirectLight::crand(const FinishProgram& finish, size_t light, const LitRow& row) const {
    const double amount = finish.finish.crand;
    if (amount == 0.0) return 0.0;
    return amount * unit_random(mixed(state_.ray_of(state_.hits[row.hit]).seed, draw_crand + light));
}

Rgb DirectLight::thin_film(const FinishProgram& finish, const LitRow& row, const Vec3& to_light) const {
    const double cosines = std::abs(glm::dot(row.place.normal, to_light)) +
                           std::abs(glm::dot(row.place.normal, row.place.direction));
    return iridescence(finish, program_.world.settings.irid_wavelength, row.place.irid_thickness, cosines);
}

Rgb DirectLight::from_area(const FinishProgram& finish, const ListedLight& light, const LitRow& row,
                           const LightVector& way, ShadowMemory& memory) {
    const LightProgram& source = program_.lights[light.index];
    const HitPoint& hit = state_.hits[row.hit];
    const Rgb arrived = arriving(light, row, way, source.color(), nullptr, memory);
    if (is_black(arrived)) return Rgb(0.0f);
    const AreaGrid& grid = source.light().area;
    const Rgb per_sample = arrived / static_cast<float>(source.grid_count());
    const AreaSampler sampler(source, StreamState::light_seed(state_.ray_of(hit), hit, light.index, 1),
                              way.direction);
    LightMeeting meeting;
    meeting.highlights = !source.is_shadowless();
    meeting.crand = crand(finish, light.index, row);
    Rgb sum(0.0f);
    for (int v = 0; v < grid.size2; ++v) {
        for (int u = 0; u < grid.size1; ++u) {
            const Vec3 offset = source.samples_by_pattern()
                                    ? sampler.even_place(static_cast<uint32_t>(v * grid.size1 + u))
                                    : sampler.grid_place(u, v);
            const LightVector ray = source.toward(hit.point, offset);
            meeting.direction = ray.direction;
            meeting.cosine = glm::dot(row.place.normal, ray.direction);
            meeting.backside = !hit.double_illuminate && meeting.cosine < facing_limit;
            if (meeting.backside && finish.finish.diffuse_back == 0.0f) continue;
            meeting.color = per_sample * static_cast<float>(source.attenuation(hit.point, ray));
            if (is_black(meeting.color)) continue;
            sum += reflected_light(finish, row.place, meeting);
        }
    }
    return sum;
}

Rgb DirectLight::arriving(const ListedLight& light, const LitRow& row, const LightVector& way,
                          const Rgb& color, const Candidates* candidates, ShadowMemory& memory) {
    if (const Rgb* known = memory.find(row.root, light.place)) return *known;
    const Rgb arrived = shadows_.arriving(light.index, state_.hits[row.hit], way, color, candidates);
    memory.store(row.root, light.place, arrived);
    return arrived;
}

}  // namespace rb
