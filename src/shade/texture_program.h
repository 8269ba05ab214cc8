#pragma once
#include "compile/world.h"
#include "patterns/blend.h"
#include "patterns/normal_program.h"
#include "patterns/pigment_program.h"
#include "shade/power.h"

#include <memory>
#include <unordered_map>
#include <vector>

namespace rb {

/// What textures are compiled with.
struct TextureSettings {
    PatternSettings patterns;
    Rgb ambient_light{1.0f};
    int quality = 9;
    bool highlights = true;
    bool subsurface = false;  ///< light goes through bodies whose finish says so
};

/// A finish with what its formulas need worked out once (manual 3.4.6.3).
struct FinishProgram {
    FinishProgram(const Finish& written, const TextureSettings& settings);

    Finish finish;
    Rgb own_light{0.0f};  ///< ambient under the scene's ambient light, and emission
    bool takes_light = false;
    bool takes_indirect_light = false;
    bool has_highlights = false;
    bool reflects = false;
    bool is_translucent = false;      ///< light from within takes the place of diffuse light
    float reflection_importance = 0;  ///< largest component of min and max
    double phong_threshold = 0;       ///< smaller cosines give nothing that could be seen
    double specular_threshold = 0;
    Power brilliance;
    Power phong_size;
    Power roughness;
};
using FinishProgramPtr = std::shared_ptr<const FinishProgram>;

struct LayerProgram {
    PigmentProgram pigment;
    std::shared_ptr<const NormalProgram> normal;  ///< may be null
    FinishProgramPtr finish;                      ///< never null; layers with the same finish share it
};

/// Compiles textures; each finish once, however many of them share it. What was written must outlive it.
class TextureCompiler {
public:
    explicit TextureCompiler(const TextureSettings& chosen) : settings(chosen) {}
    FinishProgramPtr finish(const Finish* written);

    const TextureSettings settings;

private:
    std::unordered_map<const Finish*, FinishProgramPtr> finishes_;
};

struct TextureMapProgram;

/// A texture compiled for batches: either layers, or a pattern that chooses among children. Small, since a
/// scene may have as many as objects.
struct TextureProgram {
    TextureProgram(const TextureLayers& written, TextureCompiler& compiler);

    bool is_patterned() const { return map != nullptr; }

    std::vector<LayerProgram> layers;  ///< top first
    std::shared_ptr<const TextureMapProgram> map;

    SurfaceNeed surface_need = SurfaceNeed::none;  ///< the most that a pattern asks for
    bool passes_light = false;                     ///< some place may be transparent
    bool has_fresnel = false;
    bool is_matt = true;  ///< it shows the same light to everyone

private:
    void add_layer(const Texture& texture, TextureCompiler& compiler);
    void add_children(const Texture& texture, TextureCompiler& compiler);
};

/// The pattern of a patterned texture, and what it chooses among.
struct TextureMapProgram {
    bool average = false;
    bool uv_mapping = false;
    PatternField field;
    MapPositions positions;
    std::vector<TextureProgram> children;

    /// The places at which the children are asked; new points live in `memory`. With uv_mapping those are the
    /// surface's coordinates, and `field` carries only normals.
    PatternSamples moved(const PatternSamples& samples, Scratch::Scope& memory) const {
        return samples.at(uv_mapping ? uv_points(samples, memory) : carried(field, samples.points, memory));
    }
};

}  // namespace rb
