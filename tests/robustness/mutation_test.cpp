// Scenes broken on purpose: every one of them gives an error with its place, and none crashes or hangs.
#include "language/load.h"

#include <chrono>
#include <filesystem>
#include <fstream>
#include <functional>
#include <random>

#include <gtest/gtest.h>

namespace rb {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> scene_texts() {
    std::vector<fs::path> paths;
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(RB_SOURCE_DIR) / "scenes")) {
        if (entry.path().extension() == ".pov") paths.push_back(entry.path());
    }
    std::ranges::sort(paths);
    std::vector<std::string> texts;
    for (const fs::path& path : paths) {
        std::ifstream in(path);
        texts.emplace_back(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>{});
    }
    return texts;
}

struct Outcome {
    bool loaded = false;
    std::vector<Diagnostic> errors;
    double seconds = 0;
};

Outcome load(const std::string& text) {
    LoadOptions options;
    options.input_file = "mutant.pov";
    options.input_text = text;
    options.image_width = 160;
    options.image_height = 120;
    options.max_tokens = 2'000'000;
    SourceMap sources;
    Diagnostics diagnostics;
    Scene scene;
    const auto start = std::chrono::steady_clock::now();
    Outcome out;
    out.loaded = load_scene(options, sources, diagnostics, scene);
    out.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    for (const Diagnostic& d : diagnostics.all()) {
        if (d.severity == Severity::error) out.errors.push_back(d);
    }
    return out;
}

using Random = std::mt19937;

size_t pick(Random& random, size_t count) { return random() % count; }

/// Places of a character outside comments.
std::vector<size_t> places_of(const std::string& text, std::string_view characters) {
    std::vector<size_t> places;
    bool comment = false;
    for (size_t i = 0; i < text.size(); ++i) {
        if (text.compare(i, 2, "//") == 0) comment = true;
        if (text[i] == '\n') comment = false;
        if (!comment && characters.find(text[i]) != std::string_view::npos) places.push_back(i);
    }
    return places;
}

/// Changes that no scene survives.
const std::vector<std::function<std::string(const std::string&, Random&)>> breakers{
    [](const std::string& text, Random& random) {  // a brace is lost
        std::string out = text;
        const auto places = places_of(text, "{}");
        out.erase(places[pick(random, places.size())], 1);
        return out;
    },
    [](const std::string& text, Random& random) {  // an unknown word inside a block
        std::string out = text;
        const auto places = places_of(text, "{");
        out.insert(places[pick(random, places.size())] + 1, " glorp ");
        return out;
    },
    [](const std::string& text, Random& random) {  // a comparison sign where a vector ends
        std::string out = text;
        const auto places = places_of(text, ">");
        out.replace(places[pick(random, places.size())], 1, " ~ ");
        return out;
    },
    [](const std::string& text, Random& random) {  // the file ends in the middle of a block
        const auto places = places_of(text, "{");
        return text.substr(0, places[pick(random, places.size())] + 1);
    },
    [](const std::string& text, Random&) { return text + "\n#if (1)\n"; },
    [](const std::string& text, Random&) { return text + "\n#end\n"; },
    [](const std::string& text, Random&) { return text + "\nsphere { <0, 1, 2, 3, 4, 5>, 1 }\n"; },
    [](const std::string& text, Random&) { return text + "\n#include \"there_is_no_such_file.inc\"\n"; },
    [](const std::string& text, Random&) { return text + "\n/* no end"; },
    [](const std::string& text, Random&) { return text + "\n#declare S = \"no end\n"; },
    [](const std::string& text, Random&) { return text + "\n#macro M(A) M(A + 1) #end M(0)\n"; },
    [](const std::string& text, Random&) { return text + "\n#declare A = array[3] { 1, 2 }\n"; },
    [](const std::string& text, Random&) { return text + "\nbox { -1, sqrt(-1) }\n"; },
    [](const std::string& text, Random&) { return text + "\n" + std::string(100000, '('); },
    [](const std::string& text, Random&) {
        return text + "\nunion {" + [] {
            std::string deep;
            for (int i = 0; i < 50000; ++i) deep += " union {";
            return deep;
        }();
    },
};

TEST(Mutation, EveryBrokenSceneGivesAnErrorWithItsPlace) {
    const std::vector<std::string> texts = scene_texts();
    ASSERT_FALSE(texts.empty());
    Random random(20);
    for (size_t i = 0; i < 300; ++i) {
        const std::string& text = texts[pick(random, texts.size())];
        const size_t breaker = i % breakers.size();
        const std::string mutant = breakers[breaker](text, random);
        const Outcome out = load(mutant);
        EXPECT_FALSE(out.loaded) << "breaker " << breaker << "\n" << mutant.substr(0, 3000);
        ASSERT_FALSE(out.errors.empty()) << "breaker " << breaker;
        EXPECT_TRUE(out.errors.front().where.known())
            << "breaker " << breaker << ": " << out.errors.front().message;
        EXPECT_LT(out.seconds, 10.0) << "breaker " << breaker;
    }
}

// What the fuzzers (scripts/fuzz.sh) found.
TEST(Find, StaysMended) {
    std::ifstream in(fs::path(RB_SOURCE_DIR) / "tests/robustness/finds.txt");
    std::vector<std::string> finds;
    for (std::string line; std::getline(in, line);) {
        if (line.starts_with("--- ")) {
            finds.emplace_back();
        } else if (!finds.empty()) {
            finds.back() += line + "\n";
        }
    }
    EXPECT_FALSE(finds.empty());
    for (const std::string& text : finds) {
        const Outcome out = load(text);
        EXPECT_EQ(out.loaded, out.errors.empty()) << text;
        EXPECT_LT(out.seconds, 10.0) << text;
    }
}

TEST(Mutation, RandomDamageNeverCrashes) {
    const std::vector<std::string> texts = scene_texts();
    Random random(7);
    for (int i = 0; i < 1500; ++i) {
        std::string mutant = texts[pick(random, texts.size())];
        for (size_t edits = 1 + pick(random, 4); edits > 0; --edits) {
            const size_t at = pick(random, mutant.size());
            const size_t length = std::min(mutant.size() - at, 1 + pick(random, 12));
            switch (random() % 4) {
                case 0:
                    mutant.erase(at, length);
                    break;
                case 1:
                    mutant.insert(at, mutant.substr(pick(random, mutant.size()), length));
                    break;
                case 2:
                    mutant[at] = static_cast<char>(random() % 256);
                    break;
                default:
                    mutant.insert(at, std::vector<std::string>{"#end", "1e308", "{", ">", "#declare", "-",
                                                               "\"", "#macro"}[random() % 8]);
            }
            if (mutant.empty()) mutant = " ";
        }
        const Outcome out = load(mutant);
        EXPECT_EQ(out.loaded, out.errors.empty());
        EXPECT_LT(out.seconds, 20.0) << mutant;
    }
}

}  // namespace
}  // namespace rb
