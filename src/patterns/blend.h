#pragma once
#include "base/scratch.h"
#include "patterns/pattern_field.h"

namespace rb {

/// The positions of a map or list, without its values.
struct MapPositions {
    std::vector<float> positions;
    bool sorted = true;

    template <class Entries>
    static MapPositions of(const Entries& entries) {
        MapPositions map;
        for (const auto& entry : entries) {
            if (!map.positions.empty() && entry.position < map.positions.back()) map.sorted = false;
            map.positions.push_back(entry.position);
        }
        return map;
    }
    MapPlace find(double value) const { return find_in_map(positions, sorted, value); }
};

/// Which rows of a batch each entry of a map must be evaluated for, and with what weight. Entry k owns
/// [start[k], start[k+1]) of `rows` and `weights`. A row appears once or twice.
struct BlendParts {
    std::span<const uint32_t> start;
    std::span<const uint32_t> rows;
    std::span<const float> weights;

    std::span<const uint32_t> rows_of(size_t entry) const {
        return rows.subspan(start[entry], start[entry + 1] - start[entry]);
    }
    std::span<const float> weights_of(size_t entry) const {
        return weights.subspan(start[entry], start[entry + 1] - start[entry]);
    }
};

BlendParts split_by_entry(const MapPositions& map, std::span<const double> values, Scratch::Scope& memory);

/// Copies the named rows of a batch into a smaller one.
PatternSamples gather(const PatternSamples& samples, std::span<const uint32_t> rows, Scratch::Scope& memory);

/// Points of a batch, carried through a field's warps; the batch itself if there are none.
std::span<const Vec3> carried(const PatternField& field, std::span<const Vec3> points,
                              Scratch::Scope& memory);

/// The points (u, v, 0) of a batch.
std::span<const Vec3> uv_points(const PatternSamples& samples, Scratch::Scope& memory);

}  // namespace rb
