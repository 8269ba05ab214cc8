#pragma once
#include "math/ray.h"
#include "scene/scene.h"

namespace rb {

/// What the atmosphere does to light along a ray: `attenuation * light + added`.
struct AirEffect {
    Rgb attenuation{1.0f};
    Rgb added{0.0f};
};

/// All fogs of a scene (manual 3.4.8.1.2).
class FogProgram {
public:
    FogProgram(const std::vector<Fog>& fogs, int noise_generator);

    bool empty() const { return fogs_.empty(); }
    AirEffect along(const Ray& ray, double length) const;

private:
    double amount(const Fog& fog, const Ray& ray, double length) const;

    std::vector<Fog> fogs_;
    int noise_generator_ = 2;
};

}  // namespace rb
