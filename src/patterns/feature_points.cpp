#include "patterns/feature_points.h"

#include <cstdlib>
#include <limits>

namespace rb {

namespace {

int32_t add(int32_t a, int b) {
    return static_cast<int32_t>(static_cast<uint32_t>(a) + static_cast<uint32_t>(b));
}

size_t hash(const FeatureCell& cell) {
    // Teschner et al., "Optimized Spatial Hashing for Collision Detection of Deformable Objects", 2003.
    return static_cast<uint32_t>(cell.x) * 73856093u ^ static_cast<uint32_t>(cell.y) * 19349663u ^
           static_cast<uint32_t>(cell.z) * 83492791u;
}

}  // namespace

NearFeatures::NearFeatures() : entries_(entry_count) {
    constexpr double far = std::numeric_limits<double>::infinity();
    for (Entry& entry : entries_) {
        for (auto* axis : {&entry.features.x, &entry.features.y, &entry.features.z}) axis->fill(far);
    }
}

NearFeatures& NearFeatures::of_this_thread() {
    thread_local NearFeatures features;
    return features;
}

const FeatureLanes& NearFeatures::around(const FeatureCell& cell) {
    Entry& entry = entries_[hash(cell) % entry_count];
    if (!entry.filled || entry.cell != cell) {
        fill(entry.features, cell);
        entry.cell = cell;
        entry.filled = true;
    }
    return entry.features;
}

/// The random numbers of a cell begin at its hash3(), whose links are shared by the cells of a row.
void NearFeatures::fill(FeatureLanes& features, const FeatureCell& cell) const {
    constexpr int far = 2;
    const auto link = [](uint32_t before, int32_t coordinate) {
        return hash_table[before ^ (static_cast<uint32_t>(coordinate) & 4095u)];
    };
    size_t next = 0;
    for (int dx = -far; dx <= far; ++dx) {
        const int32_t x = add(cell.x, dx);
        const uint32_t of_x = link(0, x);
        for (int dy = -far; dy <= far; ++dy) {
            const bool is_far = std::abs(dx) == far || std::abs(dy) == far;
            if (std::abs(dx) == far && std::abs(dy) == far) continue;
            const int32_t y = add(cell.y, dy);
            const uint32_t of_xy = link(of_x, y);
            const int reach = is_far ? far - 1 : far;
            for (int dz = -reach; dz <= reach; ++dz) {
                const int32_t z = add(cell.z, dz);
                const uint32_t first = link(of_xy, z);
                features.x[next] = x + random_[first];
                features.y[next] = y + random_[first + 1];
                features.z[next++] = z + random_[first + 2];
            }
        }
    }
}

}  // namespace rb
