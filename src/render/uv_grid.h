#pragma once
#include "math/vec.h"

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace rb {

/// Finds the triangle of a mesh's uv coordinates that a place lies in, by a grid of cells over the unit
/// square that list the triangles near them. Places and triangles beyond the square count for the nearest
/// cells.
class UvGrid {
public:
    using Triangles = std::span<const std::array<uint32_t, 3>>;

    /// What a place lies in: the first triangle, and the weights of its second and third corner.
    struct Place {
        uint32_t triangle = 0;
        double b = 0;
        double c = 0;
    };

    /// Both must outlive the grid.
    UvGrid(std::span<const Vec2> uvs, Triangles triangles);

    std::optional<Place> find(const Vec2& uv) const;
    /// The same by looking at each triangle.
    std::optional<Place> find_slowly(const Vec2& uv) const;

private:
    struct Cells {
        size_t x0 = 0;
        size_t y0 = 0;
        size_t x1 = 0;
        size_t y1 = 0;
    };
    std::optional<Place> place_in(uint32_t triangle, const Vec2& uv) const;
    size_t cell_of(double coordinate) const;
    Cells cells_of(uint32_t triangle) const;
    size_t entry_count() const;
    void fill();

    std::span<const Vec2> uvs_;
    Triangles triangles_;
    size_t side_ = 1;               ///< cells along each axis
    std::vector<uint32_t> begins_;  ///< of cells, row by row, in `listed_`; then its size
    std::vector<uint32_t> listed_;  ///< triangles, in order within each cell
};

}  // namespace rb
