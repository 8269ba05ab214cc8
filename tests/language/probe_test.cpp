// tests/language/probes.txt: small pieces of scene and what povray says to them
// (scripts/remake_language_probes.py).
#include "app/geometry_oracle.h"
#include "reading.h"

#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

namespace rb {
namespace {

struct Probe {
    std::string title;
    std::string text;
    std::string expected;
};

std::vector<Probe> probes() {
    std::ifstream in(std::string(RB_SOURCE_DIR) + "/tests/language/probes.txt");
    std::vector<Probe> out;
    std::string head;
    for (std::string line; std::getline(in, line);) {
        if (line.starts_with("--- ")) {
            out.push_back({line.substr(4), {}, {}});
        } else if (out.empty()) {
            head += line + "\n";
        } else if (line.starts_with("=> ") || line.starts_with("=! ")) {
            // The second kind is ours where it differs on purpose.
            out.back().expected = line.substr(3);
        } else {
            out.back().text += line + "\n";
        }
    }
    constexpr std::string_view bare = "[bare]";
    for (Probe& p : out) {
        p.text = (p.text.starts_with(bare) ? p.text.substr(bare.size()) : head + p.text) +
                 "\n#debug \"\\n\" sphere { 0, 1 }\n";
    }
    return out;
}

std::string trimmed(std::string_view line) {
    const size_t begin = line.find_first_not_of(" \t");
    return begin == std::string_view::npos
               ? std::string{}
               : std::string(line.substr(begin, line.find_last_not_of(" \t") + 1 - begin));
}

std::string answer(const Reading& reading) {
    if (!reading.errors.empty())
        return "refused: " + reading.errors[0].substr(reading.errors[0].find(' ') + 1);
    std::string out;
    std::istringstream lines(reading.debug);
    for (std::string line; std::getline(lines, line);) {
        line = trimmed(line);
        if (!line.empty()) out += (out.empty() ? "" : " | ") + line;
    }
    return out.empty() ? "(nothing)" : out;
}

TEST(Probe, SaysWhatPovraySays) {
    namespace fs = std::filesystem;
    const fs::path folder = fs::path(RB_BINARY_DIR) / "language_probes";
    const fs::path before = fs::current_path();
    fs::create_directories(folder);
    fs::current_path(folder);
    for (const Probe& p : probes()) {
        Diagnostics of_geometry;
        ProbeOracle oracle(of_geometry);
        LoadOptions options;
        options.input_file = "p.pov";
        options.oracle = &oracle;
        EXPECT_EQ(answer(read_scene(p.text, options)), p.expected) << p.title << "\n" << p.text;
    }
    fs::current_path(before);
}

}  // namespace
}  // namespace rb
