#include "shade/area_sampler.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace rb {

namespace {

/// 0..count-1 in random order (Fisher and Yates).
std::span<uint16_t> shuffled(int count, uint64_t seed, Scratch::Scope& memory) {
    const auto order = memory.take<uint16_t>(static_cast<size_t>(count));
    for (size_t i = 0; i < order.size(); ++i) {
        order[i] = static_cast<uint16_t>(i);
        seed = seed * 6364136223846793005u + 1442695040888963407u;
        const uint64_t j = ((seed >> 32) * (i + 1)) >> 32;
        std::swap(order[i], order[j]);
    }
    return order;
}

}  // namespace

AreaSampler::AreaSampler(const LightProgram& light, size_t light_index, uint64_t ray_seed,
                         const Vec3& to_center, uint64_t salt, Scratch::Scope& memory)
    : axis1_(light.light().area.axis1), axis2_(light.light().area.axis2) {
    const AreaGrid& grid = light.light().area;
    circular_ = grid.circular;
    if (grid.orient) {
        const double size = glm::length(axis1_);
        const bool along_z = std::abs(std::abs(to_center.z) - 1.0) < 0.01;
        const Vec3 across = along_z ? Vec3{0.0, 1.0, 0.0} : Vec3{0.0, 0.0, 1.0};
        axis1_ = glm::normalize(glm::cross(to_center, across));
        axis2_ = glm::normalize(glm::cross(to_center, axis1_)) * size;
        axis1_ *= size;
    }
    width_ = static_cast<size_t>(grid.size1);
    if (grid.size1 > 1) step1_ = 1.0 / (grid.size1 - 1);
    if (grid.size2 > 1) step2_ = 1.0 / (grid.size2 - 1);
    if (!grid.jitter) return;
    jitter_ = true;
    seed_ = mixed(ray_seed, 16 * light_index + salt);
    row_height_ = 1.0 / grid.size2;
    column_width_ = 1.0 / grid.size1;
    row_order_ = shuffled(grid.size2, seed_, memory);
    column_order_ = shuffled(grid.size1, ~seed_, memory);
}

Vec3 AreaSampler::on_disc(double x, double y) const {
    // Square shells become circles; the small shift keeps the centre away from 0/0.
    const double a = x * step1_ - 0.5 + 0.001;
    const double b = y * step2_ - 0.5 + 0.001;
    const double k = std::max(std::abs(a), std::abs(b)) / std::sqrt(a * a + b * b);
    return axis1_ * (a * k) + axis2_ * (b * k);
}

}  // namespace rb
