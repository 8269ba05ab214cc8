#pragma once
#include <cstdint>

namespace rb {

/// Random numbers by counting: a draw is a function of the seed and of what it is for, never of what was
/// drawn before, so pictures do not depend on order or threads (Steele et al. 2014, "SplitMix").
inline uint64_t mixed(uint64_t seed, uint64_t purpose) {
    uint64_t z = seed + 0x9E3779B97F4A7C15u * (purpose + 1);
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return z ^ (z >> 31);
}

/// In [0, 1).
inline double unit_random(uint64_t bits) { return static_cast<double>(bits >> 11) * 0x1p-53; }

}  // namespace rb
