#pragma once
#include "photons/pattern.h"
#include "photons/photon.h"
#include "shade/ray_stream.h"

namespace rb {

/// A photon at rest, with the ring that it came from.
struct Deposit {
    Photon photon;
    uint32_t ring = 0;
};

/// What became of some photons.
struct PhotonHarvest {
    std::vector<Deposit> on_surfaces;
    std::vector<Deposit> in_media;
    std::vector<uint32_t> rings_that_hit;  ///< rings of photons that met the target, repeated or not
};

/// From which light to which target photons go, and what of it decides their ways.
struct PhotonMission {
    const LightProgram* light = nullptr;
    uint32_t target = no_target;  ///< index into World::photon_targets
    double spread = 1;            ///< PhotonPattern::spread()
};

/// Follows photons through a world, wave by wave (spec: shading 14.3, 14.4): the light that they carry is the
/// weight of their rays, which are bent and mirrored as those of cameras are.
class PhotonStream : private RayStream {
public:
    /// `inside`: interiors that contain the light.
    PhotonStream(const ShadingProgram& program, StreamState& state, const PhotonMission& mission,
                 std::span<const uint32_t> inside);

    /// `seed`: of all of these photons together.
    void follow(std::span<const PhotonStart> photons, uint64_t seed, PhotonHarvest& harvest);

private:
    /// What a photon has behind it; PathRay::slot of the next wave says which one it was.
    struct Path {
        double length = 0;
        uint32_t ring = 0;
        bool has_met_target = false;
    };
    void start(std::span<const PhotonStart> photons, uint64_t seed);
    void run_wave(PhotonHarvest& harvest);
    void arrive(uint32_t index, const Hit& hit, PhotonHarvest& harvest);
    void pass_straight(uint32_t index, const Hit& hit);
    Rgb arriving(uint32_t index, const Hit& hit, PhotonHarvest& harvest);
    void leave_in_media(uint32_t index, double length, PhotonHarvest& harvest);
    /// Between photons that have come so far.
    double width_at(double path_length) const;
    Deposit deposit(const PathRay& ray, const Rgb& color, const Vec3& place, double path_length,
                    uint32_t ring) const;
    void send_on(uint32_t index, const Hit& hit, const Rgb& color, PhotonPermit permit);

    PhotonMission mission_;
    std::span<const uint32_t> inside_;
    ShadowTracer filters_;
    MediaMix mix_;                     ///< on the way of the photon at hand
    std::vector<SurfaceWeight> worn_;  ///< of the hit at hand
    std::vector<Path> paths_;          ///< parallel to the rays of the wave
    std::vector<Path> next_paths_;
};

}  // namespace rb
