#include "shade/subsurface.h"

#include "math/sobol.h"
#include "shade/draws.h"

#include <algorithm>
#include <cmath>

namespace rb {

namespace {

/// Mean reflection of diffuse light at the inside of a surface (measured).
double inner_reflection(double ior) {
    if (ior < 1.0) return ior * ior - std::pow(ior, 2.25);
    const double x = 1.0 - 1.0 / ior;
    return (x + 3.0 * std::pow(x, 4.5)) / 4.0;
}

/// Diffuse reflectance of a half-space of this reduced albedo.
double reflectance_of(double albedo, double boundary) {
    const double s = std::sqrt(3.0 * (1.0 - albedo));
    return 0.5 * albedo * (1.0 + std::exp(-4.0 / 3.0 * boundary * s)) * std::exp(-s);
}

/// Its inverse, by bisection: it rises from 0 to 1.
double albedo_of(double reflectance, double boundary) {
    double low = 0;
    double high = 1;
    for (int i = 0; i < 40; ++i) {
        const double middle = 0.5 * (low + high);
        (reflectance_of(middle, boundary) < reflectance ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

double let_in(double cosine, double ior) { return 1.0 - fresnel_share(cosine, ior); }

/// Into the body; nothing under total reflection.
std::optional<Vec3> refracted(const Vec3& d, const Vec3& normal, double ior) {
    const double c = -glm::dot(d, normal);
    const double eta = 1.0 / ior;
    const double k = 1.0 + eta * eta * (c * c - 1.0);
    if (k < 0.0) return std::nullopt;
    return glm::normalize(eta * d + (eta * c - std::sqrt(k)) * normal);
}

/// A direction, evenly over the sphere.
Vec3 on_sphere(const Vec2& u) {
    const double z = 1.0 - 2.0 * u.x;
    const double r = std::sqrt(std::max(0.0, 1.0 - z * z));
    return {r * std::cos(2.0 * pi * u.y), r * std::sin(2.0 * pi * u.y), z};
}

}  // namespace

Bulk::Bulk(const Rgb& reflectance, const Rgb& translucency, double relative_ior, double mm_per_unit)
    : ior(relative_ior) {
    constexpr double least_translucency = 1e-4;
    const double f = inner_reflection(ior);
    boundary = (1.0 + f) / (1.0 - f);
    for (int c = 0; c < 3; ++c) {
        albedo[c] = albedo_of(std::clamp(static_cast<double>(reflectance[c]), 0.0, 1.0), boundary);
        if (albedo[c] < 1e-9) albedo[c] = 1e-9;
        const double scattering =
            mm_per_unit / std::max(static_cast<double>(translucency[c]), least_translucency);
        extinction[c] = scattering / albedo[c];
        transport[c] = std::sqrt(3.0 * (extinction[c] - scattering) * extinction[c]);
    }
}

Bulk SubsurfaceLight::bulk_of(const FinishProgram& finish, const Rgb& pigment, double ior) const {
    return {pigment * finish.finish.raw_diffuse, *finish.finish.translucency, ior,
            program_.world.settings.mm_per_unit};
}

Rgb SubsurfaceLight::at(const HitPoint& hit, const Vec3& normal, const FinishProgram& finish,
                        const Rgb& pigment, double ior, std::span<const uint32_t> lights) {
    if (hit.from_inside) return Rgb(0.0f);
    const Bulk bulk = bulk_of(finish, pigment, ior);
    const double cosine = std::max(0.0, -glm::dot(hit.direction, normal));
    const auto let_out = static_cast<float>(let_in(cosine, ior));
    return let_out * (scattered_often(hit, bulk, lights) + scattered_once(hit, normal, bulk, lights));
}

/// The body's surface in a direction from within, if nothing else is nearer. Its normal points outward.
std::optional<HitPoint> SubsurfaceLight::wall(const HitPoint& hit, const Ray& ray, bool starts_at_hit,
                                              double t_max) {
    RayQuery query;
    if (starts_at_hit) query = StreamState::query_from(hit, ray.direction, t_max, seen_by_image);
    query.ray = ray;
    query.t_max = t_max;
    query.mask = seen_by_image;
    Hit found;
    if (!program_.geometry.closest(query, found)) return std::nullopt;
    if (program_.surface_of(found).interior != hit.interior) return std::nullopt;
    HitPoint place;
    place.point = found.point;
    place.normal = found.normal;
    place.direction = ray.direction;
    place.t = found.t;
    place.error = found.error;
    place.ray = hit.ray;
    place.leaf = found.leaf;
    place.part = found.crossing.part;
    place.member = found.crossing.member;
    place.interior = hit.interior;
    return place;
}

/// Calls add(cosine, color) for the lights that reach a place on the body's outside.
template <class Add>
void SubsurfaceLight::each_light(const HitPoint& place, std::span<const uint32_t> lights, Add&& add) {
    for (const uint32_t index : lights) {
        const LightProgram& light = program_.lights[index];
        const LightVector way = light.toward(place.point, Vec3{0.0});
        const double cosine = glm::dot(place.normal, way.direction);
        if (!(cosine > 0.0)) continue;
        Rgb color = light.color();
        if (!light.area_illumination()) color *= static_cast<float>(light.attenuation(place.point, way));
        if (is_black(color)) continue;
        color = shadows_.arriving(index, place, way, color, nullptr);
        if (!is_black(color)) add(cosine, color);
    }
}

/// The dipole of a real and a virtual source (Jensen et al. 2001, 2.1), integrated over the body's surface as
/// seen from a place a mean free path below the hit.
Rgb SubsurfaceLight::scattered_often(const HitPoint& hit, const Bulk& bulk,
                                     std::span<const uint32_t> lights) {
    const Vec3 inward = -hit.normal;
    const auto opposite = wall(hit, {hit.point, inward}, true, infinity);
    double depth = 1.0 / static_cast<double>(grey(Rgb(bulk.extinction)));
    if (opposite) depth = std::min(depth, 0.5 * opposite->t);
    const Vec3 base = hit.point + depth * inward;
    const int count = program_.world.settings.subsurface->diffuse_samples;
    const uint64_t seed = mixed(state_.ray_of(hit).seed, draw_body_walls);
    Vec3 sum{0.0};
    int met = 0;
    for (int i = 0; i < count; ++i) {
        const Vec3 direction = on_sphere(scrambled_sobol(static_cast<uint32_t>(i), seed));
        const auto place = wall(hit, {base, direction}, false, infinity);
        if (!place) continue;
        ++met;
        const double slant = std::max(0.01, std::abs(glm::dot(direction, place->normal)));
        const double area = 4.0 * pi * place->t * place->t / slant;
        const Vec3 apart = place->point - hit.point;
        const double square = glm::dot(apart, apart);
        Vec3 spread{0.0};
        for (int c = 0; c < 3; ++c) {
            const double real = 1.0 / bulk.extinction[c];
            for (const double z : {real, real * (1.0 + 4.0 / 3.0 * bulk.boundary)}) {
                const double d = std::sqrt(z * z + square);
                spread[c] += z * (bulk.transport[c] + 1.0 / d) * std::exp(-bulk.transport[c] * d) / (d * d);
            }
        }
        each_light(*place, lights, [&](double cosine, const Rgb& color) {
            sum += area * cosine * let_in(cosine, bulk.ior) * spread * Vec3(color);
        });
    }
    // As in the reference, of which half of a plane's directions miss: twice as bright as a thick slab.
    return met == 0 ? Rgb(0.0f) : Rgb(sum * bulk.albedo / (4.0 * pi * met));
}

/// Places on the ray's way into the body, exponentially distributed, from which light goes straight out
/// again.
Rgb SubsurfaceLight::scattered_once(const HitPoint& hit, const Vec3& normal, const Bulk& bulk,
                                    std::span<const uint32_t> lights) {
    const auto inward = refracted(hit.direction, normal, bulk.ior);
    if (!inward) return Rgb(0.0f);
    const Ray way_in{hit.point, *inward};
    Hit end;
    const bool ends =
        program_.geometry.closest(StreamState::query_from(hit, *inward, infinity, seen_by_image), end);
    const double longest = ends ? end.t : infinity;
    const double seen_cosine = std::abs(glm::dot(*inward, normal));
    const int count = program_.world.settings.subsurface->single_samples;
    const uint64_t seed = mixed(state_.ray_of(hit).seed, draw_body_depths);
    Vec3 sum{0.0};
    for (int i = 0; i < count; ++i) {
        const Vec2 u = scrambled_sobol(static_cast<uint32_t>(i), seed);
        for (int c = 0; c < 3; ++c) {
            const double depth = -std::log(1.0 - u.x) / bulk.extinction[c];
            if (depth >= longest) continue;
            sum[c] += from_within(hit, way_in.at(depth), depth, seen_cosine, c, bulk, lights);
        }
    }
    return Rgb(0.25 * sum * bulk.albedo / static_cast<double>(count));
}

/// What light that is scattered once at a place `depth` below brings, of one channel.
double SubsurfaceLight::from_within(const HitPoint& hit, const Vec3& place, double depth, double seen_cosine,
                                    int channel, const Bulk& bulk, std::span<const uint32_t> lights) {
    double sum = 0;
    for (const uint32_t index : lights) {
        const LightVector way = program_.lights[index].toward(place, Vec3{0.0});
        if (!(way.distance > 0.0)) continue;
        const auto exit = wall(hit, {place, way.direction}, false, way.distance);
        if (!exit) continue;
        each_light(*exit, {&index, 1}, [&](double cosine, const Rgb& color) {
            // Shadow rays are straight; the length and the slant are those of the bent way (Jensen et al.
            // 2001, 2.4).
            const double bent =
                std::sqrt(std::max(0.0, 1.0 - (1.0 - cosine * cosine) / (bulk.ior * bulk.ior)));
            if (!(bent > 0.0)) return;
            const double length = exit->t * cosine / bent;
            sum += static_cast<double>(color[channel]) * cosine * let_in(cosine, bulk.ior) /
                   (1.0 + seen_cosine / bent) * std::exp(-bulk.extinction[channel] * (depth + length));
        });
    }
    return sum;
}

std::optional<SubsurfaceLight::Passage> SubsurfaceLight::straight_through(const HitPoint& hit,
                                                                          const Vec3& normal,
                                                                          const FinishProgram& finish,
                                                                          const Rgb& pigment, double ior) {
    if (hit.from_inside) return std::nullopt;
    const Bulk bulk = bulk_of(finish, pigment, ior);
    const auto inward = refracted(hit.direction, normal, ior);
    if (!inward) return std::nullopt;
    const auto exit = wall(hit, {hit.point, *inward}, true, infinity);
    if (!exit) return std::nullopt;
    const auto outward = refracted(*inward, -exit->normal, 1.0 / ior);
    if (!outward) return std::nullopt;
    Passage passage{*exit, *outward, Rgb(0.0f)};
    for (int c = 0; c < 3; ++c) passage.left[c] = static_cast<float>(std::exp(-bulk.extinction[c] * exit->t));
    return passage;
}

}  // namespace rb
