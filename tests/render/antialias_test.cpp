#include "render/antialias.h"

#include <random>

#include <gtest/gtest.h>

namespace rb {
namespace {

// The table is the power function's fast twin: it must never decide otherwise.
TEST(SampleDistance, TheTableDecidesAsThePowerFunctionDoes) {
    std::mt19937 random(3);
    std::uniform_real_distribution<float> exponent(-24.0f, 12.0f);
    std::uniform_real_distribution<float> near(0.9f, 1.1f);
    const auto channel = [&] {
        return random() % 16 == 0 ? 0.0f : std::exp2(exponent(random)) * (random() % 32 ? 1.0f : -1.0f);
    };
    const std::array<std::optional<GammaCurve>, 4> gammas{std::nullopt, GammaCurve{1.0}, GammaCurve{2.2},
                                                          GammaCurve{SrgbCurve{}}};
    for (const auto& gamma : gammas) {
        const SampleDistance distance(gamma, 2.5);
        for (int i = 0; i < 100000; ++i) {
            const Radiance a{{channel(), channel(), channel()}, 0.0f};
            const Radiance b{{a.rgb.x * near(random), channel(), a.rgb.z * near(random)},
                             random() % 4 ? 0.0f : 0.3f};
            const double exact = distance(a, b);
            for (const double threshold : {0.0, 0.003, 0.1, 0.3, 1.0, exact, exact * (1 + 1e-6)}) {
                ASSERT_EQ(distance.at_least(distance.comparable(a), distance.comparable(b), threshold),
                          exact >= threshold);
            }
        }
    }
}

}  // namespace
}  // namespace rb
