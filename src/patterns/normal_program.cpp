#include "patterns/normal_program.h"

#include <algorithm>

namespace rb {

namespace {

void make_unit(std::span<Vec3> normals) {
    for (Vec3& n : normals) {
        const double length = glm::length(n);
        if (length > 0.0) n /= length;
    }
}

/// Directions to the corners of a tetrahedron, along which the slope of a pattern is taken.
constexpr std::array<Vec3, 4> pyramid{Vec3{0.942809041, -0.333333333, 0.0},
                                      Vec3{-0.471404521, -0.333333333, 0.816496581},
                                      Vec3{-0.471404521, -0.333333333, -0.816496581}, Vec3{0.0, 1.0, 0.0}};

}  // namespace

void normals_into(std::span<const Warp> chain, bool normalise, std::span<Vec3> normals) {
    if (normalise) make_unit(normals);
    for (const Warp& warp : chain) {
        const auto* map = std::get_if<Transform>(&warp);
        if (!map) continue;
        for (Vec3& n : normals) n = map->inverse_normal(n);
        if (normalise) make_unit(normals);
    }
}

void normals_out_of(std::span<const Warp> chain, bool normalise, std::span<Vec3> normals) {
    if (normalise) make_unit(normals);
    for (size_t i = chain.size(); i-- > 0;) {
        const auto* map = std::get_if<Transform>(&chain[i]);
        if (!map) continue;
        for (Vec3& n : normals) n = map->normal(n);
        if (normalise) make_unit(normals);
    }
}

NormalProgram::NormalProgram(const Normal& normal, const PatternSettings& settings, bool no_bump_scale)
    : uv_mapping_(normal.uv_mapping),
      keeps_length_(normal.no_bump_scale || no_bump_scale),
      amount_(normal.amount),
      accuracy_(normal.accuracy) {
    if (!normal.pattern && !normal.average) return;
    field_ = PatternField(normal.average ? nullptr : normal.pattern, normal.modifiers, settings);
    if (const auto* map = std::get_if<BlendMap<NormalPtr>>(&normal.map); map && !map->empty()) {
        rule_ = normal.average ? Rule::average : Rule::children;
        positions_ = MapPositions::of(*map);
        for (const auto& entry : *map) children_.emplace_back(*entry.value, settings, keeps_length_);
        return;
    }
    if (normal.average) return;
    rule_ = Rule::pattern;
    if (const auto* map = std::get_if<BlendMap<HeightSlope>>(&normal.map); map && !map->empty()) {
        positions_ = MapPositions::of(*map);
        for (const auto& entry : *map) slopes_.push_back(entry.value);
    }
}

SurfaceNeed NormalProgram::surface_need() const {
    SurfaceNeed need = std::max(uv_mapping_ ? SurfaceNeed::place : SurfaceNeed::none, field_.surface_need());
    for (const NormalProgram& child : children_) need = std::max(need, child.surface_need());
    return need;
}

void NormalProgram::perturb(const PatternSamples& samples, std::span<Vec3> normals) const {
    if (rule_ == Rule::none) return;
    Scratch::Scope memory(thread_scratch());
    const auto points = uv_mapping_ ? uv_points(samples, memory) : samples.points;
    const PatternSamples moved = samples.at(carried(field_, points, memory));
    const std::span<const Warp> chain =
        uv_mapping_ ? std::span<const Warp>{} : std::span<const Warp>(field_.modifiers().warps);
    normals_into(chain, !keeps_length_, normals);
    apply(moved, normals);
    normals_out_of(chain, !keeps_length_, normals);
    if (rule_ != Rule::pattern || uv_mapping_) make_unit(normals);
}

void NormalProgram::apply(const PatternSamples& moved, std::span<Vec3> normals) const {
    switch (rule_) {
        case Rule::pattern:
            if (!field_.perturb(moved, amount_, normals)) slope_of_values(moved, normals);
            return;
        case Rule::children:
            return blend_children(moved, normals);
        case Rule::average:
            return average_children(moved, normals);
        case Rule::none:
            return;
    }
}

double NormalProgram::height(double value) const {
    if (slopes_.empty()) return value;
    const MapPlace place = positions_.find(value);
    const HeightSlope& a = slopes_[place.first];
    if (place.first == place.second) return a.height;
    const HeightSlope& b = slopes_[place.second];
    const double t = place.t;
    const double h0 = a.height;
    const double h1 = b.height;
    const double s0 = a.slope;
    const double s1 = b.slope;
    return t * t * t * (s0 + s1 + 2.0 * (h0 - h1)) - t * t * (2.0 * s0 + s1 + 3.0 * (h0 - h1)) + t * s0 + h0;
}

void NormalProgram::slope_of_values(const PatternSamples& moved, std::span<Vec3> normals) const {
    Scratch::Scope memory(thread_scratch());
    const auto values = memory.take<double>(normals.size());
    const auto points = memory.take<Vec3>(normals.size());
    const double step = accuracy_;
    const double strength = static_cast<double>(amount_) * -5.0 * (0.02 / step);
    for (const Vec3& toward : pyramid) {
        for (size_t i = 0; i < points.size(); ++i) points[i] = moved.points[i] + step * toward;
        field_.values(moved.at(points), values);
        for (size_t i = 0; i < normals.size(); ++i) normals[i] += strength * height(values[i]) * toward;
    }
}

void NormalProgram::blend_children(const PatternSamples& moved, std::span<Vec3> normals) const {
    Scratch::Scope memory(thread_scratch());
    const auto values = memory.take<double>(normals.size());
    field_.values(moved, values);
    const BlendParts parts = split_by_entry(positions_, values, memory);
    const auto sum = memory.take<Vec3>(normals.size(), Vec3{0.0});
    for (size_t k = 0; k < children_.size(); ++k) {
        const auto rows = parts.rows_of(k);
        if (rows.empty()) continue;
        Scratch::Scope part_memory(thread_scratch());
        const auto turned = part_memory.take<Vec3>(rows.size());
        for (size_t i = 0; i < rows.size(); ++i) turned[i] = normals[rows[i]];
        children_[k].perturb(gather(moved, rows, part_memory), turned);
        const auto weights = parts.weights_of(k);
        for (size_t i = 0; i < rows.size(); ++i) sum[rows[i]] += static_cast<double>(weights[i]) * turned[i];
    }
    std::copy(sum.begin(), sum.end(), normals.begin());
}

void NormalProgram::average_children(const PatternSamples& moved, std::span<Vec3> normals) const {
    Scratch::Scope memory(thread_scratch());
    const auto turned = memory.take<Vec3>(normals.size());
    const auto sum = memory.take<Vec3>(normals.size(), Vec3{0.0});
    double total = 0;
    for (size_t k = 0; k < children_.size(); ++k) {
        const double weight = positions_.positions[k];
        total += weight;
        std::copy(normals.begin(), normals.end(), turned.begin());
        children_[k].perturb(moved, turned);
        for (size_t i = 0; i < sum.size(); ++i) sum[i] += weight * turned[i];
    }
    if (total == 0.0) return;
    for (size_t i = 0; i < sum.size(); ++i) normals[i] = sum[i] / total;
}

}  // namespace rb
