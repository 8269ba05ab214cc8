#pragma once
#include <array>
#include <cstddef>
#include <cstdint>

namespace rb {

/// One step of the linear congruential generator behind the language's tables; returns the 15 bits that it
/// uses (textures spec 0).
constexpr uint32_t lcg_step(uint32_t& state) {
    state = state * 1812433253u + 12345u;
    return (state >> 16) & 0x7FFFu;
}

using ShuffledHash = std::array<uint16_t, 4096>;

/// The numbers 0..4095 in the order on which noise, antialiasing jitter and focal blur rest (textures
/// spec 1.1).
constexpr ShuffledHash make_shuffled_hash() {
    ShuffledHash table{};
    for (uint32_t i = 0; i < 4096; ++i) table[i] = static_cast<uint16_t>(i);
    uint32_t state = 0;
    for (size_t i = 4096; i-- > 0;) {
        const size_t j = lcg_step(state) & 4095u;
        const uint16_t kept = table[i];
        table[i] = table[j];
        table[j] = kept;
    }
    return table;
}

inline constexpr ShuffledHash shuffled_hash = make_shuffled_hash();

}  // namespace rb
