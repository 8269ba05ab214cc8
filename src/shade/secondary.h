#pragma once
#include "shade/draws.h"
#include "shade/finish_terms.h"
#include "shade/stream_state.h"

namespace rb {

/// A mirror of one layer, to be followed once the layers below are known.
struct MirrorRecord {
    uint32_t row = 0;
    const FinishProgram* finish = nullptr;
    Vec3 normal{0.0};
    Rgb amount{0.0f};
    float importance = 0;
    float share = 1;  ///< of a blended texture
};

/// What a layered texture lets through at a hit.
struct Transmission {
    const FinishProgram* finish = nullptr;  ///< of the top layer
    Vec3 normal{0.0};                       ///< of the top layer
    Rgb filter{1.0f};
    float through = 1;  ///< grey of the filter, clipped to 1
    float share = 1;
};

/// Sends reflected and refracted rays on their way (manual 3.4.6.3.6, 3.4.7).
class SecondaryRays {
public:
    SecondaryRays(const ShadingProgram& program, StreamState& state) : program_(program), state_(state) {}

    /// Index of refraction beyond the surface relative to this side, for fresnel.
    double relative_ior(const HitPoint& hit, const FinishProgram& finish) const;

    /// True under total internal reflection.
    bool transmit(const HitPoint& hit, const Transmission& what);
    void reflect(const HitPoint& hit, const MirrorRecord& mirror);
    /// The ray goes on from another place of the body's surface, with so much of its weight.
    void pass_on(const HitPoint& hit, const HitPoint& exit, const Vec3& direction, const Rgb& weight);

private:
    struct Crossing;
    Crossing crossing_of(const HitPoint& hit, const FinishProgram& finish);
    bool bend(const HitPoint& hit, const Transmission& what, const Crossing& crossing, double eta,
              PathRay& ray);
    void disperse(const HitPoint& hit, const Transmission& what, const Crossing& crossing);
    void mirror_inside(const HitPoint& hit, const Transmission& what, PathRay& ray);
    Rgb film(const HitPoint& hit, const FinishProgram& finish, const Vec3& normal, const Vec3& out) const;
    bool worth_following(const PathRay& ray) const;
    PathRay& add_child(const HitPoint& hit, Draw draw);
    bool keep_or_drop(const PathRay& ray);

    const ShadingProgram& program_;
    StreamState& state_;
};

}  // namespace rb
