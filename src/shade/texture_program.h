#pragma once
#include "compile/world.h"
#include "patterns/normal_program.h"
#include "patterns/pigment_program.h"
#include "shade/power.h"

#include <optional>
#include <vector>

namespace rb {

/// A finish with what its formulas need worked out once (manual 3.4.6.3).
struct FinishProgram {
    FinishProgram(const Finish& written, const Rgb& ambient_light);

    Finish finish;
    Rgb own_light{0.0f};  ///< ambient under the scene's ambient light, and emission
    bool takes_light = false;
    bool has_highlights = false;
    bool reflects = false;
    float reflection_importance = 0;  ///< largest component of min and max
    double phong_threshold = 0;       ///< smaller cosines give nothing that could be seen
    double specular_threshold = 0;
    Power brilliance;
    Power phong_size;
    Power roughness;
};

struct LayerProgram {
    PigmentProgram pigment;
    std::optional<NormalProgram> normal;
    FinishProgram finish;
};

/// What textures are compiled with.
struct TextureSettings {
    PatternSettings patterns;
    Rgb ambient_light{1.0f};
    int quality = 9;
};

/// A texture compiled for batches: either layers, or a pattern that chooses among children.
struct TextureProgram {
    TextureProgram(const TextureLayers& written, const TextureSettings& settings);

    bool is_patterned() const { return !children.empty(); }

    std::vector<LayerProgram> layers;  ///< top first
    bool average = false;
    bool uv_mapping = false;
    PatternField field;
    MapPositions positions;
    std::vector<TextureProgram> children;

    bool needs_surface = false;  ///< some pattern asks for normals, directions or uv
    bool passes_light = false;   ///< some place may be transparent
    bool has_fresnel = false;

private:
    void add_layer(const Texture& texture, const TextureSettings& settings);
    void add_children(const Texture& texture, const TextureSettings& settings);
};

}  // namespace rb
