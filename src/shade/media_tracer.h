#pragma once
#include "shade/draws.h"
#include "shade/light_span.h"
#include "shade/shadow.h"

namespace rb {

/// Media on the way of a ray of the current wave, with what lights scatter in them.
class MediaTracer final : private MediaLighting {
public:
    MediaTracer(const ShadingProgram& program, StreamState& state)
        : program_(program), state_(state), shadows_(program, state) {}

    // `lights`: indices into ShadingProgram::lights, of those that shine where the way ends (as in the
    // reference).

    /// What fills the interiors that contain the ray; they are all hollow.
    AirEffect in_interiors(uint32_t ray_index, double length, std::span<const uint32_t> lights);
    /// What fills the air.
    AirEffect in_air(uint32_t ray_index, double length, std::span<const uint32_t> lights);

private:
    AirEffect along(uint32_t ray_index, double length, std::span<const uint32_t> lights, Draw draw);
    void add(std::span<const double> distances, std::span<const Vec3> points,
             std::span<MediaSample> samples) override;
    bool is_everywhere() const override { return shows_photons(); }
    bool shows_photons() const { return program_.photons && program_.photons->in_media() && mix_.collects(); }
    void add_light(const LightSpan& span, std::span<const double> distances, std::span<const Vec3> points,
                   std::span<MediaSample> samples);
    void add_photons(std::span<const Vec3> points, std::span<MediaSample> samples);
    const Candidates* candidates(const LightProgram& source, std::span<const Vec3> points);

    const ShadingProgram& program_;
    StreamState& state_;
    ShadowTracer shadows_;
    MediaMix mix_;
    uint32_t ray_index_ = 0;
    std::vector<LightSpan> spans_;
    std::vector<MediaPiece> pieces_;
    KnownReaches reaches_;   ///< of photons
    Candidates candidates_;  ///< of the samples and the light at hand
};

}  // namespace rb
