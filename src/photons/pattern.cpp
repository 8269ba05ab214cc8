#include "photons/pattern.h"

#include "math/basis.h"
#include "shade/area_sampler.h"

#include <algorithm>
#include <cmath>

namespace rb {

namespace {

/// What the random numbers of a pattern are drawn for.
enum Purpose : uint64_t { purpose_start = 1, purpose_turn, purpose_angle, purpose_area };

/// Photons with less of the light's cone are not sent.
constexpr double least_cone = 1e-5;

}  // namespace

PhotonPattern::PhotonPattern(const LightProgram& light, const PhotonTarget& target, double spacing,
                             const PhotonSettings& settings, uint64_t seed)
    : light_(light), jitter_(settings.jitter), seed_(seed) {
    const bool ends = target.box.is_finite();
    if (ends) center_ = 0.5 * (target.box.lo + target.box.hi);
    const double radius = ends ? 0.5 * glm::length(target.box.size()) : 2e10;
    const double distance = glm::length(center_ - light.light().location);
    const bool from_area = light.light().is_area && light.light().photons.from_area;
    if (from_area) samples_ = light.grid_count();
    spread_ = spacing * std::sqrt(static_cast<double>(samples_));
    if (light.is_directed()) {
        step_ = spread_;
        end_ = radius;
    } else {
        if (distance > 0.0) spread_ /= distance;
        step_ = std::atan(spread_);
        end_ = radius < distance ? std::asin(radius / distance) : pi;
    }
    stop_angle_ = settings.autostop * end_;
    ring_count_ = std::ceil(end_ / step_);
}

double PhotonPattern::start_count() const {
    const double area = light_.is_directed() ? pi * end_ * end_ : 2.0 * pi * (1.0 - std::cos(end_));
    return samples_ * area / (step_ * step_);
}

double PhotonPattern::turn_step(uint32_t ring) const {
    const double angle = ring * step_;
    return step_ / (light_.is_directed() ? angle : std::sin(angle));
}

uint32_t PhotonPattern::ring_size(uint32_t ring) const {
    if (ring == 0) return 1;
    return static_cast<uint32_t>(std::max(1.0, std::ceil(2.0 * pi / turn_step(ring) - 0.5)));
}

bool PhotonPattern::start(uint32_t ring, uint32_t place, uint32_t sample, PhotonStart& out) const {
    const uint64_t ring_seed = mixed(seed_, ring);
    const auto draw = [](uint64_t seed, Purpose purpose) { return unit_random(mixed(seed, purpose)); };
    double turn = 0;
    double angle = ring * step_;
    if (ring > 0) {
        const double turn_width = turn_step(ring);
        const uint64_t own_seed = mixed(ring_seed, (uint64_t{place} << 24) + sample + 0x100);
        turn = -pi + turn_width * (0.5 * draw(ring_seed, purpose_start) + place);
        turn += turn_width * (draw(own_seed, purpose_turn) - 0.5) * jitter_;
        angle += step_ * (draw(own_seed, purpose_angle) - 0.5) * jitter_;
    }
    Vec3 offset{0.0};
    if (samples_ > 1) offset = place_on_area(sample, mixed(mixed(ring_seed, purpose_area), place));
    out.ray = ray_at(angle, turn, offset);
    out.ring = ring;
    out.passed = 0;
    const LightVector back{-out.ray.direction, 1.0};
    const double cone = light_.cone(out.ray.at(1.0), back);
    if (cone < least_cone) return false;
    out.color = light_.color() * static_cast<float>(cone / samples_);
    return true;
}

/// With `jitter` the cells of the grid share the samples evenly.
Vec3 PhotonPattern::place_on_area(uint32_t sample, uint64_t seed) const {
    const AreaGrid& grid = light_.light().area;
    const AreaSampler sampler(light_, seed, glm::normalize(light_.light().location - center_));
    if (grid.jitter) return sampler.even_place(sample);
    const auto width = static_cast<uint32_t>(grid.size1);
    return sampler.grid_place(static_cast<int>(sample % width), static_cast<int>(sample / width));
}

Ray PhotonPattern::ray_at(double angle, double turn, const Vec3& offset) const {
    const Vec3 source = light_.light().location + offset;
    if (light_.is_directed()) {
        const Vec3 axis = -light_.toward(center_, offset).direction;
        const Vec3 place = center_ + angle * Across(axis).at(turn);
        return {place - glm::dot(place - source, axis) * axis, axis};
    }
    const Vec3 to_center = center_ - source;
    const double distance = glm::length(to_center);
    const Vec3 axis = distance > 0.0 ? to_center / distance : Vec3{0.0, 0.0, 1.0};
    return {source, std::cos(angle) * axis + std::sin(angle) * Across(axis).at(turn)};
}

}  // namespace rb
