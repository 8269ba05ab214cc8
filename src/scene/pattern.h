#pragma once
#include "math/interval_slope.h"
#include "math/transform.h"
#include "scene/color.h"

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace rb {

/// Turbulence that moves a point, or that a pattern such as marble uses in its own formula (manual 3.6.2.8
/// and 3.4.6.3.5). `classic` is the keyword outside `warp{}`: it always acts last, wherever it was written.
struct TurbulenceWarp {
    Vec3 amount{0.0};
    int octaves = 6;
    float lambda = 2.0f;
    float omega = 0.5f;
    bool classic = false;
};
struct RepeatWarp {
    int axis = 0;
    float width = 1;
    Vec3 offset{0.0};
    Vec3 flip{1.0};  ///< +1, or -1 on the axes that flip
};
struct BlackHoleWarp {
    Vec3 center{0.0};
    double radius = 1;
    double strength = 1;
    double falloff = 2;
    bool inverse = false;
    Vec3 repeat{0.0};
    Vec3 turbulence{0.0};
    bool acts = true;  ///< false for a `type` other than 0
};
enum class Mapping { cylindrical, spherical, toroidal, planar };
struct MappingWarp {
    Mapping kind = Mapping::planar;
    Vec3 orientation{0.0, 0.0, 1.0};
    double dist_exp = 0;
    double major_radius = 1;
    double offset = 0;
};
struct CubicWarp {};
using Warp = std::variant<Transform, TurbulenceWarp, RepeatWarp, BlackHoleWarp, MappingWarp, CubicWarp>;

enum class Wave { ramp, triangle, sine, scallop, cubic, poly };

/// What is written beside a pattern's keyword and holds for any pattern (spec: pattern pipeline).
struct PatternModifiers {
    std::vector<Warp>
        warps;            ///< front first: evaluation walks from front to end, the last written acts first
    float frequency = 1;  ///< 0: the value is used as it is
    float phase = 0;
    Wave wave = Wave::ramp;
    float poly_exponent = 1;
    int noise_generator = 0;  ///< 0: the scene's
    float agate_turbulence = 1;

    /// The classic turbulence element, or null.
    const TurbulenceWarp* classic_turbulence() const;
};

/// The places on surfaces that a batch of pattern points belongs to, for what depends on more than a point
/// (slope, aoi, uv_mapping). World space.
struct SurfaceSamples {
    std::span<const Vec3> points;
    std::span<const Vec3> normals;     ///< unit, turned towards the ray, perturbed by what came before
    std::span<const Vec3> directions;  ///< unit, of the arriving ray
    std::span<const Vec2> uv;
};

/// What a pattern asks of the surface: nothing, what is the same from everywhere (normals, uv), or directions
/// to the eye, too. Each takes in those before it.
enum class SurfaceNeed : uint8_t { none, place, view };

/// What a pattern may ask for besides the points.
struct PatternContext {
    const PatternModifiers& modifiers;
    int noise_generator = 2;  ///< resolved, 1..3
    int number_of_waves = 10;
    const SurfaceSamples* surface = nullptr;  ///< null where there is no surface (sky, functions)
    std::span<const uint32_t> rows;           ///< for each point its row in `surface`
};

/// A scalar field over space: `bozo`, `checker`, ... Immutable and shared.
class Pattern {
public:
    virtual ~Pattern() = default;
    virtual std::string_view keyword() const = 0;
    /// Raw values at points that have already been carried through the warps; frequency, phase, wave come
    /// after.
    virtual void evaluate(const PatternContext& context, std::span<const Vec3> points,
                          std::span<double> values) const = 0;
    /// Holds what evaluate() gives along a line, as IntervalSlope says. Coordinates
    /// are finite.
    virtual IntervalSlope bound(const PatternContext&, const LinePlace& /*place*/) const {
        return IntervalSlope::everything();
    }
    /// The pattern's own rule for `normal` statements (manual 3.4.6.2.3): adds to the unit normals at warped
    /// points. False: it has none, and the slope of its values is taken.
    virtual bool perturb(const PatternContext&, float /*amount*/, std::span<const Vec3> /*points*/,
                         std::span<Vec3> /*normals*/) const {
        return false;
    }
    /// True for pictures (image_map), which have colours instead of values that a map turns into colours.
    virtual bool has_colors() const { return false; }
    /// These colours, at points that have already been carried through the warps.
    virtual void colors(std::span<const Vec3> /*points*/, std::span<Color> /*out*/) const {}
    /// True if some of them may have filter or transmit.
    virtual bool passes_light() const { return false; }
    /// True if classic turbulence acts inside the formula only and does not move the points (marble, wood).
    virtual bool keeps_turbulence() const { return false; }
    /// False if this instance wants the black to white map although its kind has a default map.
    virtual bool takes_default_map() const { return true; }
    /// What it asks of PatternContext::surface.
    virtual SurfaceNeed surface_need() const { return SurfaceNeed::none; }
    virtual std::string describe() const { return std::string(keyword()); }
};
using PatternPtr = std::shared_ptr<const Pattern>;

}  // namespace rb
