// Indirect light whose value is known, by every way of finding it.
#include "rendered.h"

#include <cmath>

#include <gtest/gtest.h>

namespace rb {
namespace {

class ClosedForm : public testing::TestWithParam<GiMode> {
protected:
    Film film_of(const std::string& radiosity, const std::string& scene, int size = 32,
                 const RenderOptions& options = {}) const {
        return rendered(GetParam(), radiosity, scene, size, options).film;
    }

    static double mean(const Film& film) {
        double sum = 0;
        for (const Radiance& pixel : film.pixels) sum += static_cast<double>(pixel.rgb.x);
        return sum / static_cast<double>(film.pixels.size());
    }
};

/// RMSE of a picture of the floor under a black ball of radius 1, 8 units wide, against the closed form.
double shadow_error(const Film& film) {
    double square = 0;
    for (int y = 0; y < film.height; ++y) {
        for (int x = 0; x < film.width; ++x) {
            const double r =
                std::hypot(x + 0.5 - film.width / 2, y + 0.5 - film.height / 2) * 8.0 / film.width;
            const double expected = 1.0 - std::pow(1.0 + r * r, -1.5);
            square += std::pow(static_cast<double>(film.at(x, y).rgb.x) - expected, 2);
        }
    }
    return std::sqrt(square / (film.width * film.height));
}

/// That floor under a white sky.
const std::string contact =
    "camera { orthographic location <0, 0, -20> direction z right 8*x up 8*y } background { rgb 1 }\n"
    "plane { z, 0 pigment { rgb 1 } }\n"
    "sphere { -z, 1 pigment { rgb 0 } finish { diffuse 0 } no_image }\n";

constexpr const char* fine = "count 400 error_bound 0.3 minimum_reuse 0.002 recursion_limit 1";

/// The unit square at the origin, seen from above.
const std::string above =
    "camera { orthographic location <0.5, 0.5, -3> direction z right x up y }\n"
    "plane { z, 0 pigment { rgb 1 } }\n";

TEST_P(ClosedForm, ParallelSquares) {
    const Film film = film_of(
        fine, above +
                  "polygon { 5, <0, 0>, <1, 0>, <1, 1>, <0, 1>, <0, 0> translate -z pigment { rgb 1 } "
                  "finish { diffuse 0 emission 1 } no_image }");
    EXPECT_NEAR(mean(film), 0.1998, 0.0015);
}

TEST_P(ClosedForm, PerpendicularSquares) {
    const Film film =
        film_of(fine, above +
                          "polygon { 5, <0, 0>, <1, 0>, <1, 1>, <0, 1>, <0, 0> rotate 90*y pigment { rgb 1 } "
                          "finish { diffuse 0 emission 1 } no_image }");
    EXPECT_NEAR(mean(film), 0.2000, 0.003);
}

/// A floor at the foot of a black wall with a bright band high above, without end: what is seen of the band
/// comes to nothing at the wall. Records from the open may not tell what it is there.
TEST_P(ClosedForm, FootOfAWall) {
    const Film film =
        film_of("count 400 error_bound 2 minimum_reuse 0.001 maximum_reuse 0.5 recursion_limit 1",
                "camera { orthographic location <1, 0, -20> direction z right 2*x up 2*y }\n"
                "plane { z, 0 pigment { rgb 1 } }\n"
                "#default { pigment { rgb 0 } finish { diffuse 0 } }\n"
                "box { <-1, -1e3, -1e3>, <0, 1e3, 0> }\n"
                "box { <-1, -1e3, -2>, <1e-4, 1e3, -1> pigment { rgb 1 } finish { emission 1 } no_image }");
    double square = 0;
    for (int y = 0; y < film.height; ++y) {
        for (int x = 0; x < film.width; ++x) {
            const double d = (x + 0.5) * 2.0 / film.width;
            const double expected = 0.5 * d * (1.0 / std::hypot(d, 1.0) - 1.0 / std::hypot(d, 2.0));
            square += std::pow(static_cast<double>(film.at(x, y).rgb.x) - expected, 2);
        }
    }
    EXPECT_LT(std::sqrt(square / (film.width * film.height)), 0.005);
}

/// Diffuse light in a closed sphere is the same everywhere: a geometric series of its bounces.
TEST_P(ClosedForm, Furnace) {
    for (const int bounces : {1, 2, 3}) {
        const Film film = film_of("count 20 recursion_limit " + std::to_string(bounces),
                                  "camera { location 0 direction z right x up y }\n"
                                  "sphere { 0, 10 pigment { rgb 0.5 } finish { emission 0.2 } }",
                                  8);
        const double expected = 0.2 * (1.0 - std::pow(0.5, bounces + 1));
        for (const Radiance& pixel : film.pixels) {
            EXPECT_NEAR(static_cast<double>(pixel.rgb.x), expected, 2e-4) << bounces << " bounces";
        }
    }
}

/// A black ball on a floor under a white sky: its shadow is darkest at the point of contact.
TEST_P(ClosedForm, ContactShadow) {
    const auto error_of = [&](const std::string& settings) {
        return shadow_error(film_of("recursion_limit 1 " + settings, contact));
    };
    EXPECT_LT(error_of(""), 0.02);
    EXPECT_LT(error_of("count 400 error_bound 0.3 minimum_reuse 0.002"), 0.005);
}

/// A box without windows under a bright sky, walls as thin as paper.
TEST_P(ClosedForm, NoLightComesThroughWalls) {
    const Film film = film_of("recursion_limit 2",
                              "camera { location <0, 0.5, -0.95> look_at <0, 0.3, 0> angle 90 }\n"
                              "background { rgb 10 } light_source { <20, 40, -30>, rgb 10 }\n"
                              "difference { box { <-1, 0, -1>, <1, 1, 1> }\n"
                              "  box { <-0.9999, 0.0001, -0.9999>, <0.9999, 0.9999, 0.9999> }\n"
                              "  pigment { rgb 0.9 } }\n"
                              "box { <-0.2, 0.0001, -0.2>, <0.2, 0.4, 0.2> rotate 30*y pigment { rgb 0.9 } }",
                              12);
    for (const Radiance& pixel : film.pixels) EXPECT_EQ(pixel.rgb.x, 0.0f);
}

/// Two halves of a room with a wall without thickness between them that stands on walls which both share: one
/// with a lamp, one without.
TEST_P(ClosedForm, NoLightComesUnderWalls) {
    const std::string room =
        "box { <-1, 0, -1>, <1, 1, 1> pigment { rgb 0.9 } }\n"
        "polygon { 5, <-2, -2>, <2, -2>, <2, 2>, <-2, 2>, <-2, -2> rotate 90*y translate 0.03*x\n"
        "  pigment { rgb 0.9 } }\n"
        "light_source { <-0.5, 0.7, 0>, rgb 1 }\n";
    const auto from = [&](const std::string& place) {
        return mean(film_of("count 12 recursion_limit 2", "camera { " + place + " angle 90 }\n" + room));
    };
    EXPECT_GT(from("location <-0.95, 0.5, 0> look_at <0, 0.3, 0>"), 0.4);
    EXPECT_LT(from("location <0.95, 0.5, 0> look_at <0, 0.3, 0>"), 0.001);
}

TEST_P(ClosedForm, ThreadsDoNotShow) {
    RenderOptions options;
    options.block_size = 8;
    options.threads = 1;
    const Film one = film_of("count 30", several, 32, options);
    options.threads = 3;
    const Film three = film_of("count 30", several, 32, options);
    for (size_t i = 0; i < one.pixels.size(); ++i) ASSERT_EQ(one.pixels[i].rgb, three.pixels[i].rgb) << i;
}

/// What interpolates between places, with a bound to choose.
class Interpolated : public ClosedForm {};

/// One number decides how good the picture gets.
TEST_P(Interpolated, ErrorAsAskedFor) {
    for (const double wanted : {0.02, 0.01, 0.005}) {
        RenderOptions options;
        options.gi_error = wanted;
        EXPECT_LT(shadow_error(film_of("recursion_limit 1", contact, 32, options)), wanted);
    }
}

/// A small bright square above a floor, that one ray in two hundred meets: without outlooks the error is 80
/// %.
TEST_P(Interpolated, SmallBrightPatch) {
    constexpr double half = 0.06;
    constexpr uint64_t pictures = 8;
    double square = 0;
    double whole = 0;
    RenderOptions options;
    for (options.seed = 0; options.seed < pictures; ++options.seed) {
        const Film film =
            film_of("count 120 error_bound 1 minimum_reuse 0.002 recursion_limit 1",
                    "camera { orthographic location <0, 0, -20> direction z right 2*x up 2*y }\n"
                    "plane { z, 0 pigment { rgb 1 } }\n"
                    "box { <-0.06, -0.06, -1.001>, <0.06, 0.06, -1> pigment { rgb 50 } finish { diffuse 0 "
                    "emission 1 } no_image }",
                    32, options);
        for (int y = 0; y < film.height; ++y) {
            for (int x = 0; x < film.width; ++x) {
                const double px = (x + 0.5) * 2.0 / film.width - 1.0;
                const double py = (y + 0.5) * 2.0 / film.height - 1.0;
                const double expected =
                    50.0 * 4.0 * half * half / (pi * std::pow(1.0 + px * px + py * py, 2));
                square += std::pow(static_cast<double>(film.at(x, y).rgb.x) - expected, 2);
                whole += expected * expected;
            }
        }
    }
    EXPECT_LT(std::sqrt(square / whole), 0.4);
}

/// Most of what gathers meet is not shaded.
TEST(Surfels, SaveShadowRays) {
    const auto report = rendered(GiMode::points, "count 100", several, 64).radiosity;
    ASSERT_TRUE(report.has_value());
    EXPECT_LT(4 * report->shadow_rays, report->rays);
    EXPECT_GT(report->surfels.at(0), 0u);
    EXPECT_GT(report->surfel_bytes, 0u);
}

/// With several samples a pixel, too, places with few records gather for themselves.
TEST(Interpolation, AlwaysSampleGathersMore) {
    RenderOptions options;
    options.antialias.method = 2;
    const auto gaps = [&](const std::string& word) {
        return rendered(GiMode::points, "count 30 always_sample " + word, several, 32, options)
            .radiosity->gaps[0];
    };
    EXPECT_GT(gaps("on"), 2 * gaps("off") + 100);
}

/// Samples that are a tenth of a pixel gather by fewer rays than whole pixels.
TEST(Interpolation, PartsOfPixelsGatherLess) {
    const auto at_depth = [](int depth) {
        RenderOptions options;
        options.antialias.method = 1;
        options.antialias.threshold = 0.0;
        options.antialias.depth = depth;
        return *rendered(GiMode::points, "count 100 always_sample on nearest_count 20", several, 32, options)
                    .radiosity;
    };
    const auto four = at_depth(2);
    const auto many = at_depth(4);
    constexpr double rays_of_a_pixel = 50.0;
    EXPECT_LT(static_cast<double>(many.rays - four.rays),
              0.5 * rays_of_a_pixel * static_cast<double>(many.gaps[0] - four.gaps[0]));
}

/// In a closed sphere each surfel sends out what the sphere does without further bounces.
TEST(Surfels, AreSeen) {
    RenderOptions options;
    options.view_surfels = true;
    const Film film = rendered(GiMode::points, "count 400 recursion_limit 1",
                               "camera { location 0 direction z right x up y }\n"
                               "sphere { 0, 10 pigment { rgb 0.5 } finish { emission 0.2 } }",
                               16, options)
                          .film;
    int known = 0;
    for (const Radiance& pixel : film.pixels) {
        if (pixel.rgb == Rgb(0.0f, 0.0f, 0.1f)) continue;
        ++known;
        EXPECT_NEAR(static_cast<double>(pixel.rgb.x), 0.1, 1e-6);
    }
    EXPECT_GT(known, 128);
}

std::string name_of(const testing::TestParamInfo<GiMode>& info) {
    return info.param == GiMode::points ? "points" : info.param == GiMode::cache ? "cache" : "brute";
}
INSTANTIATE_TEST_SUITE_P(Radiosity, ClosedForm, testing::Values(GiMode::points, GiMode::cache, GiMode::brute),
                         name_of);
INSTANTIATE_TEST_SUITE_P(Radiosity, Interpolated, testing::Values(GiMode::points, GiMode::cache), name_of);

}  // namespace
}  // namespace rb
