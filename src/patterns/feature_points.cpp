#include "patterns/feature_points.h"

#include <cstdlib>
#include <limits>

namespace rb {

const std::array<CellOffset, 81>& near_cells() {
    static const std::array<CellOffset, 81> offsets = [] {
        std::array<CellOffset, 81> out;
        size_t count = 0;
        for (int x = -2; x <= 2; ++x) {
            for (int y = -2; y <= 2; ++y) {
                for (int z = -2; z <= 2; ++z) {
                    const int twos = (std::abs(x) == 2) + (std::abs(y) == 2) + (std::abs(z) == 2);
                    if (twos <= 1) out[count++] = {x, y, z};
                }
            }
        }
        return out;
    }();
    return offsets;
}

NearFeatures::NearFeatures() {
    constexpr double far = std::numeric_limits<double>::infinity();
    for (auto* axis : {&lanes_.x, &lanes_.y, &lanes_.z}) axis->fill(far);
}

NearFeatures& NearFeatures::of_this_thread() {
    thread_local NearFeatures features;
    return features;
}

const std::array<Vec3, 81>& NearFeatures::around(const FeatureCell& cell) {
    if (filled_ && cell == cell_) return points_;
    const auto& offsets = near_cells();
    for (size_t i = 0; i < offsets.size(); ++i) {
        points_[i] = cell.point_at(offsets[i], random_);
        lanes_.x[i] = points_[i].x;
        lanes_.y[i] = points_[i].y;
        lanes_.z[i] = points_[i].z;
    }
    cell_ = cell;
    filled_ = true;
    return points_;
}

const FeatureLanes& NearFeatures::lanes_around(const FeatureCell& cell) {
    around(cell);
    return lanes_;
}

}  // namespace rb
