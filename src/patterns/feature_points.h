#pragma once
#include "patterns/formula.h"
#include "patterns/noise.h"
#include "patterns/noise_tables.h"

#include <array>
#include <vector>

namespace rb {

/// A cell of the lattice, each of which holds one random point.
struct FeatureCell {
    int32_t x = 0;
    int32_t y = 0;
    int32_t z = 0;

    static FeatureCell of(const Vec3& p) {
        return {truncated(std::floor(p.x - tiny)), truncated(std::floor(p.y - tiny)),
                truncated(std::floor(p.z - tiny))};
    }
    friend bool operator==(const FeatureCell&, const FeatureCell&) = default;
};

/// The 81 feature points around a cell that may be the nearest ones of crackle and facets (those of cells up
/// to 2 away, by no more than one of the coordinates), coordinate by coordinate; the last three are
/// infinitely far away, to make up eights.
struct FeatureLanes {
    static constexpr size_t count = 81;
    static constexpr size_t size = 88;
    alignas(64) std::array<double, size> x{};
    alignas(64) std::array<double, size> y{};
    alignas(64) std::array<double, size> z{};

    Vec3 point(size_t i) const { return {x[i], y[i], z[i]}; }
};

/// The feature points around cells, kept: successive points lie in the same cell or go through a few ones
/// again and again (rays of neighbouring pixels through media).
class NearFeatures {
public:
    NearFeatures();
    static NearFeatures& of_this_thread();

    /// Until the next call.
    const FeatureLanes& around(const FeatureCell& cell);

private:
    struct Entry {
        bool filled = false;
        FeatureCell cell;
        FeatureLanes features;
    };
    static constexpr size_t entry_count = 64;

    void fill(FeatureLanes& features, const FeatureCell& cell) const;

    const UniformTable& random_ = uniform_table();
    std::vector<Entry> entries_;
};

}  // namespace rb
