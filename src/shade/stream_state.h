#pragma once
#include "math/random.h"
#include "shade/integrator.h"
#include "shade/shading_program.h"

#include <bit>
#include <vector>

namespace rb {

/// Interiors that contain a ray, in the order in which it entered them; a view into an InteriorPool.
struct InteriorList {
    uint32_t first = 0;
    uint32_t count = 0;
};

/// Holds the interior lists of all rays of one batch. Lists are immutable; changing one makes another.
class InteriorPool {
public:
    void clear() { items_.clear(); }
    std::span<const uint32_t> view(InteriorList list) const {
        return std::span(items_).subspan(list.first, list.count);
    }
    InteriorList add(std::span<const uint32_t> items);
    InteriorList with(InteriorList list, uint32_t interior);
    InteriorList without(InteriorList list, size_t position);

private:
    std::vector<uint32_t> items_;
};

/// A ray on its way, carrying what the light that it finds counts for. Whitted shading is linear in that
/// light, so nothing has to wait for it.
struct PathRay {
    PathRay() {}  // NOLINT: a defaulted one would first fill all of it with zeros

    Ray ray;
    double origin_error = 0;
    uint32_t origin_leaf = no_leaf;
    uint32_t origin_part = any_part;
    uint32_t origin_member = 0;
    uint32_t slot = 0;     ///< where its light is added up
    Rgb weight{1.0f};      ///< factor for its light
    float alpha = 1;       ///< factor for its transmit
    float importance = 1;  ///< what adc_bailout is compared with
    float share = 1;       ///< as CameraRay::share
    float wavelength = 0;  ///< nm; 0: all of them
    InteriorList inside;
    uint64_t seed = 0;
    uint16_t level = 0;
    bool reflected = false;
    bool refracted = false;
    bool continuation = false;  ///< it went on straight, which costs no level
};

/// Where a ray of the current wave met a surface.
struct HitPoint {
    HitPoint() {}  // NOLINT: as above

    Vec3 point{0.0};
    Vec3 normal{0.0};  ///< unit, turned towards the ray
    Vec3 direction{0.0};
    double t = 0;
    double error = 0;
    uint32_t ray = 0;  ///< index into the wave
    uint32_t leaf = no_leaf;
    uint32_t part = any_part;
    uint32_t member = 0;
    uint32_t look = 0;
    uint32_t interior = 0;
    Rgb weight{1.0f};  ///< of its light, after the atmosphere on the way to the eye
    float alpha = 1;
    bool uv_mapping = false;
    bool double_illuminate = false;
    bool from_inside = false;  ///< the normal was turned
    bool collects_photons = true;
};

/// Light added up for a pixel, or for a mirror whose light is raised to a power before it counts.
struct LightSlot {
    Rgb rgb{0.0f};
    float transmit = 0;
};
struct PowerSlot {
    uint32_t slot = 0;
    uint32_t parent = 0;
    Rgb weight{1.0f};
    float power = 1;
};

/// How far rays are followed.
struct RayLimits {
    int max_trace_level = 5;
    float adc_bailout = 1.0f / 255.0f;
};

/// Where photons may go from a hit.
struct PhotonPermit {
    bool refraction = false;
    bool reflection = false;
};

/// The working state of one Integrator::trace call.
struct StreamState {
    std::vector<PathRay> rays;
    std::vector<PathRay> next;
    std::vector<HitPoint> hits;
    std::vector<LightSlot> slots;
    std::vector<PowerSlot> power_slots;
    InteriorPool interiors;
    double reach = 0;                         ///< length of the current wave's rays
    const IndirectLight* indirect = nullptr;  ///< asked for the indirect light of hits; or null
    int depth = 0;                            ///< diffuse surfaces between the hits and the eye
    std::vector<uint32_t> look_counts;        ///< all 0 between waves
    std::vector<uint32_t> blockers;           ///< per light sample, the leaf that blocked it last
    RayCounters counters;
    RayLimits limits;

    /// False where only the ways of rays matter: what they meet is not lit.
    bool wants_light = true;
    /// The rays come from lights: their weight is the light that they bring.
    bool carries_photons = false;
    std::vector<PhotonPermit> permits;  ///< of the hits, with `carries_photons`

    // Surface samples of the hits, for patterns that ask.
    std::vector<Vec3> points;
    std::vector<Vec3> seen_normals;
    std::vector<Vec3> directions;
    std::vector<Vec2> uv;
    SurfaceSamples samples() const { return {points, seen_normals, directions, uv}; }

    /// A ray's question. Field by field: a copy would wait for what has only just been stored.
    static void ask(const PathRay& ray, RayMask mask, RayQuery& query) {
        query.ray = ray.ray;
        query.mask = mask;
        query.origin_leaf = ray.origin_leaf;
        query.origin_part = ray.origin_part;
        query.origin_member = ray.origin_member;
        query.origin_error = ray.origin_error;
    }

    /// From a hit along a direction.
    static RayQuery query_from(const HitPoint& hit, const Vec3& direction, double t_max, RayMask mask) {
        RayQuery query{{hit.point, direction}, t_max, mask, hit.leaf, hit.error};
        query.origin_part = hit.part;
        query.origin_member = hit.member;
        return query;
    }

    /// True if nothing solid contains the ray, so that the atmosphere acts on it.
    bool in_the_open(const World& world, InteriorList inside) const {
        for (const uint32_t interior : interiors.view(inside)) {
            if (!world.interiors[interior].hollow) return false;
        }
        return true;
    }

    /// Decides the random draws for a light at a hit; `salt` tells several uses of the same light apart.
    static uint64_t light_seed(const PathRay& ray, const HitPoint& hit, size_t light, uint64_t salt) {
        return mixed(mixed(ray.seed, 16 * light + salt), std::bit_cast<uint64_t>(hit.t));
    }

    const PathRay& ray_of(const HitPoint& hit) const { return rays[hit.ray]; }

    bool may_refract(uint32_t hit) const { return !carries_photons || permits[hit].refraction; }
    bool may_reflect(uint32_t hit) const { return !carries_photons || permits[hit].reflection; }
};

}  // namespace rb
