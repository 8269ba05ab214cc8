#include "image/dither.h"

#include "image/codec.h"

#include <gtest/gtest.h>

namespace rb {
namespace {

struct MeasuredDither {
    std::string_view name;
    std::vector<uint8_t> codes;
};

class Dithers : public testing::TestWithParam<MeasuredDither> {};

// Eight boxes by four of these greys, written by povray with +TH and File_Gamma=1.0.
TEST_P(Dithers, MeasuredPixels) {
    Pixels pixels(8, 4, 3);
    const std::vector<float> values{
        0.5112f, -0.0018f, -0.0039f, -0.0001f, 0.9966f, 0.0046f, 0.9988f, 0.1078f, 0.0019f, 1.0005f, 0.5012f,
        0.9853f, 0.9988f,  0.9958f,  0.5066f,  0.5074f, 0.5037f, 0.1585f, 0.0002f, 0.5181f, 0.5112f, -0.0002f,
        1.0026f, 0.0029f,  0.9628f,  0.0036f,  0.9965f, 1.0003f, 0.9987f, 0.997f,  0.0223f, 0.9979f};
    for (size_t i = 0; i < pixels.values.size(); ++i) pixels.values[i] = values[i / 3];
    OutputFormat format;
    format.dither.method = *dither_method(GetParam().name);
    const Samples samples = samples_of(rows_of(pixels), format);
    // What enters at the left edge is not known (docs/differences.md).
    const bool skips_edge =
        format.dither.method == DitherMethod::plane || format.dither.method == DitherMethod::floyd_steinberg;
    for (size_t i = 0; i < samples.bytes.size(); ++i) {
        if (skips_edge && i / 3 % 8 == 0) continue;
        EXPECT_EQ(int{samples.bytes[i]}, int{GetParam().codes[i / 3]}) << "value " << i / 3;
    }
}

INSTANTIATE_TEST_SUITE_P(
    All, Dithers,
    testing::Values(
        MeasuredDither{"B2", {130, 0,  0, 0,   254, 2, 254, 28, 1,   255, 128, 251, 255, 254, 129, 129,
                              128, 41, 0, 133, 130, 0, 255, 1,  246, 1,   254, 255, 255, 254, 6,   254}},
        MeasuredDither{"B3", {130, 0,  0, 0,   254, 1, 255, 28, 1,   255, 128, 252, 254, 254, 129, 129,
                              128, 41, 0, 132, 131, 0, 255, 1,  245, 1,   254, 255, 255, 254, 6,   255}},
        MeasuredDither{"B4", {130, 0,  0, 0,   254, 1, 254, 28, 1,   255, 128, 251, 255, 254, 129, 129,
                              128, 41, 0, 132, 130, 0, 255, 1,  246, 1,   254, 255, 255, 254, 6,   254}},
        MeasuredDither{"d1", {130, 0,  0, 0,   254, 1, 255, 27, 1,   255, 128, 251, 255, 254, 129, 129,
                              129, 40, 0, 132, 131, 0, 255, 1,  245, 1,   254, 255, 255, 254, 6,   254}},
        MeasuredDither{"D2", {130, 0,  0, 0,   254, 1, 255, 27, 0,   255, 128, 251, 255, 254, 129, 130,
                              129, 40, 0, 132, 130, 0, 255, 1,  246, 1,   254, 255, 255, 254, 6,   254}},
        MeasuredDither{"FS", {130, 0,  0, 0,   254, 1, 255, 27, 0,   255, 128, 251, 255, 254, 129, 130,
                              129, 40, 0, 132, 130, 0, 255, 1,  246, 1,   254, 255, 255, 254, 6,   254}}),
    [](const auto& i) { return std::string(i.param.name); });

TEST(Dither, UnknownMethods) {
    EXPECT_FALSE(dither_method("B5"));
    EXPECT_FALSE(dither_method(""));
}

// Whatever comes in, what goes out are levels.
TEST(Dither, KeepsToTheLevels) {
    for (const std::string_view name : {"B3", "D1", "FS"}) {
        Dither dither({*dither_method(name), {}}, 4, 1);
        for (int y = 0; y < 3; ++y) {
            std::array<float, 4> row{std::numeric_limits<float>::quiet_NaN(), -1e30f, 1e30f, 300.0f};
            dither.round(row, 255.0f);
            EXPECT_EQ(row, (std::array<float, 4>{0, 0, 255, 255})) << name;
        }
    }
}

}  // namespace
}  // namespace rb
