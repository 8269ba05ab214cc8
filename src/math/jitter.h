#pragma once
#include "math/shuffle.h"
#include "math/vec.h"

namespace rb {

extern const std::array<float, 256> jitter_table;

/// The reference's repeatable jitter at a picture position: both components in [-0.5, 0.5) (shading
/// spec 12.2).
inline Vec2 position_jitter(double x, double y) {
    const auto component = [](double a, double b) {
        const auto first = static_cast<uint32_t>(static_cast<int32_t>(a)) & 4095u;
        const auto second = static_cast<uint32_t>(static_cast<int32_t>(b));
        const uint32_t place = shuffled_hash[(shuffled_hash[first] ^ second) & 4095u] & 255u;
        return static_cast<double>(jitter_table[place]);
    };
    return {component(x * 1021.0, y * 1019.0), component(x * 1019.0, y * 1021.0)};
}

}  // namespace rb
