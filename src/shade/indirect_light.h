#pragma once
#include "compile/world.h"

#include <span>

namespace rb {

/// A place on a surface that asks for its indirect light.
struct IndirectPlace {
    Vec3 point{0.0};
    Vec3 normal{0.0};   ///< unit; axis of the hemisphere that light comes from
    Vec3 surface{0.0};  ///< unit; the unperturbed normal on the same side: nothing comes from below it
    // Where rays start that leave the place: see RayQuery.
    uint32_t leaf = no_leaf;
    uint32_t part = any_part;
    uint32_t member = 0;
    double error = 0;
    uint64_t seed = 0;  ///< decides its random draws
    float share = 1;    ///< of a pixel that it matters to, about
};

/// Answers how much light arrives from other surfaces and the sky. Implementations are safe to call from many
/// threads, and what they say of a place does not depend on the others in the batch.
class IndirectLight {
public:
    virtual ~IndirectLight() = default;

    /// `mean[i]`: mean radiance over the hemisphere of `places[i]`, weighted by the cosine to its normal
    /// (irradiance / pi), with the scene's brightness and gray_threshold. `depth`: diffuse surfaces between
    /// the places and the eye.
    virtual void gather(std::span<const IndirectPlace> places, int depth, std::span<Rgb> mean) const = 0;

    /// False if it only takes note of who asks: then nothing has to be lit meanwhile.
    virtual bool wants_light() const { return true; }
};

}  // namespace rb
