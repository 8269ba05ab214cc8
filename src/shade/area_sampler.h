#pragma once
#include "base/scratch.h"
#include "math/random.h"
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

    Vec3 offset(int u, int v) const {
        double x = u;
        double y = v;
        if (jitter_) {
            const auto column = static_cast<size_t>(u);
            const auto row = static_cast<size_t>(v);
            const uint64_t draw = mixed(seed_, row * width_ + column);
            x += (row_order_[row] + fine(draw)) * row_height_ - 0.5;
            y += (column_order_[column] + fine(draw >> 32)) * column_width_ - 0.5;
        }
        if (circular_) return on_disc(x, y);
        // An axis with a single sample does not take part.
        const double a = step1_ != 0.0 ? x * step1_ - 0.5 : 0.0;
        const double b = step2_ != 0.0 ? y * step2_ - 0.5 : 0.0;
        return axis1_ * a + axis2_ * b;
    }

private:
    /// The low half as a fraction; through a signed integer, which converts faster.
    static double fine(uint64_t draw) {
        return static_cast<double>(static_cast<int64_t>(draw & 0xFFFFFFFFu)) * 0x1p-32;
    }
    Vec3 on_disc(double x, double y) const;

    Vec3 axis1_;
    Vec3 axis2_;
    double step1_ = 0;  ///< between grid positions, in axis lengths; 0 with a single one
    double step2_ = 0;
    size_t width_ = 1;
    bool circular_ = false;
    bool jitter_ = false;
    uint64_t seed_ = 0;
    double row_height_ = 1;  ///< of a stratum, in grid cells
    double column_width_ = 1;
    std::span<uint16_t> row_order_;     ///< stratum along axis 1 that each row of the grid uses
    std::span<uint16_t> column_order_;  ///< stratum along axis 2 that each column uses
};

}  // namespace rb
