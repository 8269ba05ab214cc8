// Interrupted pictures: what is continued equals what was never interrupted.
#include "app/picture_state.h"

#include "app/geometry_oracle.h"
#include "compile/world.h"
#include "language/load.h"

#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

namespace rb {
namespace {

World world_of(const std::string& text) {
    SourceMap sources;
    Diagnostics diagnostics;
    ProbeOracle oracle(diagnostics);
    LoadOptions options;
    options.input_file = "state.pov";
    options.input_text = text;
    options.oracle = &oracle;
    Scene scene;
    EXPECT_TRUE(load_scene(options, sources, diagnostics, scene));
    return compile(scene, {}, diagnostics);
}

class PictureStateTest : public testing::Test {
protected:
    void SetUp() override {
        folder_ = std::filesystem::path(testing::TempDir()) / "picture_state";
        std::filesystem::create_directories(folder_);
        options_.width = 100;
        options_.height = 70;
        options_.region = {0, 0, 100, 70};
        options_.block_size = 16;
        options_.threads = 1;
    }
    void TearDown() override { std::filesystem::remove_all(folder_); }

    std::string picture() const { return (folder_ / "p.png").string(); }

    /// Stops when so many pixels are done.
    RenderResult run(PictureState* state, size_t stop_after) {
        std::atomic<bool> stop{false};
        const auto progress = [&](size_t done, size_t) { stop.store(done >= stop_after); };
        return render(world_, options_, stop, progress, state);
    }

    std::filesystem::path folder_;
    RenderOptions options_;
    World world_ = world_of(
        "#version 3.7; camera { location <0,1,-4> look_at 0 } light_source { <3,5,-4>, 1 }"
        "sphere { 0, 1 pigment { rgb <1,.5,.2> } finish { phong 1 reflection .3 } } plane { y, -1 pigment { "
        "checker } }");
};

bool same(const Film& a, const Film& b) {
    for (size_t i = 0; i < a.pixels.size(); ++i) {
        if (a.pixels[i].rgb != b.pixels[i].rgb || a.pixels[i].transmit != b.pixels[i].transmit) return false;
    }
    return a.pixels.size() == b.pixels.size();
}

TEST_F(PictureStateTest, ContinuedEqualsWhole) {
    constexpr size_t never = 1u << 30;
    const RenderResult whole = run(nullptr, never);
    PictureState first(picture());
    first.begin(7);
    const RenderResult part = run(&first, 3000);
    ASSERT_FALSE(part.complete);
    EXPECT_FALSE(first.exists()) << "a file for a picture of a moment";
    first.keep(part.film);
    EXPECT_TRUE(first.exists());

    PictureState other(picture());
    EXPECT_FALSE(other.load(8)) << "the state of another picture";

    PictureState second(picture());
    ASSERT_TRUE(second.load(7));
    const RenderResult rest = run(&second, never);
    EXPECT_TRUE(rest.complete);
    EXPECT_TRUE(same(rest.film, whole.film));
    EXPECT_EQ(rest.counters.camera + part.counters.camera, whole.counters.camera);
    second.remove();
    EXPECT_FALSE(second.exists());
}

TEST_F(PictureStateTest, HalfABlockAtTheEndIsDropped) {
    constexpr size_t never = 1u << 30;
    const RenderResult whole = run(nullptr, never);
    PictureState first(picture());
    first.begin(7);
    first.keep(run(&first, 3000).film);
    const auto path = folder_ / "p.state";
    std::filesystem::resize_file(path, std::filesystem::file_size(path) - 100);
    PictureState second(picture());
    ASSERT_TRUE(second.load(7));
    EXPECT_TRUE(same(run(&second, never).film, whole.film));

    std::ofstream(path) << "something else";
    EXPECT_FALSE(PictureState(picture()).load(7));
}

}  // namespace
}  // namespace rb
