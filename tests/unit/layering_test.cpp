// Reads every #include of the sources and fails on an edge that src/layers.txt does not allow.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace rb {
namespace {

namespace fs = std::filesystem;

struct Layers {
    std::map<std::string, std::set<std::string>> allowed;              // folder -> folders it may use
    std::vector<std::pair<std::string, std::set<std::string>>> homes;  // header prefix -> folders
};

Layers read_layers() {
    Layers layers;
    std::ifstream in(fs::path(RB_SOURCE_DIR) / "src/layers.txt");
    for (std::string line; std::getline(in, line);) {
        if (line.empty() || line.front() == '#') continue;
        std::istringstream words(line);
        std::string first;
        words >> first;
        std::set<std::string> rest;
        for (std::string word; words >> word;) rest.insert(word);
        if (first.front() == '<') {
            layers.homes.emplace_back(first.substr(1), rest);
        } else {
            layers.allowed[first.substr(0, first.size() - 1)] = rest;
        }
    }
    return layers;
}

/// "src/image/oiio/module.cpp" -> "image/oiio"; "grammar/lex.h" -> "grammar".
std::string folder_of(const fs::path& file) {
    const fs::path relative = fs::relative(file.parent_path(), RB_SOURCE_DIR);
    const std::string text = relative.generic_string();
    return text.starts_with("src/") ? text.substr(4) : text;
}

std::string top_of(const std::string& folder) { return folder.substr(0, folder.find('/')); }

template <class Visit>
void for_each_include(Visit visit) {
    for (const char* root : {"src", "grammar"}) {
        for (const auto& entry : fs::recursive_directory_iterator(fs::path(RB_SOURCE_DIR) / root)) {
            const std::string extension = entry.path().extension().string();
            if (extension != ".h" && extension != ".cpp") continue;
            std::ifstream in(entry.path());
            for (std::string line; std::getline(in, line);) {
                const size_t at = line.find("#include ");
                if (at == 0 && line.size() > 10) visit(entry.path(), line.substr(9));
            }
        }
    }
}

TEST(Layering, FoldersUseOnlyWhatTheyMay) {
    const Layers layers = read_layers();
    ASSERT_FALSE(layers.allowed.empty());
    for_each_include([&](const fs::path& file, const std::string& include) {
        if (include.front() != '"') return;
        const std::string from = top_of(folder_of(file));
        const std::string to = top_of(include.substr(1, include.size() - 2));
        ASSERT_TRUE(layers.allowed.contains(from)) << from << " is not in src/layers.txt";
        if (to == from || include.ends_with(".def\"")) return;
        EXPECT_TRUE(layers.allowed.at(from).contains(to)) << file << " may not include " << include;
    });
}

TEST(Layering, LibrariesStayAtHome) {
    const Layers layers = read_layers();
    for_each_include([&](const fs::path& file, const std::string& include) {
        if (include.front() != '<') return;
        for (const auto& [prefix, homes] : layers.homes) {
            if (!include.substr(1).starts_with(prefix)) continue;
            EXPECT_TRUE(homes.contains(folder_of(file))) << file << " may not include " << include;
        }
    });
}

TEST(Layering, NoCircles) {
    const Layers layers = read_layers();
    std::set<std::string> placed;
    while (placed.size() < layers.allowed.size()) {
        const size_t before = placed.size();
        for (const auto& [folder, uses] : layers.allowed) {
            if (std::ranges::includes(placed, uses)) placed.insert(folder);
        }
        ASSERT_GT(placed.size(), before) << "the layers depend on each other in a circle";
    }
}

}  // namespace
}  // namespace rb
