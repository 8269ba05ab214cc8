#pragma once
#include "patterns/blend.h"
#include "scene/texture.h"

#include <vector>

namespace rb {

/// A `normal` statement compiled for batches (manual 3.4.6.2): turns unit surface normals at world points.
class NormalProgram {
public:
    NormalProgram(const Normal& normal, const PatternSettings& settings, bool no_bump_scale = false);

    SurfaceNeed surface_need() const;
    bool keeps_length() const { return keeps_length_; }
    /// Perturbs `normals` in place. With no_bump_scale they are not unit length afterwards.
    void perturb(const PatternSamples& samples, std::span<Vec3> normals) const;

private:
    enum class Rule { none, pattern, children, average };
    void apply(const PatternSamples& carried, std::span<Vec3> normals) const;
    void slope_of_values(const PatternSamples& carried, std::span<Vec3> normals) const;
    void blend_children(const PatternSamples& carried, std::span<Vec3> normals) const;
    void average_children(const PatternSamples& carried, std::span<Vec3> normals) const;
    double height(double value) const;

    Rule rule_ = Rule::none;
    bool uv_mapping_ = false;
    bool keeps_length_ = false;  ///< no_bump_scale
    float amount_ = 0.5f;
    float accuracy_ = 0.02f;
    PatternField field_;
    MapPositions positions_;
    std::vector<HeightSlope> slopes_;
    std::vector<NormalProgram> children_;
};

/// Carries normals into the space of a chain (front to end) or out of it again; `normalise` as without
/// no_bump_scale.
void normals_into(std::span<const Warp> chain, bool normalise, std::span<Vec3> normals);
void normals_out_of(std::span<const Warp> chain, bool normalise, std::span<Vec3> normals);

}  // namespace rb
