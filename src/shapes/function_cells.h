#pragma once
#include "math/bounds.h"
#include "math/interval_slope.h"
#include "math/ray.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <bitset>
#include <functional>
#include <memory>

namespace rb {

/// What is known of a function's sign over a whole cell.
enum class CellSign : uint8_t { unclear, above, below };

/// A box cut into equal cells, with the sign that a function surely has in each of them and, where that is
/// unclear, how steep it may be. What stands in a block of cells is found when it is first asked for: most of
/// a scene's isosurfaces are met by few rays.
class FunctionCells {
public:
    using Value = std::function<Interval(const Bounds&)>;
    using Bound = std::function<IntervalSlope(const LinePlace& place)>;

    /// `value` holds every value of the function at a place; it is kept. Big boxes are asked first.
    FunctionCells(const Bounds& box, Value value);
    ~FunctionCells();
    FunctionCells(const FunctionCells&) = delete;
    FunctionCells& operator=(const FunctionCells&) = delete;

    /// The box of all cells but those of a given sign, or a little more.
    Bounds hull(bool with_above, bool with_below) const;

    /// Cuts a ray's way through the box, from `t` to `end`, and calls piece(from, to, sign, cell) from the
    /// front until it returns false; then it returns false, too. An unclear cell is a piece of its own;
    /// neighbouring cells of one sign are one piece.
    template <class Piece>
    bool walk(const Ray& ray, double t, double end, const Piece& piece) const;

    /// A closer look at an unclear cell. `bound`, a Bound, is asked once in each.
    struct Content {
        CellSign sign = CellSign::unclear;
        Interval slope;  ///< every difference quotient along a direction; if infinite, nothing is known
    };
    template <class AsBound>
    Content content(size_t cell, const Vec3& direction, const AsBound& bound) const {
        Cell& detail = opened(cell / block_size).cells[cell % block_size];
        if (!detail.known.load(std::memory_order_acquire)) find(cell, bound, detail);
        return content(detail, direction);
    }

    /// The places of a box, as seen by one who moves along an axis.
    static LinePlace along(int axis, const Bounds& box);

    static constexpr int side = 16;
    static constexpr double cell_share = 1.0 / side;  ///< of the box, along each axis

private:
    static constexpr int block_side = 2;
    static constexpr size_t block_size = size_t{block_side} * block_side * block_side;
    static constexpr int blocks_aside = side / block_side;
    static constexpr size_t block_count = size_t{blocks_aside} * blocks_aside * blocks_aside;

    struct Cell {
        CellSign sign = CellSign::unclear;
        // A closer look, with slopes along the axes. Many threads may write the same.
        std::atomic<bool> known{false};
        std::atomic<CellSign> closer{CellSign::unclear};
        std::array<std::atomic<float>, 6> ends;
    };
    struct Block {
        std::array<Cell, block_size> cells;
    };

    /// Cells of a block follow one another.
    static size_t index(int x, int y, int z) {
        const int block = (z / block_side * blocks_aside + y / block_side) * blocks_aside + x / block_side;
        const int within = (z % block_side * block_side + y % block_side) * block_side + x % block_side;
        return static_cast<size_t>(block) * block_size + static_cast<size_t>(within);
    }
    static glm::ivec3 place_of(size_t cell);

    CellSign sign(size_t cell) const {
        const size_t block = cell / block_size;
        const CellSign sign = sign_of_block(block);
        return sign == CellSign::unclear ? opened(block).cells[cell % block_size].sign : sign;
    }
    CellSign sign_of_block(size_t block) const {
        return unclear_[block] ? CellSign::unclear : below_[block] ? CellSign::below : CellSign::above;
    }
    Block& opened(size_t block) const {
        Block* const known = blocks_[block].load(std::memory_order_acquire);
        return known ? *known : open(block);
    }
    Block& open(size_t block) const;
    /// Finds the sign of the blocks in the cube of cells from a place on.
    void look(const glm::ivec3& at, int width);
    Bounds cube(const glm::ivec3& at, int width) const;
    /// A little more, since rounding may put a ray's way into the next cell.
    Bounds widened_cube(const glm::ivec3& at, int width) const;
    void find(size_t cell, const Bound& bound, Cell& detail) const;
    static Content content(const Cell& detail, const Vec3& direction);
    /// Where the ray meets a plane between cells; nowhere, if along it.
    double meets(const Ray& ray, int axis, int plane, double inverse) const {
        return ray.direction[axis] == 0.0
                   ? std::numeric_limits<double>::infinity()
                   : (box_.lo[axis] + plane * step_[axis] - ray.origin[axis]) * inverse;
    }

    Bounds box_;
    Vec3 step_;  ///< size of a cell
    Value value_;
    std::bitset<block_count> unclear_;
    std::bitset<block_count> below_;                                 ///< of the others
    mutable std::array<std::atomic<Block*>, block_count> blocks_{};  ///< those that were asked for
};

template <class Piece>
bool FunctionCells::walk(const Ray& ray, double t, double end, const Piece& piece) const {
    const Vec3 start = ray.at(t);
    int at[3];
    int way[3];
    double next[3];  // where the ray leaves the cell along each axis
    double inverse[3];
    for (int i = 0; i < 3; ++i) {
        at[i] = std::clamp(static_cast<int>((start[i] - box_.lo[i]) / step_[i]), 0, side - 1);
        way[i] = ray.direction[i] < 0.0 ? -1 : 1;
        inverse[i] = 1.0 / ray.direction[i];
        next[i] = meets(ray, i, at[i] + (way[i] > 0), inverse[i]);
    }
    double from = t;
    size_t cell = index(at[0], at[1], at[2]);
    CellSign before = sign(cell);
    for (;;) {
        const int axis = next[0] < next[1] ? (next[0] < next[2] ? 0 : 2) : (next[1] < next[2] ? 1 : 2);
        const double here = next[axis];
        at[axis] += way[axis];
        if (!(here < end) || at[axis] < 0 || at[axis] >= side) return piece(from, end, before, cell);
        next[axis] = meets(ray, axis, at[axis] + (way[axis] > 0), inverse[axis]);
        const size_t entered = index(at[0], at[1], at[2]);
        const CellSign now = sign(entered);
        if (now != before || now == CellSign::unclear) {
            if (here > from) {
                if (!piece(from, here, before, cell)) return false;
                from = here;
            }
            before = now;
        }
        cell = entered;
    }
}

}  // namespace rb
