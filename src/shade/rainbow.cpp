#include "shade/rainbow.h"

#include "math/random.h"
#include "shade/draws.h"

#include <algorithm>
#include <cmath>

namespace rb {

RainbowProgram::RainbowProgram(const std::vector<Rainbow>& rainbows) {
    for (const Rainbow& rainbow : rainbows) {
        if (!rainbow.color_map || rainbow.color_map->empty() || rainbow.distance == 0.0) continue;
        Arc arc{rainbow, MapPositions::of(*rainbow.color_map), {}, {}};
        arc.rainbow.direction = glm::normalize(rainbow.direction);
        arc.right = glm::normalize(glm::cross(rainbow.up, arc.rainbow.direction));
        arc.up = glm::cross(arc.rainbow.direction, arc.right);
        arcs_.push_back(std::move(arc));
    }
}

AirEffect RainbowProgram::along(const Ray& ray, double length, uint64_t seed) const {
    AirEffect sum{Rgb(0.0f), Rgb(0.0f)};
    float count = 0.0f;
    for (size_t i = 0; i < arcs_.size(); ++i) {
        const double jitter = 2.0 * unit_random(mixed(seed, draw_rainbows + i)) - 1.0;
        const auto effect = met(arcs_[i], ray, length, jitter);
        if (!effect) continue;
        sum.attenuation += effect->attenuation;
        sum.added += effect->added;
        count += 1.0f;
    }
    if (count == 0.0f) return {};
    return {sum.attenuation / count, sum.added / count};
}

std::optional<AirEffect> RainbowProgram::met(const Arc& arc, const Ray& ray, double length, double jitter) {
    const Rainbow& r = arc.rainbow;
    const double x = glm::dot(ray.direction, arc.right);
    double y = glm::dot(ray.direction, arc.up);
    const double across = std::hypot(x, y);
    if (across > 0.0) y /= across;
    const double from_top = std::abs(std::acos(std::clamp(y, -1.0, 1.0)));
    if (from_top > r.arc_angle / 2.0) return std::nullopt;
    const double along = glm::dot(ray.direction, r.direction);
    if (along < 0.0) return std::nullopt;
    const double place =
        (std::acos(std::min(along, 1.0)) - r.angle + r.width / 2.0) / r.width + jitter * r.jitter;
    constexpr double outer_edge = 1.0 - 1e-10;
    if (!(place >= 0.0 && place <= outer_edge)) return std::nullopt;
    const MapPlace found = arc.map.find(place);
    const ColorMap& map = *r.color_map;
    const auto t = static_cast<float>(found.t);
    const Color color = map[found.first].value * (1.0f - t) + map[found.second].value * t;
    double fade = 0.0;
    if (from_top > r.falloff_angle / 2.0 && r.falloff_angle < r.arc_angle) {
        const double f = (2.0 * from_top - r.falloff_angle) / (r.arc_angle - r.falloff_angle);
        fade = f * f * (3.0 - 2.0 * f);
    }
    const auto least = static_cast<float>(fade) * (1.0f - color.transmit) + color.transmit;
    const float k = std::max(static_cast<float>(std::exp(-length / r.distance)), least);
    const float q = color.filter * (1.0f - k);
    return AirEffect{k * (Rgb(1.0f - q) + q * color.rgb()), (1.0f - k) * color.rgb()};
}

}  // namespace rb
