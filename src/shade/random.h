#pragma once
#include <cstdint>

namespace rb {

/// Random numbers by counting: a draw is a function of the seed and of what it is for, never of what was
/// drawn before, so pictures do not depend on order or threads (Steele et al., "SplitMix").
inline uint64_t mixed(uint64_t seed, uint64_t purpose) {
    uint64_t z = seed + 0x9E3779B97F4A7C15u * (purpose + 1);
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return z ^ (z >> 31);
}

/// In [0, 1).
inline double unit_random(uint64_t bits) { return static_cast<double>(bits >> 11) * 0x1p-53; }

/// Place of `i` in a pseudo-random order of 0..length-1 (Kensler, "Correlated Multi-Jittered Sampling").
inline uint32_t permuted(uint32_t i, uint32_t length, uint32_t pattern) {
    uint32_t mask = length - 1;
    mask |= mask >> 1;
    mask |= mask >> 2;
    mask |= mask >> 4;
    mask |= mask >> 8;
    mask |= mask >> 16;
    do {
        i ^= pattern;
        i *= 0xe170893du;
        i ^= pattern >> 16;
        i ^= (i & mask) >> 4;
        i ^= pattern >> 8;
        i *= 0x0929eb3fu;
        i ^= pattern >> 23;
        i ^= (i & mask) >> 1;
        i *= 1 | pattern >> 27;
        i *= 0x6935fa69u;
        i ^= (i & mask) >> 11;
        i *= 0x74dcb303u;
        i ^= (i & mask) >> 2;
        i *= 0x9e501cc3u;
        i ^= (i & mask) >> 2;
        i *= 0xc860a3dfu;
        i &= mask;
        i ^= i >> 5;
    } while (i >= length);
    return (i + pattern) % length;
}

}  // namespace rb
