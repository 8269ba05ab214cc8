#include "patterns/blend.h"

#include <algorithm>

namespace rb {

BlendParts split_by_entry(const MapPositions& map, std::span<const double> values, Scratch::Scope& memory) {
    const size_t entries = map.positions.size();
    const auto places = memory.take<MapPlace>(values.size());
    const auto start = memory.take<uint32_t>(entries + 1, 0u);
    for (size_t i = 0; i < values.size(); ++i) {
        const MapPlace place = map.find(values[i]);
        places[i] = place;
        ++start[place.first + 1];
        if (place.second != place.first) ++start[place.second + 1];
    }
    for (size_t k = 0; k < entries; ++k) start[k + 1] += start[k];
    const auto rows = memory.take<uint32_t>(start[entries]);
    const auto weights = memory.take<float>(start[entries]);
    const auto next = memory.take<uint32_t>(entries);
    std::copy_n(start.begin(), entries, next.begin());
    for (size_t i = 0; i < values.size(); ++i) {
        const MapPlace& place = places[i];
        const bool mixed = place.second != place.first;
        rows[next[place.first]] = static_cast<uint32_t>(i);
        weights[next[place.first]++] = mixed ? static_cast<float>(1.0 - place.t) : 1.0f;
        if (!mixed) continue;
        rows[next[place.second]] = static_cast<uint32_t>(i);
        weights[next[place.second]++] = static_cast<float>(place.t);
    }
    return {start, rows, weights};
}

PatternSamples gather(const PatternSamples& samples, std::span<const uint32_t> rows, Scratch::Scope& memory) {
    const auto points = memory.take<Vec3>(rows.size());
    for (size_t i = 0; i < rows.size(); ++i) points[i] = samples.points[rows[i]];
    if (!samples.surface) return {points, nullptr, {}};
    const auto surface_rows = memory.take<uint32_t>(rows.size());
    for (size_t i = 0; i < rows.size(); ++i) surface_rows[i] = samples.rows[rows[i]];
    return {points, samples.surface, surface_rows};
}

std::span<const Vec3> carried(const PatternField& field, std::span<const Vec3> points,
                              Scratch::Scope& memory) {
    if (!field.warps_points()) return points;
    const auto moved = memory.take<Vec3>(points.size());
    std::copy(points.begin(), points.end(), moved.begin());
    field.carry(moved);
    return moved;
}

std::span<const Vec3> uv_points(const PatternSamples& samples, Scratch::Scope& memory) {
    const auto points = memory.take<Vec3>(samples.points.size(), Vec3{0.0});
    if (!samples.surface) return points;
    for (size_t i = 0; i < points.size(); ++i) {
        const Vec2& uv = samples.surface->uv[samples.rows[i]];
        points[i] = {uv.x, uv.y, 0.0};
    }
    return points;
}

}  // namespace rb
