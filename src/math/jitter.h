#pragma once
#include "math/vec.h"

#include <cstdint>

namespace rb {

/// The reference's repeatable jitter at a picture position: both components in [-0.5, 0.5) (shading
/// spec 12.2).
Vec2 position_jitter(double x, double y);

/// A well mixed 64-bit hash (SplitMix64 finaliser, Steele et al. 2014), for counter-based random draws.
inline uint64_t mix(uint64_t v) {
    v += 0x9e3779b97f4a7c15u;
    v = (v ^ (v >> 30)) * 0xbf58476d1ce4e5b9u;
    v = (v ^ (v >> 27)) * 0x94d049bb133111ebu;
    return v ^ (v >> 31);
}

}  // namespace rb
