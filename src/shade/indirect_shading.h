#pragma once
#include "shade/direct_light.h"

namespace rb {

/// The light from other diffuse surfaces and the sky at a group of hits (shading spec 13.2), as StreamState's
/// IndirectLight answers it. Layers share what they know of it.
class IndirectShading {
public:
    IndirectShading(const ShadingProgram& program, StreamState& state) : program_(program), state_(state) {}

    /// Forgets the group before. `count`: of rows; `memory` holds what becomes known of them.
    void begin(size_t count, Scratch::Scope& memory);

    /// Between textures that are mixed at `rows`: where light is gathered around perturbed normals, they do
    /// not share it.
    void leave_texture(std::span<const uint32_t> rows);

    /// Adds it to the light of the rows of one layer. `filters`: of the layers above; empty if there are
    /// none.
    void add(const FinishProgram& finish, std::span<LitRow> rows, std::span<const Rgb> filters);

private:
    /// Which side of a surface light comes from: the viewer's, or the other one.
    enum Side : size_t { front, back };

    void gather(Side side, float diffuse, std::span<const LitRow> rows, std::span<const Rgb> filters);

    const ShadingProgram& program_;
    StreamState& state_;
    std::array<std::span<Rgb>, 2> mean_;       ///< by side and row
    std::array<std::span<uint8_t>, 2> known_;  ///< by side and row
};

}  // namespace rb
