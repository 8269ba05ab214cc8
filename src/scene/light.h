#pragma once
#include "base/source.h"
#include "math/transform.h"
#include "scene/color.h"
#include "scene/photons.h"

#include <memory>

namespace rb {

struct Object;

enum class LightKind { point, spotlight, cylinder, shadowless };

struct AreaGrid {
    Vec3 axis1{0.0};
    Vec3 axis2{0.0};
    int size1 = 1;
    int size2 = 1;
    int adaptive = 100;
    bool jitter = false;
    bool circular = false;
    bool orient = false;
    bool area_illumination = false;
};

/// A light_source (manual 3.4.4), in world space: transformations have been applied to its vectors.
struct Light {
    SourceRange where;
    LightKind kind = LightKind::point;
    Vec3 location{0.0};
    Rgb color{1.0f};
    bool parallel = false;
    Vec3 point_at{0.0, 0.0, 1.0};
    double radius = 30;   ///< degrees (spotlight) or world units (cylinder)
    double falloff = 45;  ///< as radius
    double tightness = 0;
    bool is_area = false;
    AreaGrid area;
    double fade_distance = 0;
    double fade_power = 0;
    bool media_interaction = true;
    bool media_attenuation = false;
    LightPhotons photons;
    std::shared_ptr<const Object> looks_like;
    std::shared_ptr<const Object> projected_through;
};
using LightPtr = std::shared_ptr<const Light>;

Light transformed(const Light& light, const Transform& map);

}  // namespace rb
