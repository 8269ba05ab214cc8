// Methods that sample until the error is small: measured against converged pictures.
#include "compile/world.h"
#include "language/load.h"
#include "render/render.h"

#include <cmath>

#include <gtest/gtest.h>

namespace rb {
namespace {

constexpr int width = 48;
constexpr int height = 36;

/// Edges of every contrast, thin bars, fine checks, a mirror and a soft shadow.
constexpr const char* scene_text = R"(
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 2, -6> look_at <0, 0.6, 0> right x * 4/3 angle 50 }
light_source { <3, 6, -4> rgb 0.9 area_light 1.5*x, 1.5*z, 4, 4 jitter }
background { rgb <0.3, 0.5, 0.8> }
plane { y, 0 pigment { checker rgb 0.9 rgb 0.1 scale 0.4 } finish { ambient 0.1 diffuse 0.8 } }
sphere { <-0.8, 0.8, 0>, 0.8 pigment { rgb <0.8, 0.3, 0.2> } finish { reflection 0.3 phong 1 } }
#for (i, 0, 8) cylinder { <0.4 + 0.2*i, 0, 0>, <0.5 + 0.22*i, 2, 0>, 0.02 pigment { rgb 0.95 } } #end
)";

class AdaptiveSampling : public testing::Test {
protected:
    AdaptiveSampling() {
        world_ = world_of(scene_text);
        options_.width = width;
        options_.height = height;
        options_.region = {0, 0, width, height};
    }

    static World world_of(const std::string& text) {
        LoadOptions loading;
        loading.input_file = "scene";
        loading.input_text = text;
        loading.image_width = width;
        loading.image_height = height;
        SourceMap sources;
        Diagnostics diagnostics;
        Scene scene;
        EXPECT_TRUE(load_scene(loading, sources, diagnostics, scene));
        CompileOptions compiling;
        compiling.image_width = width;
        compiling.image_height = height;
        return compile(scene, compiling, diagnostics);
    }

    RenderResult picture() const {
        const std::atomic<bool> stop{false};
        return render(world_, options_, stop, nullptr);
    }
    RenderResult to_error(double error, uint64_t seed, uint32_t most = 4096) {
        options_.antialias.method = method_by_error;
        options_.antialias.error = error;
        options_.antialias.max_samples = most;
        options_.seed = seed;
        return picture();
    }
    RenderResult by_confidence(double threshold, int depth, uint64_t seed) {
        options_.antialias.method = 3;
        options_.antialias.threshold = threshold;
        options_.antialias.depth = depth;
        options_.seed = seed;
        return picture();
    }

    World world_;
    RenderOptions options_;
};

/// Differences as pictures show them: of channels of clipped, gamma-encoded values.
std::vector<double> differences(const Film& a, const Film& b) {
    const SampleDistance distance(GammaCurve{1.0}, 2.5);
    std::vector<double> out;
    for (size_t i = 0; i < a.pixels.size(); ++i) {
        for (int c = 0; c < 3; ++c) {
            const auto shown = [&](const Film& film) {
                return distance.encoded(std::clamp(film.pixels[i].rgb[c], 0.0f, 1.0f));
            };
            out.push_back(shown(a) - shown(b));
        }
    }
    return out;
}

double rmse(const Film& a, const Film& b) {
    double sum = 0;
    const std::vector<double> all = differences(a, b);
    for (const double d : all) sum += d * d;
    return std::sqrt(sum / static_cast<double>(all.size()));
}

TEST_F(AdaptiveSampling, ErrorIsBelowTheOneAskedFor) {
    const RenderResult converged = to_error(0.0, 1000);
    double before = 1;
    for (const double error : {0.02, 0.01, 0.005}) {
        const RenderResult seen = to_error(error, 1);
        const double measured = rmse(seen.film, converged.film);
        EXPECT_LT(measured, error);
        EXPECT_LT(measured, before);
        before = measured;
        // Samples go where they are needed.
        EXPECT_LT(seen.counters.camera, converged.counters.camera / 8);
    }
}

TEST_F(AdaptiveSampling, StoppingIsHardlyBiased) {
    const RenderResult converged = to_error(0.0, 1000);
    std::vector<double> mean(differences(converged.film, converged.film).size());
    constexpr int pictures = 16;
    for (int k = 0; k < pictures; ++k) {
        const std::vector<double> d =
            differences(to_error(0.02, static_cast<uint64_t>(k)).film, converged.film);
        for (size_t i = 0; i < d.size(); ++i) mean[i] += d[i] / pictures;
    }
    double sum = 0;
    for (const double m : mean) sum += m;
    // Over the whole picture; a quarter of the last bit of 8.
    EXPECT_LT(std::abs(sum / static_cast<double>(mean.size())), 0.25 / 255);
}

TEST_F(AdaptiveSampling, MaxSamplesIsACeiling) {
    const RenderResult seen = to_error(0.0, 1, 16);
    // Only where all samples agree there are fewer. One more at each corner.
    EXPECT_LE(seen.counters.camera, 17u * width * height + 2u * (width + height));
    EXPECT_GT(seen.counters.camera, 14u * width * height);
}

TEST_F(AdaptiveSampling, FocalBlurIsPartOfThePixel) {
    const std::string scene = scene_text;
    const std::string blurred = std::string(scene).insert(
        scene.find("angle 50"), "aperture 0.4 focal_point <0, 0.8, 0> variance 0 blur_samples 1000 ");
    world_ = world_of(blurred);
    const RenderResult converged = to_error(0.0, 1000);
    const RenderResult seen = to_error(0.02, 1);
    EXPECT_LT(rmse(seen.film, converged.film), 0.02);
    EXPECT_LT(seen.counters.camera, converged.counters.camera / 20);
    EXPECT_EQ(to_error(0.0, 1, 8).counters.camera, 8u * width * height);
    // The camera's own samples fall on 256 places of a pixel, which lie 1/32 to the side, as if at random.
    options_.antialias.method = 0;
    const RenderResult by_camera = picture();
    EXPECT_EQ(by_camera.counters.camera, 1000u * width * height);
    EXPECT_LT(rmse(by_camera.film, converged.film), 0.035);
}

TEST_F(AdaptiveSampling, ConfidenceMethodComesCloserWithItsThreshold) {
    const RenderResult converged = to_error(0.0, 1000);
    const RenderResult rough = by_confidence(0.3, 3, 1);
    const RenderResult fine = by_confidence(0.05, 4, 1);
    EXPECT_LT(rmse(rough.film, converged.film), 0.1);
    EXPECT_LT(rmse(fine.film, converged.film), 0.5 * rmse(rough.film, converged.film));
    EXPECT_LE(rough.counters.camera, 64u * width * height);
}

TEST_F(AdaptiveSampling, SeedsAndThreads) {
    const auto same = [](const RenderResult& a, const RenderResult& b) {
        return rmse(a.film, b.film) == 0.0;
    };
    for (const int method : {3, method_by_error}) {
        const auto with = [&](uint64_t seed) {
            return method == 3 ? by_confidence(0.1, 3, seed) : to_error(0.02, seed);
        };
        options_.threads = 1;
        const RenderResult one = with(1);
        options_.threads = 3;
        EXPECT_TRUE(same(with(1), one)) << method;
        EXPECT_FALSE(same(with(2), one)) << method;
    }
    // Without antialiasing the seed is in the soft shadow.
    options_.antialias.method = 0;
    options_.seed = 0;
    const RenderResult first = picture();
    options_.seed = 7;
    const RenderResult second = picture();
    EXPECT_FALSE(same(first, second));
    EXPECT_LT(rmse(first.film, second.film), 0.02);
}

}  // namespace
}  // namespace rb
