#pragma once
#include "math/ray.h"
#include "scene/scene.h"

#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

namespace rb {

/// Which rays a surface takes part in; a query names the bits it wants.
enum SurfaceMask : RayMask {
    seen_by_image = 1,               ///< camera rays and their refracted continuations (not no_image)
    seen_by_reflection = 2,          ///< rays that have been reflected (not no_reflection)
    blocks_light = 4,                ///< opaque for shadow rays (not no_shadow)
    filters_light = 8,               ///< lets some light through: shadow rays need its texture
    seen_by_gather = 16,             ///< radiosity rays (not no_radiosity)
    seen_by_trace = 32,              ///< the language's trace(): every surface
    seen_by_gather_mirrored = 64,    ///< radiosity rays that have been reflected (no_reflection, too)
    seen_by_gather_refracted = 128,  ///< radiosity rays that have been refracted only (no_image, too)
    /// Photons from a light and those that were only refracted (neither no_shadow nor no_image).
    seen_by_photons = 256,
    seen_by_mirrored_photons = 512,  ///< the others (neither no_shadow nor no_reflection)
};

/// Which lights shine on a surface: those of one light_group, the global ones, or both.
struct LightChoice {
    uint32_t group = 0;  ///< index into World::light_groups; the first is empty
    bool global = true;

    friend bool operator==(const LightChoice&, const LightChoice&) = default;
};

constexpr uint32_t no_target = std::numeric_limits<uint32_t>::max();

/// What photons do at a surface.
struct PhotonRole {
    uint32_t target = no_target;  ///< index into World::photon_targets
    PhotonWays ways;
    bool collect = true;
    bool pass_through = false;

    friend bool operator==(const PhotonRole&, const PhotonRole&) = default;
};

/// An object that photons are shot at.
struct PhotonTarget {
    Bounds box;  ///< of its surfaces
    float spacing_factor = 1;
    PhotonWays ways;
    bool collect = true;
    bool global_lights = true;  ///< they shine on it
};

/// What a surface wears, resolved after CSG inheritance; shared by all leaves that look alike.
struct Surface {
    WornTexture texture;  ///< never null: the default texture stands in
    std::optional<WornTexture> interior_texture;
    uint32_t interior = 0;  ///< index into World::interiors
    bool uv_mapping = false;
    bool double_illuminate = false;
    LightChoice lights;
    PhotonRole photons;
    /// In a Compound: the texture does not move with its copies (uv_mapping).
    bool texture_stays = false;
    bool interior_texture_stays = false;
    SourceRange where;
};

constexpr uint32_t no_surface = std::numeric_limits<uint32_t>::max();

/// One closed or open surface in the world: a shape, where it stands, and what it wears.
struct Leaf {
    ShapePtr shape;
    SharedAffine object_from_world;  ///< identity when `in_world_space`
    bool in_world_space = false;     ///< the shape took its transform into its own numbers
    bool inverted = false;           ///< normals and inside are turned (`inverse`, subtracted)
    RayMask mask = 0;                ///< SurfaceMask bits
    uint32_t surface = 0;            ///< index into World::surfaces
    uint32_t solid = 0;              ///< node of the solid tree that decides which crossings count
    /// First of the surfaces of the shape's own textures in World::surfaces (in the order of
    /// Shape::textures()), or no_surface. See Geometry::surfaces_at().
    uint32_t first_texture_surface = no_surface;
    uint32_t cutaway = no_surface;  ///< index into FlatGeometry::cutaways, or no_surface

    uint32_t instance = no_surface;  ///< index into FlatGeometry::instances, or no_surface

    bool has_one_surface() const {
        return first_texture_surface == no_surface && cutaway == no_surface && instance == no_surface;
    }
};

/// An interior together with its identity; `hollow` belongs to the object that carries it.
struct WorldInterior {
    Interior interior;
    bool hollow = false;
};

constexpr uint32_t no_leaf = std::numeric_limits<uint32_t>::max();

/// A ray's question to the geometry.
struct RayQuery {
    Ray ray;  ///< of unit length
    double t_max = std::numeric_limits<double>::infinity();
    RayMask mask = seen_by_image;
    uint32_t origin_leaf = no_leaf;   ///< the leaf on whose surface the ray starts
    double origin_error = 0;          ///< bound on the distance of the origin to the true surface
    uint32_t origin_part = any_part;  ///< Crossing::part of the hit it starts from; optional, sharpens meshes
    uint32_t origin_member = 0;       ///< Crossing::member of the hit it starts from
    double t_min = 0;                 ///< nothing at or before it counts (the language's trace(): 1e-4)
};

/// One of the surfaces that a hit wears, with its share.
struct SurfaceWeight {
    uint32_t surface = 0;
    float weight = 1;
};

struct Hit {
    double t = 0;
    Vec3 point{0.0};
    /// Unit within 1e-12, outward of the solid (inversions applied); not turned towards the ray.
    Vec3 normal{0.0};
    uint32_t leaf = no_leaf;
    Crossing crossing;
    double error = 0;  ///< bound on the distance of `point` to the true surface
};

class Geometry;  // compile/geometry.h: trees, solids, queries

/// A light in the world. `light.projected_through` has become geometry.
struct WorldLight {
    Light light;
    bool is_global = true;  ///< it stands in no light_group
    /// A shadow ray must meet it before it reaches the light, and what is behind it casts no shadow. Or null.
    std::shared_ptr<const Geometry> projected_through;
};

/// What rays need, and nothing else: made from a Scene by compile().
struct World {
    GlobalSettings settings;
    int effective_version = 362;
    std::vector<Surface> surfaces;
    std::vector<WorldInterior> interiors;
    std::vector<WorldLight> lights;
    /// Indices into `lights`; of the first, which stands for none, there are no lights.
    std::vector<std::vector<uint32_t>> light_groups{1};
    std::vector<PhotonTarget> photon_targets;  ///< empty without GlobalSettings::photons
    std::optional<Color> background;
    std::optional<SkySphere> sky_sphere;
    std::vector<Fog> fogs;
    std::vector<Rainbow> rainbows;
    std::vector<MediaPtr> atmosphere;
    Camera camera;
    std::shared_ptr<const Geometry> geometry;
};

enum class GeometryMode { automatic, exact, tessellate, refine };

/// Which repeated compounds are kept once for all their copies: those where it saves much memory, all, none.
enum class InstanceMode { automatic, always, never };

struct CompileOptions {
    GeometryMode geometry = GeometryMode::automatic;
    double tessellation_error_pixels = 0.05;
    int image_width = 160;
    int image_height = 120;
    int threads = 0;
    InstanceMode instances = InstanceMode::automatic;  ///< not with tessellated shapes
    bool brute_force = false;  ///< no kD-trees: every ray meets every leaf (the trees' slow twin)
};

/// Scene to World: flattens CSG, hands down textures and interiors, bakes transforms, builds the trees.
/// Shapes that are not supported yet are reported and left out.
World compile(const Scene& scene, const CompileOptions& options, Diagnostics& diagnostics);
/// The same, and each object is let go as soon as it is in the world: less memory.
World compile(Scene&& scene, const CompileOptions& options, Diagnostics& diagnostics);

}  // namespace rb
