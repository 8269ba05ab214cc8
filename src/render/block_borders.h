#pragma once
#include "render/antialias.h"

#include <atomic>
#include <memory>
#include <vector>

namespace rb {

/// What the pixels along the right and lower borders of finished blocks have in their centres. The blocks
/// beyond look at them, too, so that they need not trace them again. Safe to use from many threads: each
/// block's border is written by one of them, once. Which ones are known depends on the order of the threads;
/// what they hold does not.
class BlockBorders {
public:
    /// For the blocks of `size` x `size` pixels that a region is cut into.
    BlockBorders(const PixelBlock& region, int size);

    /// `centers`: of the block's pixels, rows of `stride`.
    void keep(const PixelBlock& block, std::span<const Radiance> centers, size_t stride);

    /// Top to bottom the pixels left of a block, left to right those above it, and the one that is both;
    /// empty where they are not known (yet).
    std::span<const Radiance> left_of(const PixelBlock& block) const;
    std::span<const Radiance> above(const PixelBlock& block) const;
    std::span<const Radiance> above_left_of(const PixelBlock& block) const;

private:
    struct Border {
        std::vector<Radiance> right;
        std::vector<Radiance> bottom;
        std::atomic<bool> is_known = false;
    };
    /// Null where there is no such block, or where it is not finished.
    const Border* known(int x, int y) const;
    size_t index(int x, int y) const;

    PixelBlock region_;
    int size_;
    size_t columns_;
    std::vector<Border> borders_;
};

}  // namespace rb
