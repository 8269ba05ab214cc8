#include "radiosity/surfel_grid.h"

#include "math/basis.h"
#include "math/random.h"

#include <algorithm>
#include <cmath>

namespace rb {

namespace {

/// The axis that a normal is nearest to, and its sign.
uint64_t side_of(const Vec3& normal) {
    const int axis = longest_axis(glm::abs(normal));
    return static_cast<uint64_t>(2 * axis + (normal[axis] < 0.0 ? 1 : 0));
}

bool agree(const Rgb& a, const Rgb& b) {
    constexpr float tolerance = 0.5f;
    const Rgb apart = glm::abs(a - b);
    const Rgb larger = glm::max(a, b);
    return std::max({apart.x, apart.y, apart.z}) <= tolerance * std::max({larger.x, larger.y, larger.z});
}

}  // namespace

SurfelGrid::Key SurfelGrid::key_of(const Surfel& surfel) const {
    // Surfaces like to lie where coordinates are round: not so the borders of cells.
    constexpr double shift = 0.381966;
    constexpr double far = 0x1p60;
    const double size = std::max(surfel.size, least_ * glm::length(surfel.point - eye_));
    const int exponent = std::ilogb(size);
    const Vec3 scaled = glm::clamp(glm::floor(surfel.point * std::ldexp(1.0, -exponent) + shift), -far, far);
    const auto whole = [](double x) { return static_cast<uint64_t>(static_cast<int64_t>(x)); };
    const uint64_t look = static_cast<uint64_t>(surfel.look) << 32 |
                          static_cast<uint64_t>(exponent + 4096) << 8 | side_of(surfel.normal);
    const Key surface = mixed(static_cast<uint64_t>(surfel.leaf) << 32 | surfel.member, look);
    return mixed(mixed(mixed(surface, whole(scaled.x)), whole(scaled.y)), whole(scaled.z));
}

/// Where the cell is, or would be.
size_t SurfelGrid::slot_of(Key key) const {
    const size_t mask = cells_.size() - 1;
    size_t slot = key & mask;
    while (cells_[slot].count != 0 && cells_[slot].key != key) slot = (slot + 1) & mask;
    return slot;
}

bool SurfelGrid::find(const Surfel& surfel, Rgb& light) const {
    if (cells_.empty()) return false;
    const Cell& cell = cells_[slot_of(key_of(surfel))];
    if (!cell.is_known()) return false;
    light = cell.light;
    return true;
}

void SurfelGrid::insert(const Surfel& surfel) {
    if (2 * (count_ + 1) > cells_.size()) grow();
    const Key key = key_of(surfel);
    Cell& cell = cells_[slot_of(key)];
    if (cell.count == 0) {
        cell = {key, surfel.light, 1};
        ++count_;
    } else if (cell.count == 1 && !agree(cell.light, surfel.light)) {
        cell.count = Cell::uneven;
    } else if (cell.count < Cell::uneven - 1) {
        ++cell.count;
        cell.light += (surfel.light - cell.light) / static_cast<float>(cell.count);
    }
}

std::vector<SurfelGrid::Cell> SurfelGrid::cells() const {
    std::vector<Cell> used;
    used.reserve(count_);
    for (const Cell& cell : cells_) {
        if (cell.count != 0) used.push_back(cell);
    }
    return used;
}

void SurfelGrid::restore(std::span<const Cell> cells) {
    for (const Cell& cell : cells) {
        if (2 * (count_ + 1) > cells_.size()) grow();
        cells_[slot_of(cell.key)] = cell;
        ++count_;
    }
}

void SurfelGrid::grow() {
    constexpr size_t fewest = 1024;
    std::vector<Cell> old(std::max(fewest, 2 * cells_.size()));
    old.swap(cells_);
    for (const Cell& cell : old) {
        if (cell.count != 0) cells_[slot_of(cell.key)] = cell;
    }
}

}  // namespace rb
