#pragma once
#include "shade/surfel.h"

#include <cstdint>

namespace rb {

/// Light of matt surfaces in cells of a grid over each of their sides, in sizes of powers of two: every cell
/// holds the mean of some surfels in it. Lookups may run at once, but not together with insert().
class SurfelGrid final : public SurfelLight {
public:
    /// `least`: size of the smallest cells, per distance from the eye.
    SurfelGrid(const Vec3& eye, double least) : eye_(eye), least_(least) {}

    bool find(const Surfel& surfel, Rgb& light) const override;

    /// Into the cell of its size and some larger ones, where they are not full yet.
    void insert(const Surfel& surfel);

    size_t cell_count() const { return count_; }
    size_t surfel_count() const { return surfels_; }
    size_t byte_count() const { return cells_.size() * sizeof(Cell); }

private:
    /// What tells a cell from others. Of two cells being taken for one the odds are 2^-64.
    using Key = uint64_t;
    struct Cell {
        Key key = 0;  ///< 0: empty
        Rgb sum{0.0f};
        uint32_t count = 0;
    };
    int exponent_of(const Surfel& surfel) const;
    static Key key_of(const Surfel& surfel, int exponent);
    size_t slot_of(Key key) const;
    void grow();

    Vec3 eye_;
    double least_;
    std::vector<Cell> cells_;  ///< open addressing; as many as a power of two, at most half of them in use
    size_t count_ = 0;
    size_t surfels_ = 0;
};

}  // namespace rb
