#pragma once
#include "patterns/scratch.h"
#include "shade/light_program.h"

namespace rb {

/// Where the grid samples of an area light lie for one lit point. With `jitter` each is uniform over its grid
/// cell, as in the language, but the samples share their strata, so that they cover the light evenly
/// (Kensler, "Correlated Multi-Jittered Sampling").
class AreaSampler {
public:
    /// `salt` tells several uses of the same light apart.
    AreaSampler(const LightProgram& light, size_t light_index, uint64_t ray_seed, const Vec3& to_center,
                uint64_t salt, Scratch::Scope& memory);

    Vec3 offset(int u, int v) const;

private:
    const LightProgram& light_;
    Vec3 to_center_;
    uint64_t seed_ = 0;
    std::span<uint16_t> row_order_;     ///< stratum along axis 1 that each row of the grid uses
    std::span<uint16_t> column_order_;  ///< stratum along axis 2 that each column uses
};

}  // namespace rb
