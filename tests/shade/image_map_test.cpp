// Pictures on surfaces: measured values (spec: textures, probes 7 to 11).
#include "pattern_text.h"
#include "patterns/material_map.h"
#include "patterns/normal_program.h"
#include "patterns/pigment_program.h"
#include "tests/geometry/statement.h"

#include <filesystem>
#include <fstream>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace rb {
namespace {

/// 3 x 2 pixels: red green blue / yellow cyan brown.
class Pictures : public testing::Test {
protected:
    void SetUp() override {
        std::filesystem::create_directories(folder_);
        std::ofstream(file_) << "P3\n3 2\n255\n255 0 0  0 255 0  0 0 255\n255 255 0  0 255 255  128 64 32\n";
    }
    void TearDown() override { std::filesystem::remove_all(folder_); }

    std::string picture(const std::string& options) const {
        return fmt::format("{{ ppm \"{}\" {} }}", file_.string(), options);
    }

    std::filesystem::path folder_ = std::filesystem::path(testing::TempDir()) / "pictures";
    std::filesystem::path file_ = folder_ / "t.ppm";
};

Color color_at(const PigmentPtr& pigment, const Vec3& p) {
    Color color;
    PigmentProgram(*pigment, {}).evaluate({{&p, 1}, nullptr, {}}, {&color, 1});
    return color;
}

PigmentPtr pigment_of(const std::string& text) {
    return object_from("plane { z, 0 pigment { " + text + " } }")->texture->layers->at(0).pigment;
}

constexpr std::array<Vec3, 4> flat{Vec3{0.1, 0.2, 0}, Vec3{0.5, 0.5, 0}, Vec3{0.75, 0.9, 0},
                                   Vec3{1.4, -0.3, 0}};
constexpr std::array<Vec3, 4> around{Vec3{0.5, 0.3, 0.4}, Vec3{-0.7, 0.6, 0.2}, Vec3{0.3, -0.8, -0.9},
                                     Vec3{1.5, 0.1, -0.3}};

struct Row {
    const char* options;
    std::array<Vec3, 4> places;
    double expected[4][3];
};
constexpr double brown[3] = {0.50196, 0.25098, 0.12549};
const Row rows[] = {
    {"", flat, {{1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {0, 1, 0}}},
    {"interpolate 2",
     flat,
     {{0.89035, 0.76518, 0.042588}, {0, 1, 0.5}, {0.11294, 0.30647, 0.62824}, {0.3, 0.73, 0.07}}},
    {"interpolate 3",
     flat,
     {{0.99397, 0.84745, -0.052564},
      {0, 1, 0.5},
      {0.00027354, 0.25332, 0.75232},
      {0.28802, 0.82287, -0.079595}}},
    {"interpolate 4",
     flat,
     {{0.9378, 0.87103, 0.037716},
      {0.04183, 0.85425, 0.51046},
      {0.083735, 0.27069, 0.71287},
      {0.19951, 0.85591, 0.080049}}},
    {"once", flat, {{1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}}},
    {"gamma 2.2", flat, {{1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {0, 1, 0}}},
    {"map_type 1", around, {{1, 0, 0}, {0, 1, 0}, {brown[0], brown[1], brown[2]}, {0, 0, 1}}},
    {"map_type 2",
     around,
     {{1, 1, 0}, {0, 1, 0}, {brown[0], brown[1], brown[2]}, {brown[0], brown[1], brown[2]}}},
    {"map_type 5", around, {{1, 0, 0}, {0, 1, 0}, {brown[0], brown[1], brown[2]}, {0, 0, 1}}},
};

TEST_F(Pictures, AreSampledAsMeasured) {
    for (const Row& row : rows) {
        const PigmentPtr pigment = pigment_of("image_map " + picture(row.options));
        for (size_t i = 0; i < 4; ++i) {
            const Color c = color_at(pigment, row.places[i]);
            EXPECT_NEAR(c.red, row.expected[i][0], 6e-6) << row.options << " point " << i;
            EXPECT_NEAR(c.green, row.expected[i][1], 6e-6) << row.options << " point " << i;
            EXPECT_NEAR(c.blue, row.expected[i][2], 6e-6) << row.options << " point " << i;
        }
    }
    EXPECT_EQ(color_at(pigment_of("image_map " + picture("once")), flat[3]).transmit, 1.0f);
    const PigmentPtr clear = pigment_of("image_map " + picture("filter all 0.3 transmit all 0.1"));
    EXPECT_EQ(color_at(clear, flat[0]).filter, 0.3f);
    EXPECT_EQ(color_at(clear, flat[0]).transmit, 0.1f);
}

TEST_F(Pictures, AsAPatternAreGrey) {
    const WrittenPattern written = pattern_of("image_pattern " + picture(""));
    std::array<double, 4> values{};
    PatternField(written.pattern, written.modifiers, {}).values({flat, nullptr, {}}, values);
    const double expected[] = {0.886, 0.589, 0.114, 0.589};
    for (size_t i = 0; i < 4; ++i) EXPECT_NEAR(values[i], expected[i], 1e-6);
}

TEST_F(Pictures, BumpNormalsAsMeasured) {
    const std::array<Vec3, 3> points{Vec3{0.5, 0, 1.5}, Vec3{-2.5, 0, 0.5}, Vec3{1.5, 0, -3.5}};
    struct BumpRow {
        const char* options;
        double expected[3][3];
    };
    const BumpRow bumps[] = {
        {"bump_size 2", {{-0.3087, 0.6498, -0.6946}, {0.1286, 0.7030, -0.6995}, {-0.3087, 0.6498, -0.6946}}},
        {"bump_size 2 interpolate 2",
         {{-0.2612, 0.8051, -0.5325}, {0.2400, 0.7987, -0.5517}, {-0.1400, 0.7325, -0.6662}}},
    };
    for (const BumpRow& row : bumps) {
        const Normal written = written_normal("bump_map " + picture(row.options) + " rotate x*90 scale 5");
        std::array<Vec3, 3> normals{Vec3{0, 1, 0}, Vec3{0, 1, 0}, Vec3{0, 1, 0}};
        NormalProgram(written, {}).perturb({points, nullptr, {}}, normals);
        for (size_t i = 0; i < 3; ++i) {
            for (int k = 0; k < 3; ++k)
                EXPECT_NEAR(normals[i][k], row.expected[i][k], 2e-4) << row.options << " point " << i;
        }
    }
}

TEST(ImageFunctions, AreStoredIn16BitsTopRowFirst) {
    const PigmentPtr ramp = pigment_of("image_map { function 10,10 { pattern { gradient y } } }");
    EXPECT_NEAR(color_at(ramp, {0.5, 0.05, 0}).red, 1.0, 1e-6);
    EXPECT_NEAR(color_at(ramp, {0.5, 0.15, 0}).red, 0.888884, 1e-6);
    EXPECT_NEAR(color_at(ramp, {0.5, 0.95, 0}).red, 0.0, 1e-6);
    const PigmentPtr colors = pigment_of(
        "image_map { function 10,10 { pigment { gradient x color_map { [0 rgb 0] [1 rgb <1,0.5,0.25>] } } } "
        "}");
    EXPECT_NEAR(color_at(colors, {0.35, 0.5, 0}).red, 0.333333, 1e-5);
    EXPECT_NEAR(color_at(colors, {0.35, 0.5, 0}).green, 0.166659, 1e-5);
}

Image image_of(ImageType type, int channels, std::vector<uint16_t> samples) {
    Image image;
    image.type = type;
    image.width = 1;
    image.height = 1;
    image.channels = channels;
    image.samples = std::move(samples);
    return image;
}

Color decoded(const Image& image, std::optional<GammaCurve> gamma = {}, bool guesses_srgb = true) {
    ImageSource source;
    source.image = std::make_shared<Image>(image);
    source.gamma = gamma;
    Texels::Decoding decoding;
    decoding.converts = true;
    decoding.guesses_srgb = guesses_srgb;
    return Texels(source, decoding).at(0, 0);
}

void expect_rgb(const Color& c, double red, double green, double blue) {
    EXPECT_NEAR(c.red, red, 6e-6);
    EXPECT_NEAR(c.green, green, 6e-6);
    EXPECT_NEAR(c.blue, blue, 6e-6);
}

TEST(Texels, FollowTheGammaOfTheirFile) {
    const std::vector<uint16_t> rgb{165, 77, 202};
    Image png = image_of(ImageType::png, 3, rgb);
    expect_rgb(decoded(png), 0.37626, 0.07421, 0.59062);
    expect_rgb(decoded(png, GammaCurve{SrgbCurve{}}), 0.37626, 0.07421, 0.59062);
    expect_rgb(decoded(png, GammaCurve{1.0}), 0.64706, 0.30196, 0.79216);
    expect_rgb(decoded(png, {}, false), 0.64706, 0.30196, 0.79216);
    png.curve = GammaCurve{1.0};
    expect_rgb(decoded(png), 0.64706, 0.30196, 0.79216);
    expect_rgb(decoded(image_of(ImageType::ppm, 3, rgb)), 0.64706, 0.30196, 0.79216);
    expect_rgb(decoded(image_of(ImageType::tga, 3, rgb)), 0.37626, 0.07421, 0.59062);
    const Image grey = image_of(ImageType::png, 1, {165});
    EXPECT_NEAR(decoded(grey).red, 0.37255, 6e-6);
    EXPECT_NEAR(decoded(grey, GammaCurve{1.0}).red, 0.64706, 6e-6);
    EXPECT_NEAR(decoded(image_of(ImageType::png, 1, {24})).red, 0.00784, 6e-6);
    EXPECT_NEAR(decoded(image_of(ImageType::png, 1, {24}), GammaCurve{1.0}).red, 0.09020, 6e-6);
}

TEST(Texels, SamplesBeyondWhiteAreWhite) {
    Image image = image_of(ImageType::ppm, 3, {15, 16, 65535});
    image.white = 15;
    expect_rgb(decoded(image), 1, 1, 1);
}

TEST(Texels, AlphaLetsLightThrough) {
    const Image image = image_of(ImageType::png, 4, {255, 255, 255, 20});
    EXPECT_NEAR(decoded(image).transmit, 0.92157, 6e-6);
    ImageSource source;
    source.image = std::make_shared<Image>(image);
    Texels texels(source, {});
    texels.filter_all(0.3f);
    texels.transmit_all(0.1f);
    EXPECT_NEAR(texels.at(0, 0).transmit, 1.02157, 6e-6);
    EXPECT_EQ(texels.at(0, 0).filter, 0.3f);
}

TEST(ImageField, PixelsBeyondTheEdgeAreThoseOfTheOtherSide) {
    Image image = image_of(ImageType::png, 1, {3});
    image.palette.resize(4, {0, 0, 0, 255});
    ImageSource source;
    source.image = std::make_shared<Image>(image);
    for (const bool once : {false, true}) {
        ImageOptions options;
        options.once = once;
        const ImageField field(Texels(source, {}), options);
        EXPECT_EQ(field.index({1.5, 0.0}), 3u);
        EXPECT_EQ(field.color({1.5, 2.5}), (Color{0, 0, 0, 0, 0}));
    }
}

TEST(MaterialMap, AnIndexEqualToTheCountIsNotWrapped) {
    Image image = image_of(ImageType::png, 1, {});
    image.width = 5;
    image.palette.resize(5, {0, 0, 0, 255});
    image.samples = {0, 1, 2, 3, 4};
    ImageSource source;
    source.image = std::make_shared<Image>(image);
    const PatternPtr pattern = material_map_pattern(ImageField(Texels(source, {}), {}), 3);
    std::array<Vec3, 5> points;
    for (size_t i = 0; i < 5; ++i) points[i] = {(static_cast<double>(i) + 0.5) / 5.0, 0.5, 0.0};
    std::array<double, 5> values{};
    PatternModifiers modifiers;
    modifiers.frequency = 0;
    PatternField(pattern, modifiers, {}).values({points, nullptr, {}}, values);
    EXPECT_EQ(values, (std::array<double, 5>{0, 1, 2, 2, 1}));
}

}  // namespace
}  // namespace rb
