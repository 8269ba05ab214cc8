#pragma once
#include "base/diagnostics.h"
#include "scene/camera.h"
#include "scene/curve.h"
#include "scene/object.h"
#include "scene/radiosity.h"

#include <optional>
#include <string>
#include <vector>

namespace rb {

/// `subsurface` of global_settings (manual 3.4.1.15).
struct SubsurfaceSettings {
    int diffuse_samples = 50;  ///< of the body's surface
    int single_samples = 50;   ///< of the ray's way into the body
};

struct GlobalSettings {
    float adc_bailout = 1.0f / 255.0f;
    Rgb ambient_light{1.0f};
    std::optional<GammaCurve> assumed_gamma;  ///< absent: not given (manual 3.4.1.2)
    Rgb irid_wavelength{0.70f, 0.52f, 0.48f};
    int max_trace_level = 5;
    int noise_generator = 2;
    int number_of_waves = 10;
    double mm_per_unit = 10;
    std::optional<RadiositySettings> radiosity;
    std::optional<PhotonSettings> photons;  ///< absent: there are none
    std::optional<SubsurfaceSettings> subsurface;
};

struct SkySphere {
    SourceRange where;
    std::vector<PigmentPtr> pigments;  ///< bottom first
    Rgb emission{1.0f};
    Transform world_from_sky;
};

struct Fog {
    SourceRange where;
    Color color;
    double distance = 0;
    int type = 1;
    double offset = 0;
    double alt = 0;
    Vec3 up{0.0, 1.0, 0.0};
    std::optional<TurbulenceWarp> turbulence;
    double turb_depth = 0.5;
};

/// An arc of colours around a direction. Angles in radians.
struct Rainbow {
    SourceRange where;
    Vec3 direction{0.0};
    Vec3 up{0.0, 1.0, 0.0};  ///< towards the middle of the arc
    double angle = 0;        ///< between the direction and the middle of the band
    double width = 0;        ///< of the band
    double distance = 1e7;   ///< within which its light comes in; 0: nothing is seen
    double jitter = 0;       ///< in band widths, to either side
    /// How far the arc goes around the direction, and where it begins to fade. So far off where none is
    /// written that a falloff alone, which the language allows, hardly shows.
    double arc_angle = 360;
    double falloff_angle = 360;
    std::shared_ptr<const ColorMap> color_map;  ///< null: nothing is seen
};

/// Everything a scene file says, evaluated: the contract between the front end and the renderer.
struct Scene {
    GlobalSettings settings;
    /// Hundredths, as #version sets it (370 = 3.7); what decides in scenes without #version is
    /// `effective_version`.
    int language_version = 370;
    /// language_version if a #version was executed anywhere (or given on the command line), else 362.
    int effective_version = 362;
    Camera camera;
    std::optional<Color> background;
    std::optional<SkySphere> sky_sphere;
    std::vector<Fog> fogs;
    std::vector<Rainbow> rainbows;
    std::vector<MediaPtr> atmosphere;  ///< `media` outside of interiors
    std::vector<ObjectPtr> objects;    ///< top-level statements in order; lights among them
    TexturePtr default_texture;        ///< in force at the end

    /// Scenes below 3.7 without assumed_gamma write their numbers unchanged (spec: language 6).
    bool has_gamma_handling() const { return settings.assumed_gamma.has_value() || effective_version >= 370; }
};

/// Readable, stable text of the whole scene for `--dump scene`.
std::string dump(const Scene& scene);

}  // namespace rb
