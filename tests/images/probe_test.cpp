// The probes of probes.txt: scene text in, linear light out.
#include "app/picture.h"
#include "compile/world.h"
#include "language/load.h"
#include "render/render.h"

#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

namespace rb {
namespace {

struct Pixel {
    int x, y;
    double r, g, b, tolerance;
    std::optional<double> alpha;  ///< the colour is straight, as in a file
};

struct Probe {
    int number = 0;
    std::string title;
    int width = 1;
    int height = 1;
    std::string version = "3.7";
    std::string global;
    std::string options;
    std::string camera;
    std::string scene;
    std::vector<Pixel> pixels;
};

std::vector<Probe> read_probes() {
    std::vector<Probe> probes;
    std::ifstream in(RB_SOURCE_DIR "/tests/images/probes.txt");
    for (std::string line; std::getline(in, line);) {
        if (line.empty() || line.front() == '#') continue;
        std::istringstream words(line);
        std::string key;
        words >> key;
        const std::string rest = line.size() > key.size() ? line.substr(key.size() + 1) : "";
        if (key == "probe") {
            probes.emplace_back();
            words >> probes.back().number;
            std::getline(words >> std::ws, probes.back().title);
            continue;
        }
        Probe& p = probes.back();
        if (key == "size") words >> p.width >> p.height;
        if (key == "version") p.version = rest;
        if (key == "global") p.global = rest;
        if (key == "options") p.options = rest;
        if (key == "camera") p.camera = rest;
        if (key == "scene") p.scene = rest;
        if (key == "pixel") {
            Pixel q{};
            words >> q.x >> q.y >> q.r >> q.g >> q.b >> q.tolerance;
            p.pixels.push_back(q);
        }
        if (key == "straight") {
            Pixel q{};
            words >> q.x >> q.y >> q.r >> q.g >> q.b >> q.alpha.emplace() >> q.tolerance;
            p.pixels.push_back(q);
        }
    }
    return probes;
}

AntialiasOptions antialias_of(const std::string& options) {
    AntialiasOptions out;
    std::istringstream words(options);
    for (std::string word; words >> word;) {
        if (word.starts_with("+A0")) {
            out.threshold = std::stod(word.substr(2));
            if (out.method == 0) out.method = 1;
        }
        if (word.starts_with("+AM")) out.method = std::stoi(word.substr(3));
        if (word.starts_with("+R")) out.depth = std::stoi(word.substr(2));
        if (word == "-J") out.jitter = 0;
    }
    return out;
}

/// What a picture file with alpha and linear colours holds.
std::vector<float> straight_row(const Film& film, int y) {
    Settings settings;
    settings.alpha = true;
    settings.bits_per_color = 16;
    settings.file_gamma = 1.0;
    const PixelRows rows = picture_of(film, GammaCurve{1.0}, settings);
    std::vector<float> row(static_cast<size_t>(4 * film.width));
    rows.fill(y, row);
    return row;
}

class Probes : public testing::TestWithParam<Probe> {};

TEST_P(Probes, MatchTheMeasuredValues) {
    const Probe& p = GetParam();
    LoadOptions loading;
    loading.input_file = "probe";
    loading.input_text = "#version " + p.version + ";\nglobal_settings { assumed_gamma 1.0 " + p.global +
                         " }\n" + p.camera + "\n" + p.scene + "\n";
    loading.image_width = p.width;
    loading.image_height = p.height;
    SourceMap sources;
    Diagnostics diagnostics;
    Scene scene;
    const bool loaded = load_scene(loading, sources, diagnostics, scene);
    for (const Diagnostic& d : diagnostics.all()) {
        if (d.severity == Severity::error) ADD_FAILURE() << format(d, sources);
    }
    ASSERT_TRUE(loaded);
    CompileOptions compiling;
    compiling.image_width = p.width;
    compiling.image_height = p.height;
    const World world = compile(scene, compiling, diagnostics);
    RenderOptions options;
    options.width = p.width;
    options.height = p.height;
    options.region = {0, 0, p.width, p.height};
    options.antialias = antialias_of(p.options);
    options.shading.alpha_output = p.options.find("+UA") != std::string::npos;
    options.gi = GiMode::brute;
    const std::atomic<bool> stop{false};
    const RenderResult result = render(world, options, stop, nullptr);
    for (const Pixel& q : p.pixels) {
        Rgb got = result.film.at(q.x, q.y).rgb;
        if (q.alpha) {
            const std::vector<float> row = straight_row(result.film, q.y);
            const float* value = row.data() + static_cast<ptrdiff_t>(4 * q.x);
            got = {value[0], value[1], value[2]};
            EXPECT_NEAR(value[3], *q.alpha, q.tolerance) << q.x << ',' << q.y;
        }
        EXPECT_NEAR(got.x, q.r, q.tolerance) << q.x << ',' << q.y;
        EXPECT_NEAR(got.y, q.g, q.tolerance) << q.x << ',' << q.y;
        EXPECT_NEAR(got.z, q.b, q.tolerance) << q.x << ',' << q.y;
    }
}

INSTANTIATE_TEST_SUITE_P(Shading, Probes, testing::ValuesIn(read_probes()), [](const auto& i) {
    std::string name = std::to_string(i.param.number) + "_" + i.param.title;
    for (char& c : name) {
        if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
    }
    return name;
});

}  // namespace
}  // namespace rb
