// Every scene of scenes/ against the picture that POV-Ray made of it (reference_images/,
// scripts/remake_references.sh). On failure got, want and the difference lie in <build>/image_failures.
#include "app/commands.h"
#include "image/compare.h"
#include "image/file.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

namespace rb {
namespace {

namespace fs = std::filesystem;

const fs::path source_dir = RB_SOURCE_DIR;

struct ImageCase {
    std::string name;  ///< "shapes/sphere"
    std::vector<std::string> options;
    double max_off = 0.001;  ///< share of pixels off by more than 8/255
};

ImageCase read_case(const fs::path& scene) {
    ImageCase c;
    c.name = fs::relative(scene, source_dir / "scenes").replace_extension().generic_string();
    std::ifstream in(scene);
    for (std::string line; std::getline(in, line) && line.starts_with("//");) {
        std::istringstream words(line.substr(2));
        std::string key;
        words >> key;
        if (key == "options:") {
            for (std::string word; words >> word;) c.options.push_back(word);
        } else if (key == "tolerance:") {
            words >> c.max_off;
        }
    }
    return c;
}

std::vector<ImageCase> all_cases() {
    std::vector<ImageCase> cases;
    for (const auto& entry : fs::recursive_directory_iterator(source_dir / "scenes")) {
        if (entry.path().extension() == ".pov") cases.push_back(read_case(entry.path()));
    }
    std::ranges::sort(cases, {}, &ImageCase::name);
    return cases;
}

std::vector<std::string> arguments(const ImageCase& c, const fs::path& out) {
    std::vector<std::string> words{"+I" + (source_dir / "scenes" / (c.name + ".pov")).string(),
                                   "+O" + out.string(),
                                   "+W160",
                                   "+H120",
                                   "-A",
                                   "-D",
                                   "-V",
                                   "+FN8"};
    words.insert(words.end(), c.options.begin(), c.options.end());
    return words;
}

fs::path work_dir() {
    const fs::path folder = fs::path(RB_BINARY_DIR) / "image_failures";
    fs::create_directories(folder);
    return folder;
}

std::string flat(std::string name) {
    std::ranges::replace(name, '/', '_');
    return name;
}

class Images : public testing::TestWithParam<ImageCase> {};

TEST_P(Images, EqualTheReference) {
    const ImageCase& c = GetParam();
    const fs::path got = work_dir() / (flat(c.name) + ".got.png");
    const fs::path want = source_dir / "reference_images" / (c.name + ".png");
    ASSERT_TRUE(fs::exists(want)) << "make it with scripts/remake_references.sh scenes/" << c.name << ".pov";
    ASSERT_EQ(run(arguments(c, got)), exit_done);
    const Pixels ours = read_image(got.string());
    const Pixels reference = read_image(want.string());
    const ImageDifference d = compare(ours, reference);
    RecordProperty("share_off", std::to_string(d.share_off));
    EXPECT_LE(d.share_off, c.max_off) << "rmse " << d.rmse << "/255, ssim " << d.ssim;
    if (d.share_off <= c.max_off) {
        fs::remove(got);
        return;
    }
    const Pixels heat = heat_map(ours, reference);
    write_image(rows_of(heat), {}, (work_dir() / (flat(c.name) + ".diff.png")).string());
    fs::copy_file(want, work_dir() / (flat(c.name) + ".want.png"), fs::copy_options::overwrite_existing);
}

INSTANTIATE_TEST_SUITE_P(Scenes, Images, testing::ValuesIn(all_cases()),
                         [](const auto& i) { return flat(i.param.name); });

/// The same scene with other means gives the same file, byte for byte.
class Invariance : public testing::TestWithParam<std::string> {};

std::string bytes_of(const ImageCase& c, const std::vector<std::string>& more) {
    const fs::path out = work_dir() / (flat(c.name) + ".invariance.png");
    std::vector<std::string> words = arguments(c, out);
    words.insert(words.end(), more.begin(), more.end());
    EXPECT_EQ(run(words), exit_done);
    std::ifstream in(out, std::ios::binary);
    std::string bytes(std::istreambuf_iterator<char>(in), {});
    fs::remove(out);
    return bytes;
}

TEST_P(Invariance, ThreadsAndSkipsDoNotShow) {
    const ImageCase c = read_case(source_dir / "scenes" / (GetParam() + ".pov"));
    const std::string one = bytes_of(c, {"+FN16", "+WT1"});
    ASSERT_FALSE(one.empty());
    EXPECT_EQ(bytes_of(c, {"+FN16", "+WT3"}), one) << "threads";
    EXPECT_EQ(bytes_of(c, {"+FN16", "+WT2", "--no-skip"}), one) << "--no-skip";
    EXPECT_EQ(bytes_of(c, {"+FN16", "+WT2", "--brute-force"}), one) << "--brute-force";
}

/// Copies that share their surfaces look like copies with surfaces of their own: 8 bits, since rays in a
/// copy's space are rounded otherwise.
TEST(Instances, DoNotShow) {
    for (const char* name : {"csg/instances", "csg/nested", "gallery/still_life"}) {
        const ImageCase c = read_case(source_dir / "scenes" / (std::string(name) + ".pov"));
        const std::string never = bytes_of(c, {"+A0.3", "--instances", "never"});
        ASSERT_FALSE(never.empty());
        EXPECT_EQ(bytes_of(c, {"+A0.3", "--instances", "always"}), never) << name;
        EXPECT_EQ(bytes_of(c, {"+A0.3", "--instances", "always", "--brute-force"}), never) << name;
    }
}

INSTANTIATE_TEST_SUITE_P(Scenes, Invariance,
                         testing::Values("gallery/still_life", "csg/nested", "csg/instances", "shapes/mesh",
                                         "shapes/mesh2", "lights/area_jitter", "antialias/method1",
                                         "antialias/method2", "transparency/refraction", "textures/layered",
                                         "language/macros", "media/scattering", "media/air", "media/methods",
                                         "photons/glass", "photons/media", "radiosity/cornell_box",
                                         "radiosity/thin_walls"),
                         [](const auto& i) { return flat(i.param); });

/// Meshes instead of exact shapes: the same picture within the error of the meshes.
class Tessellated : public testing::TestWithParam<std::string> {};

void expect_reference_with(const std::string& name, const std::string& geometry) {
    const ImageCase c = read_case(source_dir / "scenes" / (name + ".pov"));
    const fs::path got = work_dir() / (flat(c.name) + "." + geometry + ".png");
    std::vector<std::string> words = arguments(c, got);
    words.insert(words.end(), {"--geometry", geometry});
    ASSERT_EQ(run(words), exit_done);
    const fs::path want = source_dir / "reference_images" / (c.name + ".png");
    EXPECT_LE(compare(read_image(got.string()), read_image(want.string())).share_off, 0.001);
    fs::remove(got);
}

TEST_P(Tessellated, LooksLikeTheReference) { expect_reference_with(GetParam(), "tessellate"); }
TEST_P(Tessellated, RefinedLooksLikeTheReference) { expect_reference_with(GetParam(), "refine"); }

INSTANTIATE_TEST_SUITE_P(Scenes, Tessellated,
                         testing::Values("shapes/sphere", "shapes/box", "shapes/cylinder", "shapes/cone",
                                         "shapes/disc", "shapes/torus", "shapes/triangle",
                                         "shapes/superellipsoid", "shapes/sphere_sweep",
                                         "shapes/smooth_triangle", "shapes/mesh", "csg/difference",
                                         "csg/nested", "csg/clipped_by"),
                         [](const auto& i) { return flat(i.param); });

}  // namespace
}  // namespace rb
