#include "render/antialias.h"

#include "base/scratch.h"
#include "math/jitter.h"
#include "render/adaptive_methods.h"
#include "render/block_borders.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace rb {

namespace {

/// Over the rays that exist; where none does, what any of them shows.
Radiance mean(std::span<const CameraRay> rays, std::span<const Radiance> lights) {
    Radiance sum;
    int count = 0;
    for (size_t k = 0; k < rays.size(); ++k) {
        if (!rays[k].exists) continue;
        sum.rgb += lights[k].rgb;
        sum.transmit += lights[k].transmit;
        ++count;
    }
    if (count == 0) return lights.front();
    const float scale = 1.0f / static_cast<float>(count);
    return {sum.rgb * scale, sum.transmit * scale};
}

}  // namespace

void Sampler::sample(std::span<const Vec2> positions, std::span<Radiance> out, float share) {
    if (lens_.is_open()) return sample_through_lens(positions, out, share);
    if (rays_.rays_per_position() > 1) return sample_several(positions, out, share);
    Scratch::Scope memory(thread_scratch());
    const auto batch = memory.take<CameraRay>(positions.size());
    rays_.at(positions, batch);
    for (size_t i = 0; i < positions.size(); ++i) {
        batch[i].seed = seed_at(positions[i]);
        batch[i].share = share;
    }
    integrator_.trace(batch, out, counters_, indirect_);
}

void Sampler::sample(std::span<const Vec2> positions, std::span<const Vec2> lens_places,
                     std::span<Radiance> out, float share) {
    Scratch::Scope memory(thread_scratch());
    const auto batch = memory.take<CameraRay>(positions.size());
    for (size_t i = 0; i < positions.size(); ++i) {
        batch[i].exists = lens_.ray(rays_, positions[i], lens_places[i], batch[i].ray);
        batch[i].seed = seed_at(positions[i]);
        batch[i].share = share;
    }
    integrator_.trace(batch, out, counters_, indirect_);
}

/// The mean over those rays of a position that exist; as many positions at once as fill a batch.
void Sampler::sample_several(std::span<const Vec2> positions, std::span<Radiance> out, float share) {
    constexpr size_t usual_batch = 1024;
    const auto several = static_cast<size_t>(rays_.rays_per_position());
    const size_t at_once = std::max<size_t>(usual_batch / several, 1);
    Scratch::Scope memory(thread_scratch());
    const auto batch = memory.take<CameraRay>(at_once * several);
    const auto lights = memory.take<Radiance>(batch.size());
    for (size_t begin = 0; begin < positions.size(); begin += at_once) {
        const auto places = positions.subspan(begin, std::min(at_once, positions.size() - begin));
        const size_t count = places.size() * several;
        for (size_t i = 0; i < count; ++i) {
            const Vec2& p = places[i / several];
            const size_t k = i % several;
            batch[i].exists = rays_.at(p.x, p.y, static_cast<int>(k), batch[i].ray);
            batch[i].seed = mixed(seed_at(p), k);
            batch[i].share = share / static_cast<float>(several);
        }
        integrator_.trace(batch.first(count), lights.first(count), counters_, indirect_);
        for (size_t i = 0; i < places.size(); ++i) {
            out[begin + i] = mean(batch.subspan(i * several, several), lights.subspan(i * several, several));
        }
    }
}

/// Chunk by chunk over all positions that want more samples still.
void Sampler::sample_through_lens(std::span<const Vec2> positions, std::span<Radiance> out, float share) {
    std::vector<CameraRay> batch;
    std::vector<LensSum> sums(positions.size());
    std::vector<size_t> open(positions.size());
    for (size_t i = 0; i < open.size(); ++i) open[i] = i;
    std::vector<Radiance> lights;
    while (!open.empty()) {
        batch.clear();
        for (const size_t i : open) {
            const int first = sums[i].count;
            const int count = first + lens_.next_chunk(first);
            for (int k = first; k < count; ++k) {
                CameraRay& ray = batch.emplace_back();
                ray.share = share / static_cast<float>(count);
                ray.exists = lens_.ray(rays_, positions[i].x, positions[i].y, k, ray.ray);
                ray.seed = mixed(seed_at(positions[i]), static_cast<uint64_t>(k));
            }
        }
        lights.resize(batch.size());
        integrator_.trace(batch, lights, counters_, indirect_);
        size_t next = 0;
        std::erase_if(open, [&](size_t i) {
            const int last = sums[i].count + lens_.next_chunk(sums[i].count);
            for (; sums[i].count < last; ++next) lens_.add(sums[i], batch[next], lights[next]);
            return lens_.is_settled(sums[i]);
        });
    }
    for (size_t i = 0; i < out.size(); ++i) {
        const float scale = 1.0f / static_cast<float>(sums[i].count);
        out[i] = {sums[i].light.rgb * scale, sums[i].light.transmit * scale};
    }
}

namespace {

void render_plain(Sampler& sampler, const PixelBlock& block, std::span<Radiance> out) {
    std::vector<Vec2> positions;
    positions.reserve(out.size());
    for (int y = block.y0; y < block.y1; ++y) {
        for (int x = block.x0; x < block.x1; ++x) positions.emplace_back(x, y);
    }
    sampler.sample(positions, out);
}

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

void render_block(Sampler& sampler, const PixelBlock& block, const AntialiasOptions& options,
                  const SampleDistance& distance, BlockBorders* borders, std::span<Radiance> out) {
    switch (options.method) {
        case 1:
            NeighbourMethod(sampler, block, options, distance, borders).render(out);
            break;
        case 2:
            CornerMethod(sampler, block, options, distance).render(out);
            break;
        case 3:
            render_by_confidence(sampler, block, options, distance, out);
            break;
        case method_by_error:
            render_by_error(sampler, block, options, distance, out);
            break;
        default:
            render_plain(sampler, block, out);
            break;
    }
}

}  // namespace rb
