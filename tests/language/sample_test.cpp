// The standard include files and samples of an installed reference load without error.
#include "reading.h"

#include <filesystem>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

namespace rb {
namespace {

namespace fs = std::filesystem;

const fs::path examples = "/usr/share/doc/povray/examples";
const fs::path includes = "/usr/share/povray-3.7/include";

std::string errors_of(const std::string& text, const fs::path& folder) {
    LoadOptions options;
    options.input_file = "scene.pov";
    options.library_paths = {folder.string(), includes.string()};
    const Reading reading = read_scene(text, options);
    std::string out;
    for (const std::string& error : reading.errors) out += error + "\n";
    return out;
}

TEST(Sample, IncludeFilesLoad) {
    ASSERT_TRUE(fs::exists(includes)) << "install povray-includes";
    for (const auto& entry : fs::directory_iterator(includes)) {
        if (entry.path().extension() != ".inc") continue;
        const std::string name = entry.path().filename().string();
        // Some need what others declare.
        const std::string text =
            "#include \"colors.inc\" #include \"shapes.inc\" #include \"" + name + "\" sphere { 0, 1 }";
        EXPECT_EQ(errors_of(text, includes), "") << name;
    }
}

TEST(Sample, ScenesLoad) {
    ASSERT_TRUE(fs::exists(examples)) << "install povray-examples";
    constexpr const char* names[] = {"advanced/sombrero",
                                     "advanced/bwstripe",
                                     "advanced/teapot/teapot2",
                                     "camera/perspective",
                                     "camera/shear",
                                     "incdemo/transforms",
                                     "interior/iortest",
                                     "language/macros/macro1",
                                     "language/macros/macro2",
                                     "language/macros/macro3",
                                     "lights/arealit1",
                                     "lights/arealit2",
                                     "lights/arealit3",
                                     "lights/fillite",
                                     "lights/soft",
                                     "lights/spotlite",
                                     "templates/Basic_Scenes/Checkered_plane",
                                     "textures/pigments/checker2"};
    for (const char* name : names) {
        const fs::path path = examples / (std::string(name) + ".pov");
        std::ifstream in(path, std::ios::binary);
        ASSERT_TRUE(in) << path;
        std::stringstream text;
        text << in.rdbuf();
        EXPECT_EQ(errors_of(text.str(), path.parent_path()), "") << name;
    }
}

}  // namespace
}  // namespace rb
