// Our own method: samples until the error is small enough.
#include "render/antialias_methods.h"
#include "render/pixel_samples.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace rb {

namespace {

constexpr uint32_t quarters = 4;
/// Of a pixel whose corners do not tell enough.
constexpr uint32_t fewest_samples = 4;
constexpr uint32_t fewest_through_lens = 16;
/// A pixel has at least half of the samples of the pixels around it, lest it stops by chance.
constexpr uint32_t least_share = 2;
/// Corners are four samples, but say nothing of what is between them.
constexpr double doubt_of_corners = 2;

constexpr size_t components = 4;  // red, green, blue, transmit

/// A pixel's samples, as the sums of their quarters.
class QuarteredPixel {
public:
    /// Samples that its mean is made of.
    uint32_t count() const { return count_; }
    bool has_corners_only() const { return has_corners_only_; }
    /// Those of them that are not shared with its neighbours.
    uint32_t own_count() const { return has_corners_only_ ? 0 : count_; }
    /// What its corners show stands for its quarters until it has samples of its own.
    void take_corners(const std::array<Radiance, quarters>& corners) {
        per_quarter_ = 1;
        for (const Radiance& corner : corners) add(corner);
        has_corners_only_ = true;
    }
    /// Before its first samples.
    void begin(uint32_t count) {
        *this = {};
        per_quarter_ = count / quarters;
    }
    /// Before as many more as there are, which make half of the whole: two of the quarters.
    void begin_doubling() {
        per_quarter_ = count_ / 2;
        for (auto& sums : sums_) {
            sums[0] += sums[1];
            sums[1] = sums[2] + sums[3];
            sums[2] = sums[3] = 0.0;
        }
    }
    void add(const Radiance& light) {
        const uint32_t quarter = count_++ / per_quarter_;
        for (int c = 0; c < 3; ++c)
            sums_[static_cast<size_t>(c)][quarter] += static_cast<double>(light.rgb[c]);
        sums_[3][quarter] += static_cast<double>(light.transmit);
    }
    double mean(size_t channel) const {
        const auto& s = sums_[channel];
        return (s[0] + s[1] + s[2] + s[3]) / count_;
    }
    /// Of the mean, as if the quarters were independent.
    double standard_error(size_t channel) const {
        const double center = mean(channel);
        double squares = 0;
        for (const double sum : sums_[channel]) squares += std::pow(sum * quarters / count_ - center, 2);
        return std::sqrt(squares / (quarters * (quarters - 1)));
    }

private:
    std::array<std::array<double, quarters>, components> sums_{};
    uint32_t count_ = 0;
    uint32_t per_quarter_ = 1;
    bool has_corners_only_ = false;
};

/// The greatest error of a channel as a picture shows it; endless before there are samples.
double shown_error(const QuarteredPixel& pixel, const SampleDistance& distance) {
    if (pixel.count() == 0) return std::numeric_limits<double>::infinity();
    const auto shown = [&](double v) {
        return distance.encoded(static_cast<float>(std::clamp(v, 0.0, 1.0)));
    };
    double greatest = pixel.standard_error(3);
    for (size_t c = 0; c < 3; ++c) {
        const double mean = pixel.mean(c);
        const double error = pixel.standard_error(c);
        if (error == 0.0) continue;
        greatest = std::max(greatest, 0.5 * (shown(mean + error) - shown(mean - error)));
    }
    return pixel.has_corners_only() ? doubt_of_corners * greatest : greatest;
}

}  // namespace

void render_by_error(Sampler& sampler, const PixelBlock& block, const AntialiasOptions& options,
                     const SampleDistance& distance, std::span<Radiance> out) {
    PixelSamples samples(sampler, block, LensRays::one_each);
    std::vector<QuarteredPixel> pixels(samples.pixel_count());
    // Through a lens, what is seen at the corners says too little about what is between them.
    const uint32_t ceiling = std::max(std::bit_floor(options.max_samples), quarters);
    const uint32_t fewest = std::min(sampler.has_open_lens() ? fewest_through_lens : fewest_samples, ceiling);
    if (!sampler.has_open_lens())
        samples.trace_corners([&](size_t i, const auto& corners) { pixels[i].take_corners(corners); });
    std::vector<double> errors;
    errors.reserve(pixels.size());
    for (const QuarteredPixel& pixel : pixels) errors.push_back(shown_error(pixel, distance));
    const auto wants_more = [&](size_t i) {
        const uint32_t count = pixels[i].count();
        if (2 * count > options.max_samples) return false;
        bool wants = errors[i] > options.error;
        if (!wants)
            samples.each_neighbour(i, true,
                                   [&](size_t k) { wants |= pixels[k].count() > least_share * count; });
        return wants;
    };
    const auto take = [&](uint32_t pixel, const Radiance& light) { pixels[pixel].add(light); };
    std::vector<PixelSamples::Wanted> wanted;
    do {
        wanted.clear();
        for (uint32_t i = 0; i < pixels.size(); ++i) {
            if (!wants_more(i)) continue;
            const uint32_t own = pixels[i].own_count();
            wanted.push_back({i, own, own == 0 ? fewest : own});
        }
        for (const auto& w : wanted) {
            if (w.first == 0) {
                pixels[w.pixel].begin(w.count);
            } else {
                pixels[w.pixel].begin_doubling();
            }
        }
        samples.trace(wanted, take);
        for (const auto& w : wanted) errors[w.pixel] = shown_error(pixels[w.pixel], distance);
    } while (!wanted.empty());
    for (size_t i = 0; i < pixels.size(); ++i) {
        const auto mean = [&](size_t channel) { return static_cast<float>(pixels[i].mean(channel)); };
        out[i] = {{mean(0), mean(1), mean(2)}, mean(3)};
    }
}

}  // namespace rb
