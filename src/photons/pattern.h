#pragma once
#include "compile/world.h"
#include "shade/light_program.h"

namespace rb {

/// A photon that leaves a light.
struct PhotonStart {
    Ray ray;
    double passed = 0;  ///< how far from the light the ray begins
    Rgb color{0.0f};
    uint32_t ring = 0;
};

/// In which directions (from parallel lights: at which places) photons leave a light for a target: in rings
/// around the axis between them, about as far apart from one ring to the next as within a ring (spec: shading
/// 14.2). Random draws are hashes of the seed, the ring and the place in it.
class PhotonPattern {
public:
    /// `spacing`: between photons at the target, world units.
    PhotonPattern(const LightProgram& light, const PhotonTarget& target, double spacing,
                  const PhotonSettings& settings, uint64_t seed);

    /// The number of rings, however many are needed in the end.
    double ring_count() const { return ring_count_; }
    double start_count() const;  ///< of photons of all rings, about
    /// True if a ring that misses the target may be the last.
    bool may_stop_at(uint32_t ring) const { return ring * step_ > stop_angle_; }
    /// How many directions a ring has; from an area each goes out from every sample.
    uint32_t ring_size(uint32_t ring) const;
    uint32_t sample_count() const { return samples_; }
    /// False if nothing leaves the light there.
    bool start(uint32_t ring, uint32_t place, uint32_t sample, PhotonStart& out) const;

    /// Between photons at a distance of 1 from the light (from parallel lights: anywhere).
    double spread() const { return spread_; }

private:
    double turn_step(uint32_t ring) const;  ///< between places of a ring, radians
    Vec3 place_on_area(uint32_t sample, uint64_t seed) const;
    Ray ray_at(double angle, double turn, const Vec3& offset) const;

    const LightProgram& light_;
    Vec3 center_{0.0};  ///< of the target
    double spread_ = 1;
    double step_ = 1;  ///< between rings: radians, or units of length from parallel lights
    double end_ = 0;   ///< of the rings
    double ring_count_ = 0;
    double stop_angle_ = 0;
    double jitter_ = 0;
    uint32_t samples_ = 1;
    uint64_t seed_ = 0;
};

}  // namespace rb
