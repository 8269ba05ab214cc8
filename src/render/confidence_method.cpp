// Method 3 of POV-Ray 3.8: samples until their mean is known well enough.
#include "math/chi_square.h"
#include "render/antialias_methods.h"
#include "render/pixel_samples.h"

#include <algorithm>
#include <cmath>

namespace rb {

namespace {

constexpr size_t channels = 4;
using Channels = std::array<double, channels>;

/// Of gamma-encoded samples.
struct Spread {
    Channels sum{};
    Channels squares{};
    uint32_t count = 0;

    void add(const Channels& v) {
        for (size_t c = 0; c < channels; ++c) {
            sum[c] += v[c];
            squares[c] += v[c] * v[c];
        }
        ++count;
    }
    void add(const Spread& other) {
        for (size_t c = 0; c < channels; ++c) {
            sum[c] += other.sum[c];
            squares[c] += other.squares[c];
        }
        count += other.count;
    }
    /// Sum over the channels of the standard errors of the mean; endless for a single sample.
    double standard_error() const {
        if (count < 2) return std::numeric_limits<double>::infinity();
        double sum_of_errors = 0;
        for (size_t c = 0; c < channels; ++c) {
            const double variance = (squares[c] - sum[c] * sum[c] / count) / (count - 1);
            sum_of_errors += std::sqrt(std::max(variance, 0.0) / count);
        }
        return sum_of_errors;
    }
};

struct Pixel {
    Rgb light{0.0f};
    float transmit = 0;
    Spread spread;
};

}  // namespace

void render_by_confidence(Sampler& sampler, const PixelBlock& block, const AntialiasOptions& options,
                          const SampleDistance& distance, std::span<Radiance> out) {
    PixelSamples samples(sampler, block, LensRays::as_camera_asks);
    std::vector<Pixel> pixels(samples.pixel_count());
    const double limit = options.threshold / std::sqrt(chi_square_quantile(1, options.confidence));
    const uint32_t most = 1u << (2 * options.depth);
    const auto take = [&](uint32_t pixel, const Radiance& light) {
        Pixel& p = pixels[pixel];
        p.light += light.rgb;
        p.transmit += light.transmit;
        p.spread.add(Channels{distance.encoded(light.rgb.x), distance.encoded(light.rgb.y),
                              distance.encoded(light.rgb.z), static_cast<double>(light.transmit)});
    };
    std::vector<PixelSamples::Wanted> wanted;
    for (uint32_t i = 0; i < pixels.size(); ++i) wanted.push_back({i, 0, 1});
    while (!wanted.empty()) {
        samples.trace(wanted, take);
        wanted.clear();
        for (uint32_t i = 0; i < pixels.size(); ++i) {
            const uint32_t count = pixels[i].spread.count;
            if (count >= most) continue;
            Spread around = pixels[i].spread;
            samples.each_neighbour(i, false, [&](size_t k) { around.add(pixels[k].spread); });
            // One by one as in the reference, as long as that matters.
            if (around.standard_error() > limit)
                wanted.push_back({i, count, std::min(1 + count / 8, most - count)});
        }
    }
    for (size_t i = 0; i < pixels.size(); ++i) {
        const float scale = 1.0f / static_cast<float>(pixels[i].spread.count);
        out[i] = {pixels[i].light * scale, pixels[i].transmit * scale};
    }
}

}  // namespace rb
