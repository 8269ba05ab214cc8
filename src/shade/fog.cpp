#include "shade/fog.h"

#include "patterns/noise.h"

#include <algorithm>
#include <cmath>

namespace rb {

namespace {

/// Mean density of ground fog between two heights above its level, in units of its altitude.
double ground_density(double s, double e) {
    if (s <= 0.0 && e <= 0.0) return 1.0;
    if (s <= 0.0) return (std::atan(e) - s) / (e - s);
    if (e <= 0.0) return (std::atan(s) - e) / (s - e);
    if (std::abs(s - e) <= tiny) return 1.0 / (s * s + 1.0);
    return (std::atan(s) - std::atan(e)) / (s - e);
}

}  // namespace

FogProgram::FogProgram(const std::vector<Fog>& fogs, int noise_generator)
    : noise_generator_(noise_generator) {
    for (const Fog& fog : fogs) {
        if (std::abs(fog.distance) > tiny) fogs_.push_back(fog);
    }
}

/// What is left of light after the fog, before its colour is considered.
double FogProgram::amount(const Fog& fog, const Ray& ray, double length) const {
    double density = 1.0;
    if (fog.type == 2) {
        const double start = (glm::dot(ray.origin, fog.up) - fog.offset) / fog.alt;
        const double end = (glm::dot(ray.at(length), fog.up) - fog.offset) / fog.alt;
        density = ground_density(start, end);
    }
    if (fog.turbulence) {
        const Vec3 p = ray.at(0.5 * length) * fog.turbulence->amount;
        const double t = std::min(1.0, turbulence(p, *fog.turbulence, noise_generator_) * fog.turb_depth);
        length *= 1.0 - std::exp(-length / fog.distance) * t;
    }
    return std::exp(-length * density / fog.distance);
}

AirEffect FogProgram::along(const Ray& ray, double length) const {
    AirEffect effect;
    for (const Fog& fog : fogs_) {
        const auto a = std::max(static_cast<float>(amount(fog, ray, length)), fog.color.transmit);
        effect.attenuation *= a * (Rgb(1.0f - fog.color.filter) + fog.color.filter * fog.color.rgb());
        effect.added += (1.0f - a) * fog.color.rgb();
    }
    return effect;
}

}  // namespace rb
