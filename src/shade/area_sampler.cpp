#include "shade/area_sampler.h"

#include "shade/random.h"

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
    : light_(light), to_center_(to_center) {
    const AreaGrid& grid = light.light().area;
    if (!grid.jitter) return;
    seed_ = mixed(ray_seed, 16 * light_index + salt);
    row_order_ = shuffled(grid.size2, seed_, memory);
    column_order_ = shuffled(grid.size1, ~seed_, memory);
}

Vec3 AreaSampler::offset(int u, int v) const {
    double x = u;
    double y = v;
    const AreaGrid& grid = light_.light().area;
    if (grid.jitter) {
        const auto column = static_cast<size_t>(u);
        const auto row = static_cast<size_t>(v);
        const uint64_t draw = mixed(seed_, row * column_order_.size() + column);
        const double fine_x = static_cast<double>(draw & 0xFFFFFFFFu) * 0x1p-32;
        const double fine_y = static_cast<double>(draw >> 32) * 0x1p-32;
        x += (row_order_[row] + fine_x) / grid.size2 - 0.5;
        y += (column_order_[column] + fine_y) / grid.size1 - 0.5;
    }
    return light_.area_offset(x, y, to_center_);
}

}  // namespace rb
