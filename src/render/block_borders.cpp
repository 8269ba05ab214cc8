#include "render/block_borders.h"

namespace rb {

namespace {

size_t blocks_along(int length, int size) { return static_cast<size_t>((length + size - 1) / size); }

}  // namespace

BlockBorders::BlockBorders(const PixelBlock& region, int size)
    : region_(region),
      size_(size),
      columns_(blocks_along(region.width(), size)),
      borders_(columns_ * blocks_along(region.height(), size)) {}

size_t BlockBorders::index(int x, int y) const {
    return static_cast<size_t>((y - region_.y0) / size_) * columns_ +
           static_cast<size_t>((x - region_.x0) / size_);
}

const BlockBorders::Border* BlockBorders::known(int x, int y) const {
    if (x < region_.x0 || y < region_.y0) return nullptr;
    const Border& border = borders_[index(x, y)];
    return border.is_known.load(std::memory_order_acquire) ? &border : nullptr;
}

void BlockBorders::keep(const PixelBlock& block, std::span<const Radiance> centers, size_t stride) {
    const auto width = static_cast<size_t>(block.width());
    const auto height = static_cast<size_t>(block.height());
    Border& border = borders_[index(block.x0, block.y0)];
    border.right.reserve(height);
    for (size_t y = 0; y < height; ++y) border.right.push_back(centers[y * stride + width - 1]);
    const auto last_row = centers.subspan((height - 1) * stride, width);
    border.bottom.assign(last_row.begin(), last_row.end());
    border.is_known.store(true, std::memory_order_release);
}

std::span<const Radiance> BlockBorders::left_of(const PixelBlock& block) const {
    const Border* border = known(block.x0 - 1, block.y0);
    return border ? std::span<const Radiance>(border->right) : std::span<const Radiance>();
}

std::span<const Radiance> BlockBorders::above(const PixelBlock& block) const {
    const Border* border = known(block.x0, block.y0 - 1);
    return border ? std::span<const Radiance>(border->bottom) : std::span<const Radiance>();
}

std::span<const Radiance> BlockBorders::above_left_of(const PixelBlock& block) const {
    const Border* border = known(block.x0 - 1, block.y0 - 1);
    return border ? std::span<const Radiance>(border->bottom).last(1) : std::span<const Radiance>();
}

}  // namespace rb
