#pragma once
#include "math/ray.h"
#include "scene/light.h"
#include "shade/media_path.h"

#include <optional>
#include <vector>

namespace rb {

/// The part of a ray's way that a light may reach: all of it, or what lies in the cone of a spotlight or in a
/// cylinder.
struct LightSpan {
    double from = 0;
    double to = 0;
    uint32_t light = 0;
};

/// Empty if the light does not reach it at all.
std::optional<LightSpan> lit_span(const Light& light, const Ray& ray, double length);

/// Cuts the way into lit and unlit pieces (spec: shading 11.3).
void cut_by_light(std::span<const LightSpan> spans, double length, std::vector<MediaPiece>& pieces);

}  // namespace rb
