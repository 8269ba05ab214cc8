#pragma once
#include "scene/light.h"
#include "shade/area_density.h"

#include <array>
#include <cmath>
#include <span>

namespace rb {

class Geometry;

/// Direction and distance from a surface point to a light.
struct LightVector {
    Vec3 direction{0.0};  ///< unit
    double distance = 0;
};

/// Light that is too little to be followed.
inline bool is_black(const Rgb& c) {
    return std::abs(c.x) < 1e-10f && std::abs(c.y) < 1e-10f && std::abs(c.z) < 1e-10f;
}

/// A light with what its formulas need worked out once (manual 3.4.4).
class LightProgram {
public:
    /// `projected_through`: see WorldLight; outlives this.
    explicit LightProgram(const Light& light, const Geometry* projected_through = nullptr,
                          AreaLightMode mode = AreaLightMode::as_written);

    const Light& light() const { return light_; }
    const Rgb& color() const { return light_.color; }
    const Geometry* projected_through() const { return projected_through_; }
    bool is_shadowless() const { return light_.kind == LightKind::shadowless; }
    /// Illuminates from every grid point with its own direction.
    bool area_illumination() const { return light_.is_area && light_.area.area_illumination; }
    /// Of the grid; 1 without an area.
    uint32_t grid_count() const;
    /// Of what shadow rays go to at the most: the grid's, or the pattern's.
    uint32_t sample_count() const { return samples_by_pattern() ? pattern_count_ : grid_count(); }

    /// Its area is sampled by a pattern of its density, not by its grid.
    bool samples_by_pattern() const { return pattern_count_ != 0; }
    /// So many samples of the pattern are taken first; where they agree, there are no more.
    uint32_t pilot_count() const { return pilot_count_; }
    /// The light is the same all over its axes.
    bool is_even() const { return even_; }
    /// From [0, 1)^2 to the grid, in its steps: by the light's density, or each cell alike.
    Vec2 density_place(const Vec2& u) const;
    Vec2 even_place(const Vec2& u) const;
    /// One over the steps of the grid along each axis; 0 with a single sample.
    const Vec2& grid_step() const { return grid_step_; }
    /// How far samples lie from the centre at the most, in axis lengths.
    Vec2 area_share() const;

    /// How far the samples lie from the centre, at the most, along each axis of the world; 0 without an area.
    const Vec3& area_reach() const { return area_reach_; }

    /// Parallel or cylinder: the direction is the light's own.
    bool is_directed() const { return directed_; }
    /// From `p` to the centre, moved by `offset` on the light's area.
    LightVector toward(const Vec3& p, const Vec3& offset) const {
        if (directed_) return along_axis(p, offset);
        const Vec3 way = light_.location + offset - p;
        const double distance = glm::length(way);
        return {distance > 0.0 ? way * (1.0 / distance) : way, distance};
    }
    /// The same for several offsets, two at a time.
    void toward(const Vec3& p, std::span<const Vec3> offsets, std::span<LightVector> ways) const;
    /// attenuation() may be other than 1.
    bool attenuates() const { return attenuates_; }
    /// Cone and fading with distance; 0 outside the cone.
    double attenuation(const Vec3& p, const LightVector& way) const {
        return attenuates_ ? cone_and_fading(p, way) : 1.0;
    }

    /// Of attenuation() the cone alone.
    double cone(const Vec3& p, const LightVector& way) const;
    /// Of attenuation() the fading alone.
    double fading(double distance) const;

private:
    void set_up_area(AreaLightMode mode);
    LightVector along_axis(const Vec3& p, const Vec3& offset) const;
    double cone_and_fading(const Vec3& p, const LightVector& way) const;
    double spot_cone(const LightVector& way) const;
    double cylinder_cone(const Vec3& p) const;

    Light light_;
    const Geometry* projected_through_ = nullptr;
    Vec3 direction_{0.0};  ///< from the light to what it points at
    Vec3 area_reach_{0.0};
    double cos_radius_ = 0;
    double cos_falloff_ = 0;
    bool fades_ = false;
    bool attenuates_ = false;
    bool directed_ = false;
    bool even_ = false;
    uint32_t pattern_count_ = 0;
    uint32_t pilot_count_ = 0;
    Vec2 grid_step_{0.0};
    std::array<AxisDensity, 2> density_;  ///< along the axes
};

}  // namespace rb
