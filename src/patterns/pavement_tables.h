#pragma once
#include <cstdint>
#include <string_view>
#include <vector>

namespace rb {

/// How copies of one polyform tile the plane: for each cell of the lattice a mask that says which of its
/// sides and corners lie on the tile's border. Square cells count by column i and row j, triangles by half
/// columns.
struct PavementLayout {
    int sides;    ///< of a cell
    int tiles;    ///< cells that make one tile
    int pattern;  ///< which tile of that many cells, from 1

    // Within a period of the other coordinate, rows (columns) shift by `shift` after every `step`.
    struct Repeat {
        bool shifts_columns;
        int64_t length;  ///< cells after which a row (column) repeats
        int64_t lines;   ///< different rows (columns)
        int64_t shift;
        int64_t step;
        int64_t period;
        /// Where the mask of a cell stands in the list.
        size_t index(int64_t i, int64_t j) const;
    } repeat;

    std::string_view masks;

    /// The list of masks. Bits of squares: 1, 2, 4, 8 the sides z = 1, x = 1, z = 0, x = 0; 10, 20, 40, 80
    /// corners that go in: (0,1), (1,1), (1,0), (0,0). Bits of triangles: 1, 2, 4 the left, right and bottom
    /// side; the others belong to corners.
    std::vector<uint16_t> decoded() const;
};

/// Null if there is no such pattern.
const PavementLayout* find_pavement(int sides, int tiles, int pattern);
/// The largest number of cells of a tile; 0 for sides other than 3, 4, 6.
int most_pavement_tiles(int sides);

}  // namespace rb
