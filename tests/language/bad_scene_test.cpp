// tests/language/bad_scenes.txt: scenes that have errors, and the diagnostics they must get (RB_UPDATE=1
// writes these).
#include "reading.h"

#include <cstdlib>
#include <fstream>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace rb {
namespace {

constexpr std::string_view head = "#version 3.7; global_settings { assumed_gamma 1 } ";

/// "LINE:COLUMN: message" of each error and its notes, columns without the head.
std::vector<std::string> diagnostics_of(const std::string& scene) {
    LoadOptions options;
    options.input_file = "bad.pov";
    options.input_text = std::string(head) + scene;
    options.max_tokens = 1'000'000;
    SourceMap sources;
    Diagnostics diagnostics;
    Scene out;
    load_scene(options, sources, diagnostics, out);
    std::vector<std::string> lines;
    for (const Diagnostic& d : diagnostics.all()) {
        if (d.severity != Severity::error) continue;
        if (!d.where.known()) {
            lines.push_back("nowhere: " + d.message);
            continue;
        }
        const LineColumn at = sources.position(d.where.file, d.where.begin);
        const auto column = at.line == 1 ? at.column - head.size() : at.column;
        lines.push_back(fmt::format("{}:{}: {}", at.line, column, d.message));
        for (const Diagnostic& note : d.notes) lines.push_back("  note: " + note.message);
    }
    return lines;
}

struct BadScene {
    std::string title;
    std::string text;
    std::vector<std::string> expected;
};

TEST(BadScene, GetsItsDiagnostics) {
    const std::string path = std::string(RB_SOURCE_DIR) + "/tests/language/bad_scenes.txt";
    std::ifstream in(path);
    std::string notes;
    std::vector<BadScene> scenes;
    for (std::string line; std::getline(in, line);) {
        if (line.starts_with("--- ")) {
            scenes.push_back({line.substr(4), {}, {}});
        } else if (scenes.empty()) {
            notes += line + "\n";
        } else if (line.starts_with("=> ")) {
            scenes.back().expected.push_back(line.substr(3));
        } else {
            scenes.back().text += line + "\n";
        }
    }
    in.close();
    ASSERT_GE(scenes.size(), 200u);
    std::string written = notes;
    for (const BadScene& scene : scenes) {
        const std::vector<std::string> found = diagnostics_of(scene.text);
        written += "--- " + scene.title + "\n" + scene.text;
        for (const std::string& line : found) written += "=> " + line + "\n";
        EXPECT_FALSE(found.empty()) << scene.text;
        if (std::getenv("RB_UPDATE") == nullptr) {
            EXPECT_EQ(found, scene.expected) << scene.text;
        }
    }
    if (std::getenv("RB_UPDATE") != nullptr) std::ofstream(path) << written;
}

}  // namespace
}  // namespace rb
