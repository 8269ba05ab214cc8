#pragma once
#include "math/sobol.h"
#include "render/antialias.h"

#include <algorithm>
#include <vector>

namespace rb {

/// Through an open lens.
enum class LensRays {
    as_camera_asks,  ///< `blur_samples` for each sample
    one_each,        ///< spread over the lens by a pattern of its own
};

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

    PixelSamples(Sampler& sampler, const PixelBlock& block, LensRays lens_rays)
        : sampler_(sampler), block_(block), lens_rays_(lens_rays) {}

    int width() const { return block_.width(); }
    int height() const { return block_.height(); }
    size_t pixel_count() const { return static_cast<size_t>(width()) * static_cast<size_t>(height()); }

    /// One sample at each corner of the pixels; calls take(pixel, std::array<Radiance, 4>) for each pixel.
    template <class Take>
    void trace_corners(Take&& take) {
        positions_.clear();
        for (int y = 0; y <= height(); ++y) {
            for (int x = 0; x <= width(); ++x)
                positions_.emplace_back(block_.x0 + x - 0.5, block_.y0 + y - 0.5);
        }
        lights_.resize(positions_.size());
        sampler_.sample(positions_, lights_);
        const auto row = static_cast<size_t>(width() + 1);
        for (size_t pixel = 0; pixel < pixel_count(); ++pixel) {
            const size_t k = pixel + pixel / (row - 1);
            take(pixel, std::array{lights_[k], lights_[k + 1], lights_[k + row], lights_[k + row + 1]});
        }
    }

    /// Calls take(pixel, light) for each sample, in order.
    template <class Take>
    void trace(std::span<const Wanted> wanted, Take&& take) {
        constexpr size_t most_at_once = 8192;
        clear();
        const auto flush = [&] {
            lights_.resize(positions_.size());
            if (through_lens_places()) {
                sampler_.sample(positions_, lens_places_, lights_, share_);
            } else {
                sampler_.sample(positions_, lights_, share_);
            }
            for (size_t i = 0; i < owners_.size(); ++i) take(owners_[i], lights_[i]);
            clear();
        };
        for (const Wanted& w : wanted) {
            const Vec2 center = center_of(w.pixel);
            const uint64_t seed = sampler_.seed_at(center);
            for (uint32_t k = w.first; k < w.first + w.count; ++k) {
                owners_.push_back(w.pixel);
                share_ = std::max(share_, 1.0f / static_cast<float>(w.first + w.count));
                positions_.push_back(center + scrambled_sobol(k, seed) - 0.5);
                if (through_lens_places()) lens_places_.push_back(lens_place(k, seed));
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
    bool through_lens_places() const { return lens_rays_ == LensRays::one_each && sampler_.has_open_lens(); }
    /// Spread over the lens, and nothing to do with where in the pixel.
    static Vec2 lens_place(uint32_t k, uint64_t pixel_seed) {
        const uint64_t seed = mixed(pixel_seed, 1);
        return scrambled_sobol(shuffled_index(k, static_cast<uint32_t>(seed >> 16)), seed);
    }
    void clear() {
        owners_.clear();
        positions_.clear();
        lens_places_.clear();
        share_ = 0;
    }
    Vec2 center_of(uint32_t pixel) const {
        const int width = block_.width();
        return {block_.x0 + static_cast<int>(pixel) % width, block_.y0 + static_cast<int>(pixel) / width};
    }

    Sampler& sampler_;
    const PixelBlock& block_;
    LensRays lens_rays_;
    std::vector<uint32_t> owners_;
    std::vector<Vec2> positions_;
    std::vector<Vec2> lens_places_;
    float share_ = 0;  ///< of a pixel, that the largest of the samples is
    std::vector<Radiance> lights_;
};

}  // namespace rb
