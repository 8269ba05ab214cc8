#pragma once
#include "math/sobol.h"
#include "shade/light_program.h"

#include <array>

namespace rb {

/// Where the samples of an area light lie for one lit point: on its grid, or by a low-discrepancy pattern of
/// the point's own (Owen-scrambled Sobol points, put through the inverse of the light's distribution).
class AreaSampler {
public:
    AreaSampler(const LightProgram& light, uint64_t seed, const Vec3& to_center);

    /// A place of the grid, from the light's centre.
    Vec3 grid_place(int u, int v) const { return at({u, v}); }
    /// Place `index` of the pattern, by the light's density.
    Vec3 pattern_place(uint32_t index) const {
        return at(light_.density_place(scrambled_sobol(index, seed_)));
    }
    /// The same where each cell of the grid counts as much as any other.
    Vec3 even_place(uint32_t index) const { return at(light_.even_place(scrambled_sobol(index, seed_))); }
    /// Corners of a parallelogram that holds all places, whichever of the above.
    std::array<Vec3, 4> hull() const;

private:
    /// `p`: in steps of the grid.
    Vec3 at(const Vec2& p) const {
        if (circular_) return evenly_ ? on_even_disc(p) : on_disc(p);
        // An axis with a single sample does not take part.
        const double a = step_.x != 0.0 ? p.x * step_.x - 0.5 : 0.0;
        const double b = step_.y != 0.0 ? p.y * step_.y - 0.5 : 0.0;
        return axis1_ * a + axis2_ * b;
    }
    Vec3 on_disc(const Vec2& p) const;
    Vec3 on_even_disc(const Vec2& p) const;

    const LightProgram& light_;
    Vec3 axis1_;
    Vec3 axis2_;
    Vec2 step_;  ///< between grid places, in axis lengths; 0 with a single one
    bool circular_ = false;
    bool evenly_ = false;
    uint64_t seed_ = 0;
};

}  // namespace rb
