// Method 2: squares are quartered where their corners differ.
#include "math/jitter.h"
#include "render/antialias_methods.h"

#include <algorithm>
#include <unordered_map>

namespace rb {

namespace {

/// Method 2: each pixel is a square whose corners are sampled; where corners differ, the square is quartered.
/// Levels are traced in batches over all pixels of the block.
class CornerMethod {
public:
    CornerMethod(Sampler& sampler, const PixelBlock& block, const AntialiasOptions& options,
                 const SampleDistance& distance)
        : sampler_(sampler),
          block_(block),
          options_(options),
          distance_(distance),
          cells_(1 << (options.depth - 1)) {}

    void render(std::span<Radiance> out) {
        trace_corners();
        pixels_.resize(out.size());
        std::vector<size_t> open(out.size());
        for (size_t i = 0; i < open.size(); ++i) open[i] = i;
        while (!open.empty()) {
            wanted_.clear();
            std::vector<size_t> unfinished;
            for (const size_t pixel : open) {
                const size_t before = wanted_.size();
                out[pixel] = cell(pixel, 0, 0, cells_);
                if (wanted_.size() != before) unfinished.push_back(pixel);
            }
            trace_wanted();
            open = std::move(unfinished);
        }
    }

private:
    using Lattice = std::unordered_map<uint32_t, ComparableSample>;
    struct Wanted {
        size_t pixel;
        uint32_t key;
    };

    static uint32_t key_of(int i, int j) { return static_cast<uint32_t>(j) << 16 | static_cast<uint32_t>(i); }

    void trace_corners() {
        std::vector<Vec2> positions;
        for (int y = 0; y <= block_.height(); ++y) {
            for (int x = 0; x <= block_.width(); ++x) {
                positions.emplace_back(block_.x0 + x - 0.5, block_.y0 + y - 0.5);
            }
        }
        std::vector<Radiance> samples(positions.size());
        sampler_.sample(positions, samples);
        for (const Radiance& light : samples) corners_.push_back(distance_.comparable(light));
    }

    Vec2 center_of(size_t pixel) const {
        const auto width = static_cast<size_t>(block_.width());
        const size_t column = pixel % width;
        const size_t row = pixel / width;
        return {block_.x0 + static_cast<double>(column), block_.y0 + static_cast<double>(row)};
    }

    /// The sample at lattice point (i, j) of a pixel, both 0..cells_; null and remembered as wanted if not
    /// traced yet.
    const ComparableSample* lattice(size_t pixel, int i, int j) {
        if ((i == 0 || i == cells_) && (j == 0 || j == cells_)) {
            const auto width = static_cast<size_t>(block_.width());
            const size_t x = pixel % width + (i ? 1 : 0);
            const size_t y = pixel / width + (j ? 1 : 0);
            return &corners_[y * (width + 1) + x];
        }
        const uint32_t key = key_of(i, j);
        const auto found = pixels_[pixel].find(key);
        if (found != pixels_[pixel].end()) return &found->second;
        wanted_.push_back({pixel, key});
        return nullptr;
    }

    /// Mean over the square of `size` lattice steps at (i, j); meaningless while samples are wanted.
    Radiance cell(size_t pixel, int i, int j, int size) {
        const std::array corners{lattice(pixel, i, j), lattice(pixel, i + size, j),
                                 lattice(pixel, i, j + size), lattice(pixel, i + size, j + size)};
        Radiance sum;
        for (const ComparableSample* corner : corners) {
            if (!corner) return sum;
        }
        if (size > 1 && differ(corners)) {
            const int half = size / 2;
            const size_t before = wanted_.size();
            for (const auto& [x, y] :
                 {std::pair{half, 0}, {0, half}, {half, half}, {size, half}, {half, size}}) {
                lattice(pixel, i + x, j + y);
            }
            if (wanted_.size() != before) return sum;
            for (const auto& [x, y] : {std::pair{0, 0}, {half, 0}, {0, half}, {half, half}}) {
                const Radiance part = cell(pixel, i + x, j + y, half);
                sum.rgb += part.rgb;
                sum.transmit += part.transmit;
            }
        } else {
            for (const ComparableSample* corner : corners) {
                sum.rgb += corner->light.rgb;
                sum.transmit += corner->light.transmit;
            }
        }
        return {sum.rgb * 0.25f, sum.transmit * 0.25f};
    }

    bool differ(const std::array<const ComparableSample*, 4>& corners) const {
        for (size_t a = 0; a < 4; ++a) {
            for (size_t b = a + 1; b < 4; ++b) {
                if (distance_.at_least(*corners[a], *corners[b], options_.threshold)) return true;
            }
        }
        return false;
    }

    void trace_wanted() {
        // A cell and its neighbour in the same pixel may want the same point.
        std::ranges::sort(wanted_, [](const Wanted& a, const Wanted& b) {
            return std::pair{a.pixel, a.key} < std::pair{b.pixel, b.key};
        });
        const auto same = [](const Wanted& a, const Wanted& b) {
            return a.pixel == b.pixel && a.key == b.key;
        };
        wanted_.erase(std::unique(wanted_.begin(), wanted_.end(), same), wanted_.end());
        std::vector<Vec2> positions;
        positions.reserve(wanted_.size());
        const double amount = options_.jitter / ((1 << options_.depth) + 1);
        for (const Wanted& w : wanted_) {
            const Vec2 center = center_of(w.pixel);
            const double px = center.x - 0.5 + static_cast<double>(w.key & 0xffffu) / cells_;
            const double py = center.y - 0.5 + static_cast<double>(w.key >> 16) / cells_;
            const Vec2 jitter = position_jitter(px, py) * amount;
            positions.emplace_back(px + jitter.x, py + jitter.y);
        }
        std::vector<Radiance> samples(positions.size());
        constexpr float of_a_cell = 0.25f;
        sampler_.sample(positions, samples, of_a_cell);
        for (size_t k = 0; k < wanted_.size(); ++k)
            pixels_[wanted_[k].pixel].emplace(wanted_[k].key, distance_.comparable(samples[k]));
    }

    Sampler& sampler_;
    const PixelBlock& block_;
    const AntialiasOptions& options_;
    const SampleDistance& distance_;
    int cells_;  ///< lattice steps along a pixel's side
    std::vector<ComparableSample> corners_;
    std::vector<Lattice> pixels_;
    std::vector<Wanted> wanted_;
};

}  // namespace

void render_by_corners(Sampler& sampler, const PixelBlock& block, const AntialiasOptions& options,
                       const SampleDistance& distance, std::span<Radiance> out) {
    CornerMethod(sampler, block, options, distance).render(out);
}

}  // namespace rb
