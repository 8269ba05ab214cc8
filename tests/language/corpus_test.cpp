// good/*.pov must give the scene in the .dump beside it (RB_UPDATE=1 writes it); bad/*.pov must give the
// messages that stand as `//! error: text` on the lines they belong to.
#include "reading.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace rb {
namespace {

namespace fs = std::filesystem;

const fs::path here = fs::path(RB_SOURCE_DIR) / "tests" / "language";

std::string content(const fs::path& path) {
    std::ifstream in(path, std::ios::binary);
    std::stringstream out;
    out << in.rdbuf();
    return out.str();
}

std::vector<fs::path> scenes(const char* folder) {
    std::vector<fs::path> out;
    for (const auto& entry : fs::directory_iterator(here / folder)) {
        if (entry.path().extension() == ".pov") out.push_back(entry.path());
    }
    std::sort(out.begin(), out.end());
    return out;
}

Reading read_file(const fs::path& path) {
    LoadOptions options;
    options.input_file = path.filename().string();
    options.library_paths = {path.parent_path().string()};
    return read_scene(content(path), options);
}

TEST(Corpus, GoodScenesGiveTheirDump) {
    for (const fs::path& path : scenes("good")) {
        const Reading reading = read_file(path);
        ASSERT_TRUE(reading.done) << path << "\n" << reading.report;
        const std::string found = dump(reading.scene) + reading.debug;
        fs::path expected = path;
        expected.replace_extension(".dump");
        if (std::getenv("RB_UPDATE")) std::ofstream(expected) << found;
        EXPECT_EQ(found, content(expected)) << path;
    }
}

TEST(Corpus, BadScenesGiveTheirMessages) {
    for (const fs::path& path : scenes("bad")) {
        std::vector<std::string> expected;
        std::istringstream lines(content(path));
        int number = 0;
        for (std::string line; std::getline(lines, line);) {
            ++number;
            constexpr std::string_view mark = "//! error: ";
            if (const size_t at = line.find(mark); at != std::string::npos) {
                expected.push_back(fmt::format("{}: {}", number, line.substr(at + mark.size())));
            }
        }
        const Reading reading = read_file(path);
        EXPECT_EQ(reading.errors, expected) << path << "\n" << reading.report;
    }
}

}  // namespace
}  // namespace rb
