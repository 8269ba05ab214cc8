#include "shade/shadow.h"

#include "math/random.h"
#include "shade/media_path.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace rb {

namespace {

float difference(const Rgb& a, const Rgb& b) {
    return std::abs(a.x - b.x) + std::abs(a.y - b.y) + std::abs(a.z - b.z);
}

/// What lies at one end of the way, up to rounding, is not on it. (The reference leaves out 0.001 units,
/// whatever the scene's size.)
constexpr double end_share = 1e-6;
/// Of colours that count as the same, sum over the channels (as in the reference's adaptive grids).
constexpr float agreement = 0.1f;
double shadow_reach(double distance) { return distance * (1.0 - end_share); }

/// How far it is to the object that a light is projected through: what is behind it casts no shadow. Nothing
/// if the ray misses it before the light, which does not shine there then.
[[gnu::noinline]] std::optional<double> way_through(const Geometry& object, const Ray& ray, double distance) {
    if (!(distance > 0.0)) return std::nullopt;
    RayQuery query;
    query.ray = ray;
    query.mask = seen_by_trace;
    query.t_min = distance * end_share;
    query.t_max = shadow_reach(distance);
    Hit hit;
    if (!object.closest(query, hit)) return std::nullopt;
    return hit.t;
}

}  // namespace

Rgb interior_fade(const Interior& interior, double distance) {
    const double s = distance / interior.fade_distance;
    if (interior.fade_power >= 1000.0) {
        const Rgb dim = (Rgb(1.0f) - interior.fade_color) * static_cast<float>(-s);
        return {std::exp(dim.x), std::exp(dim.y), std::exp(dim.z)};
    }
    const auto k = static_cast<float>(1.0 / (1.0 + std::pow(s, interior.fade_power)));
    return interior.fade_color + (Rgb(1.0f) - interior.fade_color) * k;
}

Rgb texture_filter(const TextureProgram& texture, const PatternSamples& place,
                   std::span<const Warp> transform, const Vec3& normal, const Vec3& light_direction,
                   double caustics) {
    Rgb filter(1.0f);
    if (texture.is_patterned()) {
        const TextureMapProgram& map = *texture.map;
        Scratch::Scope memory(thread_scratch());
        const PatternSamples moved = map.moved(place, memory);
        const auto of = [&](size_t k) {
            return texture_filter(map.children[k], moved, transform, normal, light_direction, caustics);
        };
        if (map.average) {
            Rgb sum(0.0f);
            float total = 0;
            for (size_t k = 0; k < map.children.size(); ++k) {
                sum += map.positions.positions[k] * of(k);
                total += map.positions.positions[k];
            }
            return total == 0.0f ? sum : sum / total;
        }
        double value = 0;
        map.field.values(moved, {&value, 1});
        const MapPlace at = map.positions.find(value);
        if (at.first == at.second) return of(at.first);
        const auto t = static_cast<float>(at.t);
        return (1.0f - t) * of(at.first) + t * of(at.second);
    }
    for (const LayerProgram& layer : texture.layers) {
        Color color;
        layer.pigment.evaluate(place, {&color, 1});
        filter *= passed(color);
        const double exponent = layer.finish->finish.caustics ? *layer.finish->finish.caustics : caustics;
        if (exponent == 0.0) continue;
        Vec3 n = normal;
        if (layer.normal) {
            const bool unit_length = !layer.normal->keeps_length();
            normals_into(transform, unit_length, {&n, 1});
            layer.normal->perturb(place, {&n, 1});
            normals_out_of(transform, unit_length, {&n, 1});
        }
        const double c = std::abs(glm::dot(glm::normalize(n), light_direction));
        filter *= static_cast<float>(1.0 + std::pow(c, exponent));
    }
    return filter;
}

/// The atmosphere may take some of a light's light on its way.
bool ShadowTracer::is_dimmed(const Light& light) const {
    return light.media_interaction && light.media_attenuation &&
           (!program_.fog.empty() || program_.media.fills_air());
}

bool ShadowTracer::passes_all(const LightProgram& light, const Candidates* candidates) const {
    if (program_.options.quality < 4) return true;
    if (light.projected_through()) return false;
    if (light.is_shadowless()) return true;
    return candidates && candidates->none() && !is_dimmed(light.light());
}

Rgb ShadowTracer::arriving(size_t light, const HitPoint& hit, const LightVector& to_center, const Rgb& color,
                           const Candidates* candidates) {
    const LightProgram& program = program_.lights[light];
    if (passes_all(program, candidates)) return color;
    if (program.light().is_area) return over_area(light, hit, to_center, color, candidates);
    RayQuery query = StreamState::query_from(hit, to_center.direction, 0.0, program_.shadow_mask);
    return along(program, hit, query, to_center.distance, color, candidates,
                 state_.blockers[program_.first_sample[light]]);
}

/// `query`: from the hit towards the light, with the shadow mask; its t_max and mask are set here.
Rgb ShadowTracer::along(const LightProgram& light, const HitPoint& hit, RayQuery& query, double distance,
                        Rgb color, const Candidates* candidates, uint32_t& blocker) {
    double end = distance;
    if (const Geometry* object = light.projected_through()) {
        const auto passed = way_through(*object, query.ray, distance);
        if (!passed) return Rgb(0.0f);
        if (light.is_shadowless()) return color;
        end = *passed;
    }
    query.t_max = shadow_reach(end);
    if (!(query.t_max > 0.0)) return color;
    if (candidates && candidates->none()) return through_air(light, hit, query.ray, distance, color);
    ++state_.counters.shadow;
    query.mask = program_.shadow_mask;
    if (!program_.geometry.occluded(query, blocker, candidates))
        return through_air(light, hit, query.ray, distance, color);
    constexpr int either = blocks_light | filters_light;
    if ((program_.geometry.leaf(blocker).mask & either) == blocks_light) return Rgb(0.0f);
    // Something clear is in the way; whatever is opaque behind or before it decides first.
    query.mask = blocks_light;
    uint32_t opaque_blocker = no_leaf;
    if (program_.geometry.has(blocks_light) &&
        program_.geometry.occluded(query, opaque_blocker, candidates)) {
        blocker = opaque_blocker;
        return Rgb(0.0f);
    }
    query.mask = filters_light;
    return filtered(light, hit, query, distance, color, candidates);
}

/// All the way to the light, where nothing is between.
Rgb ShadowTracer::through_air(const LightProgram& light, const HitPoint& from, const Ray& ray,
                              double distance, const Rgb& color) {
    if (!is_dimmed(light.light())) return color;
    const PathRay& seen = state_.ray_of(from);
    return color * air_filter(ray, distance, state_.interiors.view(seen.inside), false, seen.seed);
}

/// What a target bends is brought by photons, not by shadow rays.
bool ShadowTracer::is_left_to_photons(const Light& light, const Hit& blocker) const {
    const PhotonRole& role = program_.surface_of(blocker).photons;
    return role.target != no_target && photons_pass(light.photons.ways.refraction, role.ways.refraction);
}

/// `distance`: to the light; what is behind the query's end is air alone.
Rgb ShadowTracer::filtered(const LightProgram& light, const HitPoint& from, RayQuery query, double distance,
                           Rgb color, const Candidates* candidates) {
    const bool dimmed = is_dimmed(light.light());
    const bool collects = program_.shows_photons() && from.collects_photons;
    const uint64_t seed = state_.ray_of(from).seed;
    const auto view = state_.interiors.view(state_.ray_of(from).inside);
    thread_local std::vector<uint32_t> inside;
    inside.assign(view.begin(), view.end());
    Hit hit;
    while (program_.geometry.closest(query, hit, candidates)) {
        if (collects && is_left_to_photons(light.light(), hit)) return Rgb(0.0f);
        color *= filter_of(hit, query.ray, inside);
        if (program_.media.fills_interiors() && !inside.empty()) {
            color *= media_filter(query.ray, hit.t, inside, seed);
        }
        if (dimmed) color *= air_filter(query.ray, hit.t, inside, true, seed);
        if (is_black(color)) return Rgb(0.0f);
        const uint32_t interior = program_.surface_of(hit).interior;
        const auto known = std::find(inside.begin(), inside.end(), interior);
        if (known != inside.end()) {
            inside.erase(known);
        } else {
            inside.push_back(interior);
        }
        query.t_max -= hit.t;
        distance -= hit.t;
        query.ray.origin = hit.point;
        query.origin_leaf = hit.leaf;
        query.origin_part = hit.crossing.part;
        query.origin_member = hit.crossing.member;
        query.origin_error = hit.error;
        if (!(query.t_max > 0.0)) break;
    }
    if (dimmed) color *= air_filter(query.ray, distance, inside, false, seed);
    return color;
}

bool ShadowTracer::are_hollow(std::span<const uint32_t> interiors) const {
    return std::ranges::all_of(interiors, [&](uint32_t i) { return program_.world.interiors[i].hollow; });
}

/// What fog and media in the air leave of light that crosses them within these interiors. Solid ones keep fog
/// out, and media only where the way does not end on a surface (measured).
Rgb ShadowTracer::air_filter(const Ray& ray, double length, std::span<const uint32_t> inside,
                             bool ends_on_surface, uint64_t seed) {
    const bool in_the_open = are_hollow(inside);
    const Rgb past_fog = in_the_open ? program_.fog.along(ray, length).attenuation : Rgb(1.0f);
    if (!program_.media.fills_air() || !(in_the_open || ends_on_surface)) return past_fog;
    program_.media.mix_of_air(mix_);
    return past_fog *
           MediaPath(mix_, ray, mixed(seed, std::bit_cast<uint64_t>(length)), nullptr).attenuation(length);
}

/// The same of media in these interiors.
Rgb ShadowTracer::media_filter(const Ray& ray, double length, std::span<const uint32_t> inside,
                               uint64_t seed) {
    if (!are_hollow(inside)) return Rgb(1.0f);
    program_.media.mix_of(inside, mix_);
    if (mix_.empty()) return Rgb(1.0f);
    return MediaPath(mix_, ray, mixed(seed, std::bit_cast<uint64_t>(length)), nullptr).attenuation(length);
}

Rgb ShadowTracer::filter_of(const Hit& hit, const Ray& ray, std::span<const uint32_t> inside) {
    program_.geometry.surfaces_at(hit, worn_);
    Rgb filter(0.0f);
    for (const auto& [worn, share] : worn_) {
        filter += share * surface_filter(program_.surfaces[worn], hit, ray.direction);
    }
    return filter * fade_of(hit, inside);
}

Rgb ShadowTracer::surface_filter(const SurfaceProgram& surface, const Hit& hit, const Vec3& direction) {
    const bool from_inside = glm::dot(hit.normal, direction) > 0.0;
    const Look& look = program_.looks[from_inside ? surface.interior_look : surface.look];
    const TextureProgram& texture = program_.textures[look.texture];
    const Vec3 normal = from_inside ? -hit.normal : hit.normal;
    Vec2 uv{0.0};
    if (surface.uv_mapping || texture.surface_need != SurfaceNeed::none) uv = program_.geometry.uv(hit);
    Vec3 point = surface.uv_mapping ? Vec3{uv.x, uv.y, 0.0} : hit.point;
    if (!look.transform.empty()) point = std::get<Transform>(look.transform.front()).inverse_point(point);
    const SurfaceSamples samples{{&hit.point, 1}, {&normal, 1}, {&direction, 1}, {&uv, 1}};
    constexpr uint32_t row = 0;
    const double caustics = program_.world.interiors[surface.interior].interior.caustics * 45.0;
    return texture_filter(texture, {{&point, 1}, &samples, {&row, 1}}, look.transform, normal, direction,
                          caustics);
}

struct ShadowTracer::GridCorner {
    int u;
    int v;
    uint32_t index;
};

/// One evaluation of an area light: every grid point is looked at once at most.
struct ShadowTracer::Grid {
    size_t light;
    const HitPoint& hit;
    const AreaSampler& sampler;
    const Rgb& color;
    const Candidates* candidates;
    RayQuery query;
    std::span<Rgb> arrived;
    std::span<uint8_t> known;
    std::span<uint32_t> blockers;
    std::span<LightVector> ways;  ///< to the corners of the cell at hand
    int width;

    GridCorner corner(int u, int v) const { return {u, v, static_cast<uint32_t>(v * width + u)}; }
};

bool ShadowTracer::leaves_for_good(const LightProgram& light, const HitPoint& hit,
                                   const LightVector& to_center) const {
    // Above the surface by a hundredth of a thousandth at the least, from all over the light's area.
    constexpr double least = 1e-5;
    const double height = glm::dot(hit.normal, to_center.direction) * to_center.distance -
                          glm::dot(glm::abs(hit.normal), light.area_reach());
    return hit.leaf != no_leaf && program_.geometry.leaves_for_good(
                                      hit.leaf, !hit.from_inside && height > least * to_center.distance);
}

/// What may be between one point and an area light: many rays go there, so that it pays to look closely.
const Candidates* ShadowTracer::narrowed(const LightProgram& light, const HitPoint& hit,
                                         const LightVector& to_center, const Candidates* wider,
                                         Candidates& memory) const {
    if (!program_.options.skip_unneeded || light.is_directed()) return wider;
    const Vec3& center = light.light().location;
    const RayBundle bundle = RayBundle::between({hit.point, hit.point},
                                                {center - light.area_reach(), center + light.area_reach()});
    const uint32_t left = leaves_for_good(light, hit, to_center) ? hit.leaf : no_leaf;
    if (wider) {
        program_.geometry.candidates(*wider, bundle, left, memory);
        return &memory;
    }
    return program_.geometry.candidates(bundle, program_.shadow_mask, left, memory) ? &memory : nullptr;
}

Rgb ShadowTracer::over_area(size_t light, const HitPoint& hit, const LightVector& to_center, const Rgb& color,
                            const Candidates* candidates) {
    const AreaGrid& area = program_.lights[light].light().area;
    Candidates memory_of_candidates;
    candidates = narrowed(program_.lights[light], hit, to_center, candidates, memory_of_candidates);
    if (passes_all(program_.lights[light], candidates)) return color;
    const AreaSampler sampler(program_.lights[light],
                              StreamState::light_seed(state_.ray_of(hit), hit, light, 0),
                              to_center.direction);
    if (program_.lights[light].samples_by_pattern())
        return over_pattern(light, hit, sampler, color, candidates);
    Scratch::Scope memory(thread_scratch());
    const size_t count = program_.lights[light].sample_count();
    Grid grid{light,
              hit,
              sampler,
              color,
              candidates,
              StreamState::query_from(hit, to_center.direction, 0.0, program_.shadow_mask),
              memory.take<Rgb>(count),
              memory.take<uint8_t>(count, uint8_t{0}),
              std::span(state_.blockers).subspan(program_.first_sample[light], count),
              memory.take<LightVector>(4),
              area.size1};
    return grid_cell(grid, 0, 0, area.size1 - 1, area.size2 - 1, 0);
}

/// The mean over the light's pattern. What proves to lie in full shadow, and what the first samples agree
/// about, is not sampled to the end.
Rgb ShadowTracer::over_pattern(size_t index, const HitPoint& hit, const AreaSampler& sampler,
                               const Rgb& color, const Candidates* candidates) {
    constexpr uint32_t at_once = 4;
    const LightProgram& light = program_.lights[index];
    const uint32_t count = light.sample_count();
    const auto blockers = std::span(state_.blockers).subspan(program_.first_sample[index], count);
    RayQuery query = StreamState::query_from(hit, Vec3{0.0}, 0.0, program_.shadow_mask);
    std::array<Vec3, at_once> offsets;
    std::array<LightVector, at_once> ways;
    Rgb sum(0.0f);
    Rgb least(std::numeric_limits<float>::infinity());
    Rgb most = -least;
    // Full light is exactly full light.
    const auto mean = [&](uint32_t n) { return least == most ? least : sum / static_cast<float>(n); };
    bool may_stop = true;
    for (uint32_t begin = 0; begin < count; begin += at_once) {
        const uint32_t n = std::min(at_once, count - begin);
        for (uint32_t k = 0; k < n; ++k) offsets[k] = sampler.pattern_place(begin + k);
        light.toward(hit.point, std::span(offsets).first(n), ways);
        for (uint32_t k = 0; k < n; ++k) {
            query.ray.direction = ways[k].direction;
            const Rgb arrived =
                along(light, hit, query, ways[k].distance, color, candidates, blockers[begin + k]);
            sum += arrived;
            least = glm::min(least, arrived);
            most = glm::max(most, arrived);
        }
        const uint32_t taken = begin + n;
        if (begin == 0 && is_black(most) && is_in_umbra(light, hit, sampler, blockers.first(n), candidates))
            return Rgb(0.0f);
        if (!may_stop || taken < light.pilot_count() || taken == count) continue;
        may_stop = difference(least, most) <= agreement &&
                   corners_agree(index, hit, sampler, color, candidates, least, most);
        if (may_stop) return mean(taken);
    }
    return mean(count);
}

/// True if the light of the corners, too, is between `least` and `most`, or nearly: the edge of a shadow
/// shows there first, while it is on few of the places between them.
bool ShadowTracer::corners_agree(size_t index, const HitPoint& hit, const AreaSampler& sampler,
                                 const Rgb& color, const Candidates* candidates, const Rgb& least,
                                 const Rgb& most) {
    const LightProgram& light = program_.lights[index];
    RayQuery query = StreamState::query_from(hit, Vec3{0.0}, 0.0, program_.shadow_mask);
    uint32_t blocker = state_.blockers[program_.first_sample[index]];
    return std::ranges::all_of(sampler.hull(), [&](const Vec3& corner) {
        const LightVector way = light.toward(hit.point, corner);
        query.ray.direction = way.direction;
        const Rgb arrived = along(light, hit, query, way.distance, color, candidates, blocker);
        return difference(glm::min(least, arrived), glm::max(most, arrived)) <= agreement;
    });
}

/// True if one convex body hides all of the light: it does so if it hides the corners of a parallelogram
/// around it, since what a convex body hides of a plane is convex. `blockers`: of some samples, all of which
/// are hidden.
bool ShadowTracer::is_in_umbra(const LightProgram& light, const HitPoint& hit, const AreaSampler& sampler,
                               std::span<const uint32_t> blockers, const Candidates* candidates) {
    if (!program_.options.skip_unneeded || light.is_directed() || light.projected_through()) return false;
    const uint32_t body = blockers.front();
    if (body == no_leaf || body == hit.leaf) return false;
    if (std::ranges::any_of(blockers, [&](uint32_t b) { return b != body; })) return false;
    if (!program_.geometry.is_convex_body(body, hit.point)) return false;
    for (const Vec3& corner : sampler.hull()) {
        const LightVector way = light.toward(hit.point, corner);
        RayQuery query =
            StreamState::query_from(hit, way.direction, shadow_reach(way.distance), blocks_light);
        uint32_t blocker = body;
        ++state_.counters.shadow;
        if (!program_.geometry.occluded(query, blocker, candidates) || blocker != body) return false;
    }
    return true;
}

/// Finds out what arrives from the corners of a cell, as far as it is not known. Their directions are worked
/// out together, so that roots and divisions overlap.
void ShadowTracer::look_at_corners(Grid& grid, const std::array<GridCorner, 4>& corners) {
    const LightProgram& light = program_.lights[grid.light];
    std::array<uint32_t, 4> unknown;
    std::array<Vec3, 4> offsets;
    size_t count = 0;
    for (const GridCorner& corner : corners) {
        // The corners of a narrow cell are the same.
        if (grid.known[corner.index]) continue;
        grid.known[corner.index] = 1;
        unknown[count] = corner.index;
        offsets[count++] = grid.sampler.grid_place(corner.u, corner.v);
    }
    if (count == 0) return;
    light.toward(grid.hit.point, std::span(offsets).first(count), grid.ways);
    for (size_t k = 0; k < count; ++k) {
        grid.query.ray.direction = grid.ways[k].direction;
        grid.arrived[unknown[k]] = along(light, grid.hit, grid.query, grid.ways[k].distance, grid.color,
                                         grid.candidates, grid.blockers[unknown[k]]);
    }
}

Rgb ShadowTracer::grid_cell(Grid& grid, int u1, int v1, int u2, int v2, int level) {
    const std::array<GridCorner, 4> corners{grid.corner(u1, v1), grid.corner(u2, v1), grid.corner(u1, v2),
                                            grid.corner(u2, v2)};
    look_at_corners(grid, corners);
    Rgb s0 = grid.arrived[corners[0].index];
    Rgb s1 = grid.arrived[corners[1].index];
    Rgb s2 = grid.arrived[corners[2].index];
    Rgb s3 = grid.arrived[corners[3].index];
    if (u2 - u1 > 1 || v2 - v1 > 1) {
        constexpr float threshold = 0.1f;
        const bool differ = difference(s0, s1) > threshold || difference(s1, s3) > threshold ||
                            difference(s3, s2) > threshold || difference(s2, s0) > threshold;
        if (level < program_.lights[grid.light].light().area.adaptive || differ) {
            const int u_low = (u1 + u2) / 2;
            const int u_high = (u1 + u2 + 1) / 2;
            const int v_low = (v1 + v2) / 2;
            const int v_high = (v1 + v2 + 1) / 2;
            s0 = grid_cell(grid, u1, v1, u_low, v_low, level + 1);
            s1 = grid_cell(grid, u_high, v1, u2, v_low, level + 1);
            s2 = grid_cell(grid, u1, v_high, u_low, v2, level + 1);
            s3 = grid_cell(grid, u_high, v_high, u2, v2, level + 1);
        }
    }
    // In pairs: equal parts give exactly their value.
    return 0.25f * ((s0 + s1) + (s2 + s3));
}

}  // namespace rb
