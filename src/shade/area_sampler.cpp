#include "shade/area_sampler.h"

#include <algorithm>
#include <cmath>

namespace rb {

AreaSampler::AreaSampler(const LightProgram& light, uint64_t seed, const Vec3& to_center)
    : light_(light),
      axis1_(light.light().area.axis1),
      axis2_(light.light().area.axis2),
      step_(light.grid_step()),
      circular_(light.light().area.circular),
      evenly_(light.is_even()),
      seed_(seed) {
    if (!light.light().area.orient) return;
    const double size = glm::length(axis1_);
    const bool along_z = std::abs(std::abs(to_center.z) - 1.0) < 0.01;
    const Vec3 across = along_z ? Vec3{0.0, 1.0, 0.0} : Vec3{0.0, 0.0, 1.0};
    axis1_ = glm::normalize(glm::cross(to_center, across));
    axis2_ = glm::normalize(glm::cross(to_center, axis1_)) * size;
    axis1_ *= size;
}

/// Square shells become circles, angles stay (so that there is more light along the axes than between them).
Vec3 AreaSampler::on_disc(const Vec2& p) const {
    // As in the reference: keeps the centre away from 0/0.
    constexpr double off_center = 0.001;
    const Vec2 q = p * step_ - 0.5 + off_center;
    const double k = std::max(std::abs(q.x), std::abs(q.y)) / glm::length(q);
    return axis1_ * (q.x * k) + axis2_ * (q.y * k);
}

Vec3 AreaSampler::on_even_disc(const Vec2& p) const {
    const double radius = 0.5 * std::sqrt(p.x * step_.x);
    const double angle = 2.0 * pi * p.y * step_.y;
    return axis1_ * (radius * std::cos(angle)) + axis2_ * (radius * std::sin(angle));
}

std::array<Vec3, 4> AreaSampler::hull() const {
    const Vec2 reach = light_.area_share();
    const Vec3 a = axis1_ * reach.x;
    const Vec3 b = axis2_ * reach.y;
    return {-a - b, a - b, b - a, a + b};
}

}  // namespace rb
