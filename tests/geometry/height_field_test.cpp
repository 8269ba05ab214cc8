// Height fields: values measured with the reference program, and heights of picture files.
#include "tests/geometry/probe.h"

#include <filesystem>
#include <fstream>

namespace rb {
namespace {

TEST(Probes, P63HeightFieldOfAFunction) {
    Probe o("height_field{function 3,2{x*.5+y*.25}}");
    const Vec3 n{-.4364358, .8728716, .2182179};
    o.hits({.500001, 9, .000001}, -y, {.500001, .499985, .000001}, n);
    o.hits({.500001, 9, .999999}, -y, {.500001, .2499855, .999999}, n);
}

TEST(Probes, P64HeightFieldWrapsAround) {
    Probe o("height_field{function 3,2{x*2-.5}}");
    o.hits({.000001, 9, .5}, -y, {.000001, .5000153, .5}, {.000061, 1, 0});
    o.hits({.999999, 9, .5}, -y, {.999999, .4999695, .5}, {.0000305, 1, 0});
}

TEST(Probes, P65HeightFieldSmooth) {
    Probe o("height_field{function 3,3{.25+.5*x*y} smooth}");
    o.hits({.3, 9, .6}, -y, {.3, .3249847, .6}, {-.2583385, .9464252, .193754});
    o.hits({.8, 9, .1}, -y, {.8, .6249847, .1}, {-.5126391, .7321448, .4485143});
}

TEST(HeightField, IsSolidDownwardsOnly) {
    Probe o("height_field{function 3,3{.5} water_level .2}");
    EXPECT_TRUE(o.inside({.5, .4, .5}));
    EXPECT_TRUE(o.inside({.5, -1000, .5}));
    EXPECT_FALSE(o.inside({.5, .6, .5}));
    EXPECT_FALSE(o.inside({1.5, .1, .5}));
    // No walls, no floor.
    o.misses({-5, .2, .5}, x);
    o.hits({.5, -5, .5}, y, {.5, .4999847, .5}, y);
}

TEST(HeightField, WaterCutsAHole) {
    Probe o("height_field{function 2,2{x} water_level .5}");
    o.hits({.6, 9, .5}, -y, {.6, .5999908, .5}, glm::normalize(Vec3{-65535.0 / 65536, 1, 0}));
    o.misses({.4, 9, .5}, -y);
    Probe drowned("height_field{function 2,2{.2} water_level .5}");
    drowned.misses({.4, 9, .5}, -y);
}

TEST(HeightField, Refusals) {
    EXPECT_THROW(object_from("height_field{function 1,5{x}}"), SceneError);
    EXPECT_THROW(object_from("height_field{function 1e9,1e9{x}}"), SceneError);
    EXPECT_THROW(object_from("height_field{function 0/0,5{x}}"), SceneError);
    EXPECT_THROW(object_from("height_field{png \"no such file.png\"}"), SceneError);
    EXPECT_THROW(object_from("height_field{\"file.xyz\"}"), SceneError);
    EXPECT_THROW(object_from("height_field{iff \"file.iff\"}"), SceneError);
    EXPECT_THROW(object_from("height_field{smooth function 2,2{x}}"), SceneError);
    EXPECT_THROW(object_from("height_field{function 2,2{x} translate x smooth}"), SceneError);
}

/// Heights of the field made of a file with these bytes, z = 0 first.
std::vector<int> heights(const std::string& name, const std::string& bytes, const std::string& options = "") {
    const auto path = std::filesystem::path(testing::TempDir()) / name;
    std::ofstream(path, std::ios::binary) << bytes;
    const ObjectPtr object = object_from("height_field{\"" + path.string() + "\" " + options + "}");
    const auto mesh = std::get<ShapePtr>(object->geometry)->tessellate(0);
    std::vector<int> found;
    for (const Vec3f& v : mesh.value().vertices)
        found.push_back(static_cast<int>(std::lround(v.y * 65536.0f)));
    return found;
}

using Heights = std::vector<int>;

/// Numbers above 255 as two bytes, high first.
std::string bytes(std::initializer_list<int> values, bool wide = false) {
    std::string text;
    for (const int v : values) {
        if (wide) text += static_cast<char>(v / 256);
        text += static_cast<char>(v % 256);
    }
    return text;
}

TEST(HeightField, OfGreyPictures) {
    EXPECT_EQ(heights("a.pgm", "P5 3 2 255\n" + bytes({0, 128, 255, 64, 32, 16})),
              (Heights{16448, 8224, 4112, 0, 32896, 65535}));
    EXPECT_EQ(
        heights("b.pgm", "P5 # 16 bits\n3 2\n65535\n" + bytes({0, 32768, 65535, 16384, 8192, 4096}, true)),
        (Heights{16384, 8192, 4096, 0, 32768, 65535}));
    EXPECT_EQ(heights("c.pgm", "P2 2 2 100\n0 50 100 25"), (Heights{65535, 16383, 0, 32767}));
    EXPECT_EQ(heights("d.pgm", "P2 2 2 1000\n17 500 1000 999"), (Heights{65535, 65469, 1114, 32767}));
}

TEST(HeightField, GammaAsMeasured) {
    const std::string grey = "P5 3 2 255\n" + bytes({0, 128, 255, 64, 32, 16});
    EXPECT_EQ(heights("a.pgm", grey, "gamma 2.2"), (Heights{3084, 514, 0, 0, 14135, 65535}));
    EXPECT_EQ(heights("a.pgm", grey, "gamma srgb"), (Heights{3341, 771, 257, 0, 14135, 65535}));
    EXPECT_EQ(heights("b.pgm", "P5 2 2 65535\n" + bytes({1, 500, 65535, 256}, true), "gamma srgb"),
              (Heights{65535, 19, 0, 38}));
    EXPECT_EQ(heights("c.ppm", "P3 2 2 255 15 1 2 3 4 5 6 7 8 0 255 0", "gamma 2.2"),
              (Heights{17, 255, 128, 3}));
    EXPECT_THROW(heights("a.pgm", grey, "gamma 0"), SceneError);
}

TEST(HeightField, OfColors) {
    EXPECT_EQ(heights("a.ppm", "P3 3 2 255 0 0 0 128 7 200 255 255 255 64 1 9 32 2 8 16 3 7"),
              (Heights{16385, 8194, 4099, 0, 32775, 65535}));
    EXPECT_EQ(heights("b.ppm", "P6 3 2 65535\n" + bytes({0, 0, 0, 32768, 1000, 2000, 65535, 65535, 65535,
                                                         16384, 0, 0, 0, 16384, 0, 0, 0, 16384},
                                                        true)),
              (Heights{4866, 9650, 1867, 0, 10549, 65534}));
    EXPECT_EQ(heights("c.ppm", "P3 2 2 15\n15 1 2 3 4 5 6 7 8 0 1 0"), (Heights{26231, 17, 65297, 13124}));
    EXPECT_EQ(heights("d.ppm", "P3 2 2 300\n300 298 1 97 96 3 95 94 93 50 49 0"),
              (Heights{20574, 9548, 57831, 18720}));
}

TEST(HeightField, OfFunctionsWithColors) {
    const auto of = [](const std::string& text) {
        const auto mesh =
            std::get<ShapePtr>(object_from("height_field{" + text + "}")->geometry)->tessellate(0);
        return static_cast<int>(std::lround(mesh.value().vertices[0].y * 65536.0f));
    };
    EXPECT_EQ(of("function 3,2{pigment{rgb <.3,.5,.7,.2,.3>}}"), 30368);
    EXPECT_EQ(of("function 3,2{pigment{gradient x color_map{[0 rgb <.2,.4,1.5>][1 rgb <-.3,1.2,.1>]}}}"),
              23068);
    EXPECT_EQ(of("function 3,2{pattern{gradient y}}"), 65535);
}

}  // namespace
}  // namespace rb
