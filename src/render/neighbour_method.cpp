// Method 1: pixels that differ from their neighbours get a grid of samples.
#include "base/scratch.h"
#include "math/jitter.h"
#include "render/antialias_methods.h"
#include "render/block_borders.h"

#include <algorithm>

namespace rb {

namespace {

/// Method 1. The reference walks the pixels in order, and whether a pixel gets more samples depends on the
/// final values of its neighbours. Here the walk is repeated: what it wants and does not have yet is traced
/// as one batch, until a walk finds everything. More samples may be traced than the walk uses in the end;
/// they change nothing.
class NeighbourMethod {
public:
    NeighbourMethod(Sampler& sampler, const PixelBlock& block, const AntialiasOptions& options,
                    const SampleDistance& distance, BlockBorders* borders)
        : sampler_(sampler),
          block_(block),
          options_(options),
          distance_(distance),
          borders_(borders),
          x0_(block.x0 - 1),
          y0_(block.y0 - 1),
          width_(block.width() + 1),
          height_(block.height() + 1),
          memory_(thread_scratch()),
          center_(memory_.take<ComparableSample>(count())),
          value_(memory_.take<ComparableSample>(count())),
          refined_(memory_.take<ComparableSample>(count())),
          has_refined_(memory_.take<uint8_t>(count(), uint8_t{0})),
          done_(memory_.take<uint8_t>(count())),
          wanted_(memory_.take<size_t>(count())) {}

    void render(std::span<Radiance> out) {
        trace_centers();
        while (!walk()) trace_wanted();
        for (int y = 1; y < height_; ++y) {
            for (int x = 1; x < width_; ++x) {
                out[static_cast<size_t>((y - 1) * (width_ - 1) + x - 1)] = value_[index(x, y)].light;
            }
        }
    }

private:
    size_t count() const { return static_cast<size_t>(width_ * height_); }
    size_t index(int x, int y) const { return static_cast<size_t>(y * width_ + x); }

    void trace_centers() {
        Scratch::Scope memory(thread_scratch());
        const auto centers = memory.take<Radiance>(count());
        const auto known = memory.take<uint8_t>(count(), uint8_t{0});
        if (borders_) take_borders(centers, known);
        const auto positions = memory.take<Vec2>(count());
        const auto places = memory.take<size_t>(count());
        size_t traced = 0;
        for (int y = 0; y < height_; ++y) {
            for (int x = 0; x < width_; ++x) {
                if (known[index(x, y)]) continue;
                places[traced] = index(x, y);
                positions[traced++] = {x + x0_, y + y0_};
            }
        }
        const auto samples = memory.take<Radiance>(traced);
        sampler_.sample(positions.first(traced), samples);
        for (size_t i = 0; i < traced; ++i) centers[places[i]] = samples[i];
        if (borders_) borders_->keep(block_, centers.subspan(index(1, 1)), static_cast<size_t>(width_));
        // Made in their place: copies would wait for what has only just been stored in other pieces.
        for (size_t i = 0; i < count(); ++i)
            ::new (&center_[i]) ComparableSample(distance_.comparable(centers[i]));
    }

    /// What the blocks to the left and above have traced already.
    void take_borders(std::span<Radiance> centers, std::span<uint8_t> known) const {
        const auto take = [&](std::span<const Radiance> border, size_t first, size_t step) {
            for (size_t i = 0; i < border.size(); ++i) {
                centers[first + i * step] = border[i];
                known[first + i * step] = 1;
            }
        };
        take(borders_->above_left_of(block_), 0, 1);
        take(borders_->above(block_), 1, 1);
        take(borders_->left_of(block_), index(0, 1), static_cast<size_t>(width_));
    }

    /// True if every wanted pixel had its samples.
    bool walk() {
        std::ranges::copy(center_, value_.begin());
        std::ranges::fill(done_, uint8_t{0});
        wanted_count_ = 0;
        for (int x = 0; x < width_; ++x) done_[index(x, 0)] = 1;
        for (int y = 0; y < height_; ++y) done_[index(0, y)] = 1;
        for (int y = 1; y < height_; ++y) {
            for (int x = 1; x < width_; ++x) {
                const size_t here = index(x, y);
                const size_t left = index(x - 1, y);
                const size_t above = index(x, y - 1);
                const bool differs_left = distance_.at_least(value_[left], value_[here], options_.threshold);
                const bool differs_above =
                    distance_.at_least(value_[above], value_[here], options_.threshold);
                if (differs_left) refine(left);
                if (differs_above) refine(above);
                if (differs_left || differs_above) refine(here);
            }
        }
        return wanted_count_ == 0;
    }

    void refine(size_t pixel) {
        if (done_[pixel]) return;
        done_[pixel] = 1;
        if (has_refined_[pixel]) {
            value_[pixel] = refined_[pixel];
        } else {
            wanted_[wanted_count_++] = pixel;
        }
    }

    void trace_wanted() {
        const int n = options_.depth;
        const auto per_pixel = static_cast<size_t>(n * n);
        const auto wanted = wanted_.first(wanted_count_);
        Scratch::Scope memory(thread_scratch());
        const auto positions = memory.take<Vec2>(wanted.size() * per_pixel);
        const double step = 1.0 / n;
        size_t next = 0;
        for (const size_t pixel : wanted) {
            const int x = static_cast<int>(pixel) % width_ + x0_;
            const int y = static_cast<int>(pixel) / width_ + y0_;
            for (int j = 0; j < n; ++j) {
                for (int i = 0; i < n; ++i) {
                    const double px = x + (-0.5 + step / 2.0 + i * step);
                    const double py = y + (-0.5 + step / 2.0 + j * step);
                    const Vec2 jitter = position_jitter(px, py) * (options_.jitter / n);
                    positions[next++] = {px + jitter.x, py + jitter.y};
                }
            }
        }
        const auto samples = memory.take<Radiance>(positions.size());
        sampler_.sample(positions, samples, 1.0f / static_cast<float>(per_pixel + 1));
        for (size_t k = 0; k < wanted.size(); ++k) {
            const size_t pixel = wanted[k];
            Radiance sum = center_[pixel].light;
            for (const Radiance& sample : samples.subspan(k * per_pixel, per_pixel)) {
                sum.rgb += sample.rgb;
                sum.transmit += sample.transmit;
            }
            const float scale = 1.0f / static_cast<float>(per_pixel + 1);
            refined_[pixel] = distance_.comparable({sum.rgb * scale, sum.transmit * scale});
            has_refined_[pixel] = 1;
        }
    }

    Sampler& sampler_;
    const PixelBlock& block_;
    const AntialiasOptions& options_;
    const SampleDistance& distance_;
    BlockBorders* borders_;
    int x0_;
    int y0_;
    int width_;
    int height_;
    Scratch::Scope memory_;
    std::span<ComparableSample> center_;
    std::span<ComparableSample> value_;
    std::span<ComparableSample> refined_;
    std::span<uint8_t> has_refined_;
    std::span<uint8_t> done_;
    std::span<size_t> wanted_;
    size_t wanted_count_ = 0;
};

}  // namespace

void render_by_neighbours(Sampler& sampler, const PixelBlock& block, const AntialiasOptions& options,
                          const SampleDistance& distance, BlockBorders* borders, std::span<Radiance> out) {
    NeighbourMethod(sampler, block, options, distance, borders).render(out);
}

}  // namespace rb
