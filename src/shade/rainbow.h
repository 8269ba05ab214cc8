#pragma once
#include "patterns/blend.h"
#include "scene/scene.h"
#include "shade/fog.h"

namespace rb {

/// All rainbows of a scene (manual 3.4.8.1.4): arcs of light in a direction, however far one looks.
class RainbowProgram {
public:
    explicit RainbowProgram(const std::vector<Rainbow>& rainbows);

    bool empty() const { return arcs_.empty(); }
    /// The mean of those that the ray meets. `seed` decides the jitter of the ray.
    AirEffect along(const Ray& ray, double length, uint64_t seed) const;

private:
    struct Arc {
        Rainbow rainbow;
        MapPositions map;
        // Unit, perpendicular to the direction and to one another.
        Vec3 right;
        Vec3 up;
    };
    static std::optional<AirEffect> met(const Arc& arc, const Ray& ray, double length, double jitter);

    std::vector<Arc> arcs_;
};

}  // namespace rb
