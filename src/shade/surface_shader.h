#pragma once
#include "shade/direct_light.h"
#include "shade/indirect_shading.h"
#include "shade/photon_shading.h"
#include "shade/secondary.h"
#include "shade/subsurface.h"

namespace rb {

/// Shades groups of hits that wear the same texture: layers and blends, their own light, and the rays they
/// send on (manual 3.4.6).
class SurfaceShader {
public:
    SurfaceShader(const ShadingProgram& program, StreamState& state)
        : program_(program),
          state_(state),
          light_(program, state),
          subsurface_(program, state),
          photons_(program, state),
          indirect_(program, state),
          secondary_(program, state) {}

    /// `hits`: indices into StreamState::hits.
    void shade(const Look& look, std::span<const uint32_t> hits);

private:
    struct Rows;
    struct LayerStack;
    struct LitLayer {
        std::span<LitRow> lit;
        std::span<Color> pigments;
    };
    using Chains = std::span<const std::span<const Warp>>;

    void shade_rows(const TextureProgram& texture, const Rows& rows, Chains enclosing, ShadowMemory& memory);
    void shade_children(const TextureProgram& texture, const Rows& rows, Chains enclosing,
                        ShadowMemory& memory);
    void shade_layers(const TextureProgram& texture, const Rows& rows, Chains enclosing,
                      ShadowMemory& memory);
    void shade_layer(const LayerProgram& layer, const Rows& rows, std::span<const uint32_t> active,
                     Chains enclosing, LayerStack& stack, ShadowMemory& memory);
    void normals_of(const LayerProgram& layer, const PatternSamples& samples, std::span<const uint32_t> hits,
                    Chains enclosing, std::span<Vec3> normals);
    void shade_single(const LayerProgram& layer, const Rows& rows, Chains enclosing, ShadowMemory& memory);
    LitLayer light_layer(const LayerProgram& layer, const Rows& rows, Chains enclosing, ShadowMemory& shadows,
                         std::span<const Rgb> filters, Scratch::Scope& memory);
    MirrorRecord mirror_of(const LayerProgram& layer, const LitRow& lit, float through, float share) const;
    static Rgb kept(const LayerProgram& layer, const MirrorRecord& mirror);
    void send_on(const TextureProgram& texture, const Rows& rows, const LayerStack& stack);
    void go_straight_through(const LayerProgram& layer, const LitRow& lit, const Rgb& weight);
    Rgb own_light(const LayerProgram& layer, const LitRow& lit) const;

    const ShadingProgram& program_;
    StreamState& state_;
    DirectLight light_;
    SubsurfaceLight subsurface_;
    PhotonShading photons_;
    IndirectShading indirect_;
    SecondaryRays secondary_;
    std::span<const uint32_t> lights_;  ///< that shine on the hits at hand
};

}  // namespace rb
