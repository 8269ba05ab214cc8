#pragma once
#include "math/vec.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace rb {

/// Cosine-distributed directions around the z axis, one in each cell of a grid of rings and sectors of equal
/// weight, in several variants that differ in where in their cells they lie. Cells are numbered ring by ring
/// from the axis outward.
class HemisphereGrid {
public:
    /// `count`: how many directions there are to be, about; see size().
    explicit HemisphereGrid(int count);

    int rings() const { return rings_; }
    int sectors() const { return sectors_; }
    size_t size() const { return static_cast<size_t>(rings_) * static_cast<size_t>(sectors_); }

    size_t variants() const { return variants_; }
    /// Unit vectors by cell.
    std::span<const Vec3> variant(size_t number) const {
        return std::span(directions_).subspan(number * size(), size());
    }
    /// A further direction in a cell of a variant. Those of `number` 1, 2 ... spread over the cell, together
    /// with the first.
    Vec3 further(size_t variant, size_t cell, int number) const;
    /// The cell that a unit vector above the horizon is in.
    size_t cell_of(const Vec3& direction) const;

    /// Sines and cosines of the angles between the axis and the edges of rings; one more than there are
    /// rings.
    std::span<const double> edge_sines() const { return sines_; }
    std::span<const double> edge_cosines() const { return cosines_; }

private:
    Vec3 direction_of(size_t variant, int ring, int sector, int number) const;

    int rings_;
    int sectors_;
    size_t variants_;
    std::vector<Vec3> directions_;
    std::vector<double> sines_;
    std::vector<double> cosines_;
};

/// The directions of a grid around a normal, turned about it at random.
class Hemisphere {
public:
    Hemisphere(const HemisphereGrid& grid, const Vec3& normal, uint64_t seed);

    const HemisphereGrid& grid() const { return *grid_; }
    const Vec3& normal() const { return normal_; }

    /// Unit, world space.
    Vec3 direction(size_t cell) const { return world_of(grid_->variant(variant_)[cell]); }
    /// As HemisphereGrid::further().
    Vec3 further(size_t cell, int number) const { return world_of(grid_->further(variant_, cell, number)); }
    /// The cell of a unit vector; none below the horizon.
    std::optional<size_t> cell_of(const Vec3& direction) const {
        const double height = glm::dot(direction, normal_);
        if (!(height > 0.0)) return std::nullopt;
        return grid_->cell_of({glm::dot(direction, across_), glm::dot(direction, along_), height});
    }
    /// Unit, in the tangent plane, at an azimuth counted in sectors.
    Vec3 tangent(double sector) const;

private:
    Vec3 world_of(const Vec3& d) const { return d.x * across_ + d.y * along_ + d.z * normal_; }

    const HemisphereGrid* grid_;
    size_t variant_;
    Vec3 normal_;
    Vec3 across_;
    Vec3 along_;
};

}  // namespace rb
