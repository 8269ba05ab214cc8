// Indirect light of places that a moving camera keeps in sight.
#include "rendered.h"

#include <cmath>

#include <fmt/format.h>

namespace rb {
namespace {

constexpr int width = 48;
constexpr int frames = 10;

/// A corner with a ball and a block, seen by parallel rays: each frame from one pixel farther to the right,
/// so that a pixel sees what its right neighbour saw.
Film frame(GiMode mode, int number) {
    const std::string scene = fmt::format(
        "camera {{ orthographic location <{}, 2.2, -6> direction z right 4*x up 4*y }}\n"
        "background {{ rgb <0.5, 0.6, 0.8> }} light_source {{ <6, 9, -8>, rgb 0.8 }}\n"
        "union {{ plane {{ y, 0 }} plane {{ -z, -2 }} pigment {{ rgb 0.7 }} rotate -15*x }}\n"
        "sphere {{ <-0.5, 2, 0>, 0.7 pigment {{ rgb <0.9, 0.4, 0.2> }} }}\n"
        "box {{ <0.5, 0.5, 0>, <1.2, 2.5, 1> rotate 10*z pigment {{ rgb <0.3, 0.8, 0.3> }} }}\n",
        4.0 * number / width);
    return rendered(mode, "count 100 error_bound 0.5 minimum_reuse 0.004", scene, width).film;
}

double grey_at(const Film& film, int x, int y) { return static_cast<double>(grey(film.at(x, y).rgb)); }

class Animation : public testing::TestWithParam<GiMode> {};

TEST_P(Animation, DoesNotFlicker) {
    double change = 0;
    double light = 0;
    Film before = frame(GetParam(), 0);
    for (int number = 1; number < frames; ++number) {
        Film now = frame(GetParam(), number);
        for (int y = 0; y < width; ++y) {
            for (int x = 0; x + 1 < width; ++x) {
                change += std::abs(grey_at(now, x, y) - grey_at(before, x + 1, y));
                light += grey_at(now, x, y);
            }
        }
        before = std::move(now);
    }
    EXPECT_LT(change / light, 0.005);
}

INSTANTIATE_TEST_SUITE_P(Radiosity, Animation, testing::Values(GiMode::points, GiMode::cache),
                         [](const auto& mode) { return mode.param == GiMode::points ? "points" : "cache"; });

}  // namespace
}  // namespace rb
