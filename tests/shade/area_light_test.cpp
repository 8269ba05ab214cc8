// Area lights with jitter: the pattern against the exact integral of the grid's density, and against its slow
// twins.
#include "scene_maker.h"
#include "shade/area_sampler.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace rb {
namespace {

/// Weights of the grid's places along one axis (spec: shading 7, measured).
const std::vector<std::vector<double>> axis_weights{
    {1},
    {0.5, 0.5},
    {0.25, 0.5, 0.25},
    {0.25, 0.25, 0.25, 0.25},
    {0.125, 0.25, 0.25, 0.25, 0.125},
    {0.125, 0.25, 0.125, 0.125, 0.25, 0.125},
};

TEST(AxisDensity, HasTheWeightsOfTheReferencesRecursion) {
    for (const auto& weights : axis_weights) {
        const int size = static_cast<int>(weights.size());
        const AxisDensity density(size);
        for (int i = 0; i < size; ++i)
            EXPECT_DOUBLE_EQ(density.weight(i), weights[static_cast<size_t>(i)]) << size;
    }
    const AxisDensity nine(9);
    for (int i = 0; i < 9; ++i) EXPECT_DOUBLE_EQ(nine.weight(i), i % 8 == 0 ? 1.0 / 16 : 1.0 / 8);
}

TEST(AxisDensity, PlacesAreItsInverse) {
    const auto& weights = axis_weights.back();
    const AxisDensity density(static_cast<int>(weights.size()));
    double below = 0;
    for (size_t i = 0; i < weights.size(); ++i) {
        const auto place = static_cast<double>(i);
        EXPECT_NEAR(density.place(below), place - 0.5, 1e-12);
        EXPECT_NEAR(density.place(below + 0.5 * weights[i]), place, 1e-12);
        below += weights[i];
    }
}

/// Every box of area 1 / 2^k whose sides are powers of two holds one of the first 2^k points.
TEST(ScrambledSobol, SpreadsEvenly) {
    constexpr int k = 8;
    for (uint64_t seed : {0u, 1u, 12345u}) {
        for (int across = 0; across <= k; ++across) {
            std::vector<int> counts(1u << k);
            for (uint32_t i = 0; i < 1u << k; ++i) {
                const Vec2 p = scrambled_sobol(i, mixed(seed, 7));
                const auto x = static_cast<size_t>(p.x * (1 << across));
                const auto y = static_cast<size_t>(p.y * (1 << (k - across)));
                ++counts[(x << (k - across)) + y];
            }
            EXPECT_TRUE(std::ranges::all_of(counts, [](int n) { return n == 1; })) << across;
        }
    }
}

TEST(ScrambledSobol, EachPointIsUniformOverSeeds) {
    constexpr int seeds = 20000;
    for (const uint32_t index : {0u, 1u, 5u, 100u}) {
        Vec2 sum{0.0};
        double product = 0;
        for (uint64_t seed = 0; seed < seeds; ++seed) {
            const Vec2 p = scrambled_sobol(index, mixed(seed, 0)) - 0.5;
            sum += p;
            product += p.x * p.y;
        }
        // Standard deviations of the means: sqrt(1/12), 1/12.
        EXPECT_LT(std::abs(sum.x), 4 * std::sqrt(seeds / 12.0)) << index;
        EXPECT_LT(std::abs(sum.y), 4 * std::sqrt(seeds / 12.0)) << index;
        EXPECT_LT(std::abs(product), 4 * std::sqrt(seeds) / 12.0) << index;
    }
}

/// Without the other order, two patterns of the same index rise and fall together.
TEST(ScrambledSobol, ShuffledIndicesMakePatternsIndependent) {
    constexpr uint32_t count = 1024;
    for (uint32_t seed = 1; seed <= 20; ++seed) {
        std::vector<int> indices(count);
        Vec2 product{0.0};
        for (uint32_t i = 0; i < count; ++i) {
            const uint32_t other = shuffled_index(i, seed);
            ++indices[other % count];
            EXPECT_EQ(other / count, shuffled_index(0, seed) / count);
            const Vec2 p = scrambled_sobol(i, mixed(seed, 1)) - 0.5;
            const Vec2 q = scrambled_sobol(other, mixed(seed, 2)) - 0.5;
            product += p * q;
        }
        EXPECT_TRUE(std::ranges::all_of(indices, [](int n) { return n == 1; })) << seed;
        EXPECT_LT(std::abs(product.x), 5 * std::sqrt(count) / 12.0) << seed;
        EXPECT_LT(std::abs(product.y), 5 * std::sqrt(count) / 12.0) << seed;
    }
}

/// A white plane under a light of 7 x 7 units, 8 units above; a blocker half way up hides it where x < 0.
SceneMaker half_shaded(const std::function<void(AreaGrid&)>& change) {
    SceneMaker s;
    s.add("plane{<0,0,1>,0}", {plain(grey_color(1), diffuse_only())}).hollow = true;
    s.add("box{<-100,-100,-4.000001>,<0,100,-4>}", {plain(grey_color(0), Finish{})}).no_image = true;
    s.light({0, 0, -8}, Rgb(1.0f), [&](Light& l) {
        l.is_area = true;
        l.area.axis1 = {7, 0, 0};
        l.area.axis2 = {0, 7, 0};
        l.area.jitter = true;
        change(l.area);
    });
    return s;
}

/// What several random patterns show at x of that plane, relative to no shadow.
std::vector<double> visibilities(const SceneMaker& s, double x, size_t count) {
    std::vector<CameraRay> rays(count);
    for (size_t i = 0; i < count; ++i) rays[i] = {{{x, 0.0, -3.0}, {0, 0, 1}}, true, mixed(i, 1)};
    const double cosine = 8.0 / std::sqrt(64.0 + x * x);
    std::vector<double> out;
    for (const Radiance& r : s.look_all(rays)) out.push_back(static_cast<double>(r.rgb.x) / cosine);
    return out;
}

/// The light's share beyond `x`, by the density of the grid.
double share_beyond(double x, const std::vector<double>& weights) {
    const auto size = static_cast<double>(weights.size());
    const double place = (x / 7.0 + 0.5) * (size - 1.0);
    double share = 0;
    for (size_t i = 0; i < weights.size(); ++i) {
        share += weights[i] * std::clamp(static_cast<double>(i) + 0.5 - place, 0.0, 1.0);
    }
    return share;
}

struct Statistics {
    double mean = 0;
    double deviation = 0;
};
Statistics statistics(const std::vector<double>& values) {
    const auto n = static_cast<double>(values.size());
    Statistics s;
    for (const double v : values) s.mean += v / n;
    for (const double v : values) s.deviation += (v - s.mean) * (v - s.mean) / (n - 1);
    s.deviation = std::sqrt(s.deviation);
    return s;
}

TEST(AreaPattern, HasTheMeanOfTheGridsDensity) {
    constexpr size_t count = 4000;
    for (size_t size = 2; size <= axis_weights.size(); ++size) {
        const SceneMaker s = half_shaded([&](AreaGrid& g) { g.size1 = g.size2 = static_cast<int>(size); });
        for (const double x : {-3.1, -1.3, 0.4, 1.0, 2.7}) {
            const Statistics seen = statistics(visibilities(s, x, count));
            const double exact = share_beyond(-x, axis_weights[size - 1]);
            // Rounding of colours in single precision.
            const double error = seen.deviation / std::sqrt(count) + 1e-6;
            EXPECT_LT(std::abs(seen.mean - exact), 4 * error) << size << " at " << x;
        }
    }
}

/// Where the first samples agree by chance only: at the edges of the penumbra.
TEST(AreaPattern, AdaptiveLosesNoEdges) {
    constexpr size_t count = 4000;
    constexpr int size = 9;
    const SceneMaker s = half_shaded([](AreaGrid& g) { g.size1 = g.size2 = size, g.adaptive = 0; });
    std::vector<double> weights;
    for (int i = 0; i < size; ++i) weights.push_back(AxisDensity(size).weight(i));
    for (const double x : {-3.6, -3.2, 3.2, 3.6}) {
        const Statistics seen = statistics(visibilities(s, x, count));
        const double error = seen.deviation / std::sqrt(count) + 1e-6;
        EXPECT_LT(std::abs(seen.mean - share_beyond(-x, weights)), 4 * error) << x;
    }
}

TEST(AreaPattern, IsSteadierThanChance) {
    const SceneMaker s = half_shaded([](AreaGrid& g) { g.size1 = g.size2 = 4; });
    const Statistics seen = statistics(visibilities(s, 1.0, 4000));
    const double at_random = std::sqrt(seen.mean * (1.0 - seen.mean) / 16);
    EXPECT_LT(seen.deviation, 0.5 * at_random);
}

TEST(AreaLightMode, GridIsTheGridWithoutJitter) {
    SceneMaker jittered = half_shaded([](AreaGrid& g) { g.size1 = g.size2 = 4; });
    const SceneMaker plain_grid = half_shaded([](AreaGrid& g) { g.size1 = g.size2 = 4, g.jitter = false; });
    jittered.options.area_lights = AreaLightMode::grid;
    EXPECT_EQ(visibilities(jittered, 1.0, 10), visibilities(plain_grid, 1.0, 10));
    jittered.options.area_lights = AreaLightMode::smooth;
    EXPECT_NE(visibilities(jittered, 1.0, 10), visibilities(plain_grid, 1.0, 10));
}

TEST(AreaLightMode, TrueLightsAreEvenOverTheirAxes) {
    SceneMaker square = half_shaded([](AreaGrid& g) { g.size1 = g.size2 = 4; });
    square.options.area_lights = AreaLightMode::true_area;
    EXPECT_NEAR(statistics(visibilities(square, 1.0, 4000)).mean, 0.5 + 1.0 / 7, 2e-3);
    SceneMaker round = half_shaded([](AreaGrid& g) { g.size1 = g.size2 = 4, g.circular = true; });
    round.options.area_lights = AreaLightMode::true_area;
    // The part of a disc of radius 3.5 beyond a chord at -1.
    const double h = 1.0 / 3.5;
    const double beyond = 0.5 + (std::asin(h) + h * std::sqrt(1 - h * h)) / pi;
    EXPECT_NEAR(statistics(visibilities(round, 1.0, 4000)).mean, beyond, 2e-3);
}

/// Deep in a body's shadow a few rays prove that no light comes; the picture is that of all rays.
TEST(AreaPattern, ProofsOfShadowChangeNothing) {
    for (const std::string_view body : {"sphere{<0,0,-3>,2}", "box{<-2,-2,-4>,<2,2,-3>}",
                                        "cylinder{<-3,0,-3>,<3,0,-3>,1.5}", "cone{<0,0,-4>,1,<0,0,-2>,2}"}) {
        SceneMaker s;
        s.add("plane{<0,0,1>,0}", {plain(grey_color(1), diffuse_only())}).hollow = true;
        s.add(body, {plain(grey_color(0), Finish{})}).no_image = true;
        s.light({0, 0, -8}, Rgb(1.0f), [&](Light& l) {
            l.is_area = true;
            l.area.axis1 = {2, 0, 0};
            l.area.axis2 = {0, 2, 0};
            l.area.size1 = l.area.size2 = 5;
            l.area.jitter = true;
        });
        std::vector<CameraRay> rays;
        for (int i = 0; i < 900; ++i) {
            rays.push_back({{{0.3 * (i % 30) - 4.5, 0.3 * (i / 30) - 4.5, -0.5}, {0, 0, 1}},
                            true,
                            mixed(0, static_cast<uint64_t>(i))});
        }
        const std::vector<Radiance> quick = s.look_all(rays);
        s.options.skip_unneeded = false;
        const std::vector<Radiance> slow = s.look_all(rays);
        std::vector<CameraRay> dark;
        for (size_t i = 0; i < rays.size(); ++i) {
            EXPECT_EQ(quick[i].rgb, slow[i].rgb) << body << ' ' << i;
            if (slow[i].rgb.x == 0.0f) dark.push_back(rays[i]);
        }
        EXPECT_GT(dark.size(), 30u) << body;
        s.options.skip_unneeded = true;
        RayCounters counters;
        s.look_all(dark, &counters);
        EXPECT_LT(counters.shadow, 16 * dark.size()) << body;
    }
}

}  // namespace
}  // namespace rb
