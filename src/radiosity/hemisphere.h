#pragma once
#include "math/vec.h"

#include <cstdint>
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

    /// Unit vectors by cell.
    std::span<const Vec3> variant(uint64_t number) const {
        return std::span(directions_).subspan(number % variants_ * size(), size());
    }

    /// Sines and cosines of the angles between the axis and the edges of rings; one more than there are
    /// rings.
    std::span<const double> edge_sines() const { return sines_; }
    std::span<const double> edge_cosines() const { return cosines_; }

private:
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
    Vec3 direction(size_t cell) const {
        const Vec3& d = directions_[cell];
        return d.x * across_ + d.y * along_ + d.z * normal_;
    }
    /// Unit, in the tangent plane, at an azimuth counted in sectors.
    Vec3 tangent(double sector) const;

private:
    const HemisphereGrid* grid_;
    std::span<const Vec3> directions_;
    Vec3 normal_;
    Vec3 across_;
    Vec3 along_;
};

}  // namespace rb
