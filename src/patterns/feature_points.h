#pragma once
#include "patterns/formula.h"
#include "patterns/noise.h"
#include "patterns/noise_tables.h"

#include <array>

namespace rb {

/// Offsets to the 81 cells around a cell that may hold the nearest feature points of crackle and facets: up
/// to 2 away, with at most one component of 2.
struct CellOffset {
    int x = 0;
    int y = 0;
    int z = 0;
};
const std::array<CellOffset, 81>& near_cells();

/// The lattice cell of a point, and the one random point that each cell holds.
struct FeatureCell {
    int32_t x = 0;
    int32_t y = 0;
    int32_t z = 0;

    static FeatureCell of(const Vec3& p) {
        return {truncated(std::floor(p.x - tiny)), truncated(std::floor(p.y - tiny)),
                truncated(std::floor(p.z - tiny))};
    }
    friend bool operator==(const FeatureCell&, const FeatureCell&) = default;
    Vec3 point_at(const CellOffset& offset, const UniformTable& random) const {
        const auto add = [](int32_t a, int b) {
            return static_cast<int32_t>(static_cast<uint32_t>(a) + static_cast<uint32_t>(b));
        };
        const int32_t i = add(x, offset.x);
        const int32_t j = add(y, offset.y);
        const int32_t k = add(z, offset.z);
        const uint32_t s =
            hash3(static_cast<uint32_t>(i), static_cast<uint32_t>(j), static_cast<uint32_t>(k));
        return {i + random[s], j + random[s + 1], k + random[s + 2]};
    }
};

/// The feature points around a cell, coordinate by coordinate; the last three are infinitely far away, to
/// make up fours.
struct FeatureLanes {
    static constexpr size_t size = 84;
    alignas(32) std::array<double, size> x{};
    alignas(32) std::array<double, size> y{};
    alignas(32) std::array<double, size> z{};
};

/// The 81 feature points around a cell, kept while successive points lie in the same cell.
class NearFeatures {
public:
    NearFeatures();
    /// Kept from call to call: points that come one at a time mostly lie in the same cell, too.
    static NearFeatures& of_this_thread();

    const std::array<Vec3, 81>& around(const FeatureCell& cell);
    /// The same points.
    const FeatureLanes& lanes_around(const FeatureCell& cell);

private:
    const UniformTable& random_ = uniform_table();
    bool filled_ = false;
    FeatureCell cell_;
    std::array<Vec3, 81> points_{};
    FeatureLanes lanes_;
};

}  // namespace rb
