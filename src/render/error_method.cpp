// Our own method: samples until the error is small enough.
#include "render/adaptive_methods.h"
#include "render/pixel_samples.h"

#include <algorithm>
#include <cmath>

namespace rb {

namespace {

constexpr uint32_t quarters = 4;
constexpr uint32_t fewest_samples = 8;
/// A pixel has at least this share of the samples of the pixels around it.
constexpr uint32_t least_share = 4;

constexpr size_t components = 4;  // red, green, blue, transmit

/// A pixel's samples, as the sums of their quarters.
class QuarteredPixel {
public:
    uint32_t count() const { return count_; }
    /// The next samples are as many as there are: two of the quarters.
    void begin_step() {
        if (count_ == 0) return;
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
    uint32_t per_quarter_ = fewest_samples / quarters;
};

/// The greatest error of a channel as a picture shows it.
double shown_error(const QuarteredPixel& pixel, const SampleDistance& distance) {
    const auto shown = [&](double v) {
        return distance.encoded(static_cast<float>(std::clamp(v, 0.0, 1.0)));
    };
    double greatest = pixel.standard_error(3);
    for (size_t c = 0; c < 3; ++c) {
        const double mean = pixel.mean(c);
        const double error = pixel.standard_error(c);
        greatest = std::max(greatest, 0.5 * (shown(mean + error) - shown(mean - error)));
    }
    return greatest;
}

}  // namespace

void render_by_error(Sampler& sampler, const PixelBlock& block, const AntialiasOptions& options,
                     const SampleDistance& distance, std::span<Radiance> out) {
    PixelSamples samples(sampler, block);
    std::vector<QuarteredPixel> pixels(samples.pixel_count());
    const auto take = [&](uint32_t pixel, const Radiance& light) { pixels[pixel].add(light); };
    std::vector<PixelSamples::Wanted> wanted;
    for (uint32_t i = 0; i < pixels.size(); ++i) wanted.push_back({i, 0, fewest_samples});
    while (!wanted.empty()) {
        for (const auto& w : wanted) pixels[w.pixel].begin_step();
        samples.trace(wanted, take);
        wanted.clear();
        for (uint32_t i = 0; i < pixels.size(); ++i) {
            const uint32_t count = pixels[i].count();
            if (2 * count > options.max_samples) continue;
            bool wants_more = shown_error(pixels[i], distance) > options.error;
            samples.each_neighbour(i, true, [&](size_t k) {
                wants_more = wants_more || pixels[k].count() > least_share * count;
            });
            if (wants_more) wanted.push_back({i, count, count});
        }
    }
    for (size_t i = 0; i < pixels.size(); ++i) {
        const auto mean = [&](size_t channel) { return static_cast<float>(pixels[i].mean(channel)); };
        out[i] = {{mean(0), mean(1), mean(2)}, mean(3)};
    }
}

}  // namespace rb
