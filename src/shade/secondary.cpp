#include "shade/secondary.h"

#include "math/random.h"
#include "shade/shadow.h"
#include "shade/spectrum.h"

#include <algorithm>
#include <cmath>

namespace rb {

namespace {

constexpr double straight = 1e-10;

Rgb raised(const Rgb& c, float power) {
    return {std::pow(c.x, power), std::pow(c.y, power), std::pow(c.z, power)};
}

}  // namespace

/// What changes where a ray passes a surface.
struct SecondaryRays::Crossing {
    InteriorList inside;
    double eta = 1;         ///< ratio of the indices of refraction
    double dispersion = 1;  ///< ratio of the dispersions
    int samples = 7;
};

double SecondaryRays::relative_ior(const HitPoint& hit, const FinishProgram& finish) const {
    const auto list = state_.interiors.view(state_.ray_of(hit).inside);
    const double ior =
        finish.finish.ior ? static_cast<double>(*finish.finish.ior) : program_.ior_of(hit.interior);
    if (list.empty()) return ior;
    const bool leaves = std::find(list.begin(), list.end(), hit.interior) != list.end();
    if (!leaves) return ior / program_.ior_of(list.back());
    return list.size() == 1 ? 1.0 / ior : program_.ior_of(list.back()) / ior;
}

SecondaryRays::Crossing SecondaryRays::crossing_of(const HitPoint& hit, const FinishProgram& finish) {
    const InteriorList current = state_.ray_of(hit).inside;
    const auto list = state_.interiors.view(current);
    const Interior& own = program_.world.interiors[hit.interior].interior;
    const double ior =
        finish.finish.ior ? static_cast<double>(*finish.finish.ior) : program_.ior_of(hit.interior);
    const double dispersion = own.ior == 0.0 ? 1.0 : own.dispersion;
    const auto other = [this](uint32_t interior) {
        const Interior& i = program_.world.interiors[interior].interior;
        return i.ior == 0.0 ? 1.0 : i.dispersion;
    };

    Crossing crossing;
    crossing.samples = own.dispersion_samples;
    const auto found = std::find(list.begin(), list.end(), hit.interior);
    if (found == list.end()) {
        const double outer_ior = list.empty() ? 1.0 : program_.ior_of(list.back());
        const double outer_dispersion = list.empty() ? 1.0 : other(list.back());
        crossing.eta = outer_ior / ior;
        crossing.dispersion = outer_dispersion / dispersion;
        crossing.inside = state_.interiors.with(current, hit.interior);
        return crossing;
    }
    const auto position = static_cast<size_t>(found - list.begin());
    if (position + 1 == list.size()) {
        const bool into_other = list.size() > 1;
        const uint32_t outer = into_other ? list[list.size() - 2] : 0;
        crossing.eta = ior / (into_other ? program_.ior_of(outer) : 1.0);
        crossing.dispersion = dispersion / (into_other ? other(outer) : 1.0);
        if (into_other) {
            crossing.samples =
                std::max(crossing.samples, program_.world.interiors[outer].interior.dispersion_samples);
        }
    }
    crossing.inside = state_.interiors.without(current, position);
    return crossing;
}

/// Starts a ray in the next wave. Until keep_or_drop() it is the last one there.
PathRay& SecondaryRays::add_child(const HitPoint& hit, Draw draw) {
    const PathRay& parent = state_.ray_of(hit);
    PathRay& ray = state_.next.emplace_back(parent);
    ray.ray.origin = hit.point;
    ray.origin_leaf = hit.leaf;
    ray.origin_part = hit.part;
    ray.origin_member = hit.member;
    ray.origin_error = hit.error;
    ray.weight = hit.weight;
    ray.alpha = hit.alpha;
    ray.seed = mixed(parent.seed, draw);
    // Of photons going straight on costs a level, too (measured).
    const bool is_free = parent.continuation && !state_.carries_photons;
    ray.level = static_cast<uint16_t>(parent.level + (is_free ? 0 : 1));
    ray.continuation = false;
    return ray;
}

bool SecondaryRays::worth_following(const PathRay& ray) const {
    return ray.level < state_.limits.max_trace_level && !(ray.importance < state_.limits.adc_bailout);
}

bool SecondaryRays::keep_or_drop(const PathRay& ray) {
    if (!worth_following(ray)) {
        state_.next.pop_back();
        return false;
    }
    ++(ray.reflected ? state_.counters.reflected : state_.counters.refracted);
    return true;
}

bool SecondaryRays::transmit(const HitPoint& hit, const Transmission& what) {
    const PathRay& parent = state_.ray_of(hit);
    const Crossing crossing = crossing_of(hit, *what.finish);
    PathRay& ray = add_child(hit, draw_transmitted_ray);
    ray.refracted = true;
    ray.importance = parent.importance *
                     std::max({std::abs(what.filter.x), std::abs(what.filter.y), std::abs(what.filter.z)});
    Rgb fade(what.finish->finish.refraction);
    const Interior& interior = program_.world.interiors[hit.interior].interior;
    const auto list = state_.interiors.view(parent.inside);
    // Photons have faded when they arrive.
    if (!state_.carries_photons && std::abs(interior.fade_distance) > straight &&
        std::find(list.begin(), list.end(), hit.interior) != list.end()) {
        fade *= interior_fade(interior, hit.t);
    }
    ray.weight *= fade * what.share;
    ray.alpha *= std::abs(grey(fade)) * what.through * what.share;
    ray.inside = crossing.inside;

    if (std::abs(crossing.dispersion - 1.0) >= straight) {
        if (ray.wavelength == 0.0f) {
            disperse(hit, what, crossing);
            return false;
        }
        const double shift = -(static_cast<double>(ray.wavelength) - 555.0) / 350.0;
        return bend(hit, what, crossing, crossing.eta * std::pow(crossing.dispersion, shift), ray);
    }
    if (std::abs(crossing.eta - 1.0) < straight) {
        ray.continuation = true;
        ray.weight *= what.filter;
        keep_or_drop(ray);
        return false;
    }
    return bend(hit, what, crossing, crossing.eta, ray);
}

bool SecondaryRays::bend(const HitPoint& hit, const Transmission& what, const Crossing& crossing, double eta,
                         PathRay& ray) {
    const Vec3& d = hit.direction;
    const double along = glm::dot(d, what.normal);
    const Vec3 m = along > 0.0 ? -what.normal : what.normal;
    const double c = std::abs(along);
    const double k = 1.0 + eta * eta * (c * c - 1.0);
    if (k < 0.0) {
        ray.inside = state_.ray_of(hit).inside;
        mirror_inside(hit, what, ray);
        return true;
    }
    ray.ray.direction = glm::normalize(eta * d + (eta * c - std::sqrt(k)) * m);
    ray.inside = crossing.inside;
    ray.weight *= what.filter;
    keep_or_drop(ray);
    return false;
}

void SecondaryRays::mirror_inside(const HitPoint& hit, const Transmission& what, PathRay& ray) {
    ray.ray.direction = mirrored(hit.direction, what.normal, hit.normal);
    ray.weight *= film(hit, *what.finish, what.normal, ray.ray.direction);
    ray.alpha = 0;
    ray.reflected = true;
    keep_or_drop(ray);
}

/// Makes one ray per band out of the last one.
void SecondaryRays::disperse(const HitPoint& hit, const Transmission& what, const Crossing& crossing) {
    const PathRay ray = state_.next.back();
    state_.next.pop_back();
    const int samples = std::max(crossing.samples, 2);
    const double width = 350.0 / samples;
    for (int i = 0; i < samples; ++i) {
        const double wavelength = 380.0 + 350.0 * (i + 0.5) / samples;
        PathRay& band = state_.next.emplace_back(ray);
        band.seed = mixed(ray.seed, draw_bands + static_cast<uint64_t>(i));
        band.alpha = 0;
        band.weight *= band_hue(wavelength, width) / static_cast<float>(samples);
        const double eta = crossing.eta * std::pow(crossing.dispersion, -(wavelength - 555.0) / 350.0);
        const double c = glm::dot(hit.direction, what.normal);
        if (1.0 + eta * eta * (c * c - 1.0) < 0.0) {
            // A mirrored band is not single-coloured: it may split again at the next surface.
            band.weight *= what.filter;
            band.inside = state_.ray_of(hit).inside;
            mirror_inside(hit, what, band);
            continue;
        }
        band.wavelength = static_cast<float>(wavelength);
        bend(hit, what, crossing, eta, band);
    }
}

Rgb SecondaryRays::film(const HitPoint& hit, const FinishProgram& finish, const Vec3& normal,
                        const Vec3& out) const {
    if (!(finish.finish.irid_amount > 0.0f) || state_.carries_photons) return Rgb(1.0f);
    const double thickness = film_thickness(finish, hit.point, program_.patterns.noise_generator);
    const double cosines = std::abs(glm::dot(normal, out)) + std::abs(glm::dot(normal, hit.direction));
    return iridescence(finish, program_.world.settings.irid_wavelength, thickness, cosines);
}

void SecondaryRays::pass_on(const HitPoint& hit, const HitPoint& exit, const Vec3& direction,
                            const Rgb& weight) {
    PathRay& ray = add_child(hit, draw_passing_ray);
    ray.ray = {exit.point, direction};
    ray.origin_leaf = exit.leaf;
    ray.origin_part = exit.part;
    ray.origin_member = exit.member;
    ray.origin_error = exit.error;
    ray.refracted = true;
    ray.importance = state_.ray_of(hit).importance * std::max({weight.x, weight.y, weight.z});
    ray.weight *= weight;
    ray.alpha = 0;
    keep_or_drop(ray);
}

void SecondaryRays::reflect(const HitPoint& hit, const MirrorRecord& mirror) {
    PathRay& ray = add_child(hit, draw_reflected_ray);
    ray.ray.direction = mirrored(hit.direction, mirror.normal, hit.normal);
    ray.importance = mirror.importance;
    ray.reflected = true;
    ray.alpha = 0;
    if (!keep_or_drop(ray)) return;
    const Rgb tint = film(hit, *mirror.finish, mirror.normal, ray.ray.direction);
    const float exponent = mirror.finish->finish.reflection.exponent;
    const Rgb weight = ray.weight * mirror.amount * mirror.share;
    if (exponent == 1.0f) {
        ray.weight = weight * tint;
    } else if (state_.carries_photons) {
        ray.weight = raised(ray.weight, 1.0f / exponent) * mirror.amount * mirror.share;
    } else {
        const auto slot = static_cast<uint32_t>(state_.slots.size());
        state_.slots.emplace_back();
        state_.power_slots.push_back({slot, ray.slot, weight, 1.0f / exponent});
        ray.slot = slot;
        ray.weight = tint;
    }
}

}  // namespace rb
