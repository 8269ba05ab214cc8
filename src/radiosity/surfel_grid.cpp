#include "radiosity/surfel_grid.h"

#include "math/random.h"

#include <cmath>
#include <cstdlib>

namespace rb {

namespace {

/// Surfels that make a cell known.
const uint32_t full = getenv("P_FULL") ? atoi(getenv("P_FULL")) : 1;

/// Sizes into which a surfel goes.
const int levels = getenv("P_LEVELS") ? atoi(getenv("P_LEVELS")) : 3;

/// The axis that a normal is nearest to, and its sign.
uint64_t side_of(const Vec3& normal) {
    const Vec3 size = glm::abs(normal);
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    return static_cast<uint64_t>(2 * axis + (normal[axis] < 0.0 ? 1 : 0));
}

}  // namespace

SurfelGrid::Key SurfelGrid::key_of(const Surfel& surfel, int exponent) {
    // Surfaces like to lie where coordinates are round: not so the borders of cells.
    constexpr double shift = 0.381966;
    constexpr double far = 0x1p60;
    const Vec3 scaled = glm::clamp(glm::floor(surfel.point * std::ldexp(1.0, -exponent) + shift), -far, far);
    const uint64_t surface = mixed(static_cast<uint64_t>(surfel.leaf) << 32 | surfel.member,
                                   static_cast<uint64_t>(surfel.look) << 32 |
                                       static_cast<uint64_t>(exponent + 4096) << 8 | side_of(surfel.normal));
    const uint64_t xy = mixed(surface, static_cast<uint64_t>(static_cast<int64_t>(scaled.x)));
    const uint64_t z = mixed(xy, static_cast<uint64_t>(static_cast<int64_t>(scaled.y)));
    return mixed(z, static_cast<uint64_t>(static_cast<int64_t>(scaled.z))) | 1;
}

int SurfelGrid::exponent_of(const Surfel& surfel) const {
    return std::ilogb(std::max(surfel.size, least_ * glm::length(surfel.point - eye_)));
}

/// Where the cell is, or would be.
size_t SurfelGrid::slot_of(Key key) const {
    const size_t mask = cells_.size() - 1;
    size_t slot = (key >> 1) & mask;
    while (cells_[slot].key != 0 && cells_[slot].key != key) slot = (slot + 1) & mask;
    return slot;
}

bool SurfelGrid::find(const Surfel& surfel, Rgb& light) const {
    if (cells_.empty()) return false;
    const Cell& cell = cells_[slot_of(key_of(surfel, exponent_of(surfel)))];
    if (cell.key == 0 || cell.count < full) return false;
    light = cell.sum / static_cast<float>(cell.count);
    return true;
}

void SurfelGrid::insert(const Surfel& surfel) {
    ++surfels_;
    const int finest = exponent_of(surfel);
    for (int exponent = finest; exponent < finest + levels; ++exponent) {
        if (2 * (count_ + 1) > cells_.size()) grow();
        const Key key = key_of(surfel, exponent);
        Cell& cell = cells_[slot_of(key)];
        if (cell.key == 0) {
            cell.key = key;
            ++count_;
        } else if (cell.count >= full) {
            continue;
        }
        cell.sum += surfel.light;
        ++cell.count;
    }
}

void SurfelGrid::grow() {
    std::vector<Cell> old(std::max<size_t>(1024, 2 * cells_.size()));
    old.swap(cells_);
    for (const Cell& cell : old) {
        if (cell.key != 0) cells_[slot_of(cell.key)] = cell;
    }
}

}  // namespace rb
