// Radiosity that is saved and loaded.
#include "rendered.h"

#include <filesystem>
#include <fstream>
#include <iterator>

namespace rb {
namespace {

class LightFile : public testing::Test {
protected:
    void SetUp() override {
        folder_ = std::filesystem::path(testing::TempDir()) /
                  testing::UnitTest::GetInstance()->current_test_info()->name();
        std::filesystem::create_directories(folder_);
        path_ = (folder_ / "light.rca").string();
    }
    void TearDown() override { std::filesystem::remove_all(folder_); }

    RenderResult with(const RadiosityFiles& files, GiMode mode = GiMode::points,
                      const std::string& settings = "count 30") const {
        RenderOptions options;
        options.radiosity_files = files;
        return rendered(mode, settings, several, 32, options);
    }
    std::string bytes() const {
        std::ifstream in(path_, std::ios::binary);
        return {std::istreambuf_iterator<char>(in), {}};
    }
    /// What is said of a file with these bytes.
    std::string complaint(const std::string& bytes) const {
        std::ofstream(path_, std::ios::binary) << bytes;
        try {
            with({path_, {}});
        } catch (const IoError& error) {
            return error.what();
        }
        return "";
    }

    std::filesystem::path folder_;
    std::string path_;
};

TEST_F(LightFile, LoadedEqualsSaved) {
    for (const GiMode mode : {GiMode::points, GiMode::cache}) {
        const RenderResult plain = with({}, mode);
        const RenderResult saved = with({{}, path_}, mode);
        const RenderResult loaded = with({path_, {}}, mode);
        for (size_t i = 0; i < plain.film.pixels.size(); ++i) {
            ASSERT_EQ(saved.film.pixels[i].rgb, plain.film.pixels[i].rgb) << i;
            ASSERT_EQ(loaded.film.pixels[i].rgb, saved.film.pixels[i].rgb) << i;
        }
        EXPECT_EQ(loaded.radiosity->records, saved.radiosity->records);
        EXPECT_LT(loaded.radiosity->gathers, saved.radiosity->gathers);
    }
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_), {}), 1) << "a file was left behind";
}

/// Another picture adds to it.
TEST_F(LightFile, LoadedAndSaved) {
    const RenderResult first = with({{}, path_});
    const std::string before = bytes();
    const RenderResult second = with({path_, path_});
    EXPECT_GE(second.radiosity->records[0], first.radiosity->records[0]);
    EXPECT_GE(bytes().size(), before.size());
    const RenderResult third = with({path_, {}});
    for (size_t i = 0; i < second.film.pixels.size(); ++i) {
        ASSERT_EQ(third.film.pixels[i].rgb, second.film.pixels[i].rgb) << i;
    }
}

TEST_F(LightFile, BadFilesAreSaid) {
    with({{}, path_});
    const std::string good = bytes();
    ASSERT_GT(good.size(), 2000u);
    EXPECT_EQ(complaint(good), "");
    for (const size_t size : {good.size() - 1, good.size() / 2, size_t{40}}) {
        EXPECT_NE(complaint(good.substr(0, size)).find("cut short"), std::string::npos) << size;
    }
    for (const std::string& other : {std::string(), std::string("C1 1.6 0 -1.8"), good.substr(0, 20)}) {
        EXPECT_NE(complaint(other).find("is no radiosity file"), std::string::npos) << other;
    }
    std::string damaged = good;
    damaged[1000] ^= 1;
    EXPECT_NE(complaint(damaged).find("damaged"), std::string::npos);
    EXPECT_NE(complaint(good + "x").find("damaged"), std::string::npos);
    std::string newer = good;
    newer[8] = 9;
    EXPECT_NE(complaint(newer).find("version 9"), std::string::npos);
}

TEST_F(LightFile, OtherSettingsAreSaid) {
    with({{}, path_});
    EXPECT_THROW(with({path_, {}}, GiMode::cache), IoError);
    EXPECT_THROW(with({path_, {}}, GiMode::points, "count 30 error_bound 0.2"), IoError);
    EXPECT_THROW(with({path_, {}}, GiMode::points, "count 30 recursion_limit 1"), IoError);
    EXPECT_THROW(with({path_ + ".missing", {}}), IoError);
    EXPECT_THROW(with({{}, path_ + "/no/folder"}), IoError);
}

}  // namespace
}  // namespace rb
