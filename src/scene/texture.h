#pragma once
#include "base/source.h"
#include "scene/pattern.h"

#include <memory>
#include <optional>
#include <variant>
#include <vector>

namespace rb {

struct Pigment;
struct Normal;
struct Texture;
using PigmentPtr = std::shared_ptr<const Pigment>;
using NormalPtr = std::shared_ptr<const Normal>;

/// One entry of a `*_map`, in written order (never sorted), or of a list such as checker's, whose positions
/// are 0, 1, 2, … `average` maps use the position as a weight.
template <class T>
struct MapEntry {
    float position = 0;
    T value;
};
template <class T>
using BlendMap = std::vector<MapEntry<T>>;
using ColorMap = BlendMap<Color>;

struct Pigment {
    SourceRange where;
    /// No pattern and no colour written: black (manual 3.4.6.1).
    std::variant<std::monostate, Color, PatternPtr> source;
    PatternModifiers modifiers;
    std::variant<std::monostate, ColorMap, BlendMap<PigmentPtr>> map;  ///< empty: the pattern's default map
    bool average = false;                                              ///< `average pigment_map`
    bool uv_mapping = false;  ///< this pigment is evaluated at (u, v, 0)
    std::optional<Color> quick_color;
};

/// height and slope of a slope_map entry
struct HeightSlope {
    float height = 0;
    float slope = 0;
};

struct Normal {
    SourceRange where;
    PatternPtr pattern;  ///< null: nothing happens
    PatternModifiers modifiers;
    float amount = 0.5f;
    float accuracy = 0.02f;
    bool no_bump_scale = false;
    bool average = false;
    bool uv_mapping = false;
    std::variant<std::monostate, BlendMap<HeightSlope>, BlendMap<NormalPtr>> map;
};

struct Reflection {
    Rgb min{0.0f};
    Rgb max{0.0f};
    bool fresnel = false;
    float falloff = 1;
    float exponent = 1;
    float metallic = 0;
};

/// Names and defaults of the language (manual 3.4.6.2). Albedo keywords are already applied; `raw_*` are the
/// values before that, which radiosity uses.
struct Finish {
    SourceRange where;
    Rgb ambient{0.1f};
    Rgb emission{0.0f};
    float diffuse = 0.6f;
    float diffuse_back = 0.0f;
    float raw_diffuse = 0.6f;
    float raw_diffuse_back = 0.0f;
    float brilliance = 1;
    float crand = 0;
    float phong = 0;
    float phong_size = 40;
    float specular = 0;
    float roughness_exponent = 20;  ///< 1 / roughness
    float metallic = 0;
    Reflection reflection;
    bool conserve_energy = false;
    float irid_amount = 0;
    float irid_thickness = 0;
    float irid_turbulence = 0;
    std::optional<Rgb> translucency;  ///< of `subsurface`, in mm
    // Legacy items that override the interior's.
    std::optional<float> ior;
    std::optional<float> caustics;
    float refraction = 1;
};
using FinishPtr = std::shared_ptr<const Finish>;

/// One layer: a plain texture, or a patterned one (texture_map, list of textures, average).
struct Texture {
    SourceRange where;
    // plain
    PigmentPtr pigment;  ///< never null in a plain texture
    NormalPtr normal;    ///< may be null
    FinishPtr finish;    ///< never null in a plain texture
    // patterned: the children of `map` may themselves be layered
    PatternPtr pattern;
    PatternModifiers modifiers;
    BlendMap<std::shared_ptr<const std::vector<Texture>>> map;
    bool average = false;
    /// The children are evaluated at (u, v, 0); what `modifiers` transform is the normals.
    bool uv_mapping = false;

    bool is_patterned() const { return pattern != nullptr || average || !map.empty(); }
};

/// Layers, bottom first.
using TextureLayers = std::vector<Texture>;
using TexturePtr = std::shared_ptr<const TextureLayers>;

/// One plain layer of the language's default finish.
TexturePtr plain_texture(Pigment pigment = {});

/// The same with `map` applied after what is there, as a transformation statement does (spec:
/// textures 2.2, 8.2).
PatternModifiers transformed(const PatternModifiers& modifiers, const Transform& map);
Texture transformed(const Texture& texture, const Transform& map);
TexturePtr transformed(const TexturePtr& layers, const Transform& map);

}  // namespace rb
