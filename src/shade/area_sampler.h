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
    Vec3 axis1_;
    Vec3 axis2_;
    double step1_ = 0;  ///< between grid positions, in axis lengths; 0 with a single one
    double step2_ = 0;
    size_t width_ = 1;
    bool circular_ = false;
    bool jitter_ = false;
    uint64_t seed_ = 0;
    std::span<uint16_t> row_order_;     ///< stratum along axis 1 that each row of the grid uses
    std::span<uint16_t> column_order_;  ///< stratum along axis 2 that each column uses
};

}  // namespace rb
