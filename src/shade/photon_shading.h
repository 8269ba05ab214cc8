#pragma once
#include "shade/direct_light.h"

namespace rb {

/// Adds the light that photons brought (spec: shading 14.5).
class PhotonShading {
public:
    PhotonShading(const ShadingProgram& program, StreamState& state) : program_(program), state_(state) {}

    /// Only while ShadingProgram::shows_photons().
    void add(const FinishProgram& finish, std::span<LitRow> rows);

private:
    Rgb gathered(const FinishProgram& finish, const LitRow& row, std::span<NearPhoton> memory);

    const ShadingProgram& program_;
    StreamState& state_;
    KnownPhotons known_;
};

}  // namespace rb
