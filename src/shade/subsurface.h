#pragma once
#include "shade/finish_terms.h"
#include "shade/shadow.h"

#include <optional>

namespace rb {

/// A translucent body's bulk, per channel and unit of the scene (spec: shading 15; Jensen et al. 2001, "A
/// Practical Model for Subsurface Light Transport").
struct Bulk {
    /// `reflectance`: what a thick, evenly lit body of it gives back of light in its depth. `translucency`:
    /// in mm.
    Bulk(const Rgb& reflectance, const Rgb& translucency, double ior, double mm_per_unit);

    Vec3 albedo{0.0};      ///< reduced
    Vec3 extinction{0.0};  ///< reduced
    Vec3 transport{0.0};   ///< effective transport coefficient
    double boundary = 1;   ///< what inner reflection does to the virtual source's depth: A of the paper
    double ior = 1;        ///< relative to what is around it
};

/// Light that enters a body elsewhere and leaves it where it is seen, in place of diffuse reflection.
class SubsurfaceLight {
public:
    SubsurfaceLight(const ShadingProgram& program, StreamState& state)
        : program_(program), state_(state), shadows_(program, state) {}

    /// What leaves the body at a hit towards the viewer. `lights`: indices into ShadingProgram::lights.
    Rgb at(const HitPoint& hit, const Vec3& normal, const FinishProgram& finish, const Rgb& pigment,
           double ior, std::span<const uint32_t> lights);

    /// Where a ray that goes straight through the body leaves it, and what is left of its light.
    struct Passage {
        HitPoint exit;
        Vec3 direction{0.0};
        Rgb left{0.0f};
    };
    std::optional<Passage> straight_through(const HitPoint& hit, const Vec3& normal,
                                            const FinishProgram& finish, const Rgb& pigment, double ior);

private:
    Bulk bulk_of(const FinishProgram& finish, const Rgb& pigment, double ior) const;
    std::optional<HitPoint> wall(const HitPoint& hit, const Ray& ray, bool starts_at_hit, double t_max);
    template <class Add>
    void each_light(const HitPoint& place, std::span<const uint32_t> lights, Add&& add);
    Rgb scattered_often(const HitPoint& hit, const Bulk& bulk, std::span<const uint32_t> lights);
    Rgb scattered_once(const HitPoint& hit, const Vec3& normal, const Bulk& bulk,
                       std::span<const uint32_t> lights);

    double from_within(const HitPoint& hit, const Vec3& place, double depth, double seen_cosine, int channel,
                       const Bulk& bulk, std::span<const uint32_t> lights);

    const ShadingProgram& program_;
    StreamState& state_;
    ShadowTracer shadows_;
};

}  // namespace rb
