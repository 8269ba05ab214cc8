#pragma once
#include "shade/surfel.h"

#include <cstdint>
#include <limits>
#include <span>

namespace rb {

/// Light of matt surfaces in cells of a grid over each of their sides, in sizes of powers of two. A cell is
/// known once two surfels in it agree, with the mean of these and all that come later. Where they do not (at
/// the edge of a shadow, on both sides of a wall that stands in it) it never is. Lookups may run at once, but
/// not together with insert().
class SurfelGrid final : public SurfelLight {
public:
    /// `least`: size of the smallest cells, per distance from the eye.
    SurfelGrid(const Vec3& eye, double least) : eye_(eye), least_(least) {}

    bool find(const Surfel& surfel, Rgb& light) const override;
    void insert(const Surfel& surfel);

    /// What tells a cell from others: a hash, of which two cells have the same once in 2^63.
    using Key = uint64_t;
    struct Cell {
        Key key = 0;
        Rgb light{0.0f};     ///< mean of its surfels
        uint32_t count = 0;  ///< of surfels; 0: empty; `uneven`: the first two do not agree

        static constexpr uint32_t uneven = std::numeric_limits<uint32_t>::max();
        bool is_known() const { return count > 1 && count != uneven; }
    };
    /// Those that hold surfels, and a grid of them again.
    std::vector<Cell> cells() const;
    void restore(std::span<const Cell> cells);

    size_t cell_count() const { return count_; }
    size_t byte_count() const { return cells_.size() * sizeof(Cell); }

private:
    Key key_of(const Surfel& surfel) const;
    size_t slot_of(Key key) const;
    void grow();

    Vec3 eye_;
    double least_;
    std::vector<Cell> cells_;  ///< open addressing; as many as a power of two, at most half of them in use
    size_t count_ = 0;
};

}  // namespace rb
