#pragma once
#include "math/sobol.h"
#include "render/antialias.h"

#include <algorithm>
#include <vector>

namespace rb {

/// The pixels of a block, which get ever more samples at places of a pattern of their own: Owen-scrambled
/// Sobol points, evenly over the pixel's square.
class PixelSamples {
public:
    /// Samples first .. first + count - 1 of a pixel (row by row in the block).
    struct Wanted {
        uint32_t pixel = 0;
        uint32_t first = 0;
        uint32_t count = 0;
    };

    PixelSamples(Sampler& sampler, const PixelBlock& block) : sampler_(sampler), block_(block) {}

    int width() const { return block_.width(); }
    int height() const { return block_.height(); }
    size_t pixel_count() const { return static_cast<size_t>(width()) * static_cast<size_t>(height()); }

    /// Calls take(pixel, light) for each sample, in order.
    template <class Take>
    void trace(std::span<const Wanted> wanted, Take&& take) {
        constexpr size_t most_at_once = 8192;
        owners_.clear();
        positions_.clear();
        const auto flush = [&] {
            lights_.resize(positions_.size());
            sampler_.sample(positions_, lights_);
            for (size_t i = 0; i < owners_.size(); ++i) take(owners_[i], lights_[i]);
            owners_.clear();
            positions_.clear();
        };
        for (const Wanted& w : wanted) {
            for (uint32_t k = w.first; k < w.first + w.count; ++k) {
                owners_.push_back(w.pixel);
                positions_.push_back(place(w.pixel, k));
                if (positions_.size() == most_at_once) flush();
            }
        }
        flush();
    }

    /// Calls visit(index) for the pixels of the block beside one, and those across its corners, too, if
    /// asked.
    template <class Visit>
    void each_neighbour(size_t pixel, bool across_corners, Visit&& visit) const {
        const int x = static_cast<int>(pixel) % width();
        const int y = static_cast<int>(pixel) / width();
        for (int v = std::max(y - 1, 0); v <= std::min(y + 1, height() - 1); ++v) {
            for (int u = std::max(x - 1, 0); u <= std::min(x + 1, width() - 1); ++u) {
                if ((u == x && v == y) || (u != x && v != y && !across_corners)) continue;
                visit(static_cast<size_t>(v * width() + u));
            }
        }
    }

private:
    Vec2 place(uint32_t pixel, uint32_t k) const {
        const int width = block_.width();
        const Vec2 center{block_.x0 + static_cast<int>(pixel) % width,
                          block_.y0 + static_cast<int>(pixel) / width};
        return center + scrambled_sobol(k, sampler_.seed_at(center)) - 0.5;
    }

    Sampler& sampler_;
    const PixelBlock& block_;
    std::vector<uint32_t> owners_;
    std::vector<Vec2> positions_;
    std::vector<Radiance> lights_;
};

}  // namespace rb
