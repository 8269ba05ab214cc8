// density_file: values measured from POV-Ray 3.7.0.10 on files of our own, and files that are no density
// files.
#include "base/diagnostics.h"
#include "pattern_text.h"
#include "patterns/pattern_field.h"

#include <array>
#include <filesystem>
#include <fstream>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace rb {
namespace {

std::string big_endian(uint64_t value, int bytes) {
    std::string out;
    for (int i = bytes - 1; i >= 0; --i) out.push_back(static_cast<char>(value >> (8 * i) & 0xff));
    return out;
}

std::string header(int nx, int ny, int nz) {
    return big_endian(static_cast<uint64_t>(nx), 2) + big_endian(static_cast<uint64_t>(ny), 2) +
           big_endian(static_cast<uint64_t>(nz), 2);
}

/// Samples that jump about: the upper bits of multiples of a large odd number.
std::string grid(int nx, int ny, int nz, int bytes) {
    std::string out = header(nx, ny, nz);
    for (uint64_t i = 0; i < static_cast<uint64_t>(nx * ny * nz); ++i) {
        const uint64_t mixed = (i * 2654435761u + 11) & 0xffffffffu;
        out += big_endian(mixed >> (32 - 8 * bytes), bytes);
    }
    return out;
}

class DensityFiles : public testing::Test {
protected:
    void SetUp() override {
        std::filesystem::create_directories(folder_);
        write("t8.df3", grid(3, 4, 2, 1));
        write("t16.df3", grid(4, 8, 16, 2));
        write("t32.df3", grid(5, 7, 6, 4));
    }
    void TearDown() override { std::filesystem::remove_all(folder_); }

    void write(const std::string& name, const std::string& bytes) const {
        std::ofstream(folder_ / name, std::ios::binary) << bytes;
    }
    std::string statement(const std::string& name, const std::string& rest) const {
        return fmt::format("density_file df3 \"{}\" {}", (folder_ / name).string(), rest);
    }
    double value(const std::string& name, const std::string& rest, const Vec3& at) const {
        const WrittenPattern written = pattern_of(statement(name, rest));
        const PatternField field(written.pattern, written.modifiers, {});
        std::array<Vec3, 1> point{at};
        std::array<double, 1> out{};
        field.carry(point);
        field.values({point, nullptr, {}}, out);
        return out[0];
    }

    std::filesystem::path folder_ = std::filesystem::path(testing::TempDir()) / "density_files";
};

struct DensityRow {
    const char* file;
    const char* rest;
    double value[4];
};
constexpr std::array<Vec3, 4> places{Vec3{0.05, 0.013, 0.41}, Vec3{0.421, 0.246, 0.129},
                                     Vec3{0.792, 0.479, 0.848}, Vec3{0.99, 0.97, 0.003}};
constexpr DensityRow density_rows[] = {
    {"t8.df3", "", {0.000000000, 0.619607843, 0.505882353, 0.800000000}},
    {"t8.df3", "interpolate 1", {0.317148047, 0.477843699, 0.654292180, 0.076842852}},
    {"t8.df3", "interpolate 2", {0.331676453, 0.426697373, 0.750934541, 0.000372022}},
    {"t16.df3", "interpolate 0", {0.662531472, 0.644342718, 0.372640574, 0.159044785}},
    {"t16.df3", "interpolate 1", {0.473795470, 0.539533134, 0.663360455, 0.122534593}},
    {"t16.df3", "interpolate 2", {0.459388345, 0.576692939, 0.790544152, 0.019778550}},
    {"t32.df3", "interpolate 0", {0.262379077, 0.326237910, 0.280559450, 0.013155553}},
    {"t32.df3", "interpolate 1", {0.600440224, 0.346220753, 0.891978667, 0.133780328}},
    {"t32.df3", "interpolate 2", {0.605874360, 0.269288778, 0.980093539, 0.078956485}},
};

TEST_F(DensityFiles, MatchTheMeasuredValues) {
    for (const DensityRow& row : density_rows) {
        // The reference computes cubics in single precision.
        const double tolerance = std::string_view(row.rest) == "interpolate 2" ? 3e-7 : 2e-9;
        for (size_t i = 0; i < 4; ++i) {
            EXPECT_NEAR(value(row.file, row.rest, places[i]), row.value[i], tolerance)
                << row.file << ' ' << row.rest << ' ' << i;
        }
    }
}

TEST_F(DensityFiles, OnlyTheLastDigitOfInterpolateCounts) {
    const Vec3& p = places[1];
    const auto with = [&](const std::string& rest) { return value("t8.df3", rest, p); };
    EXPECT_EQ(with("interpolate 10"), with(""));
    EXPECT_EQ(with("interpolate 1.7"), with("interpolate 1"));
    EXPECT_EQ(with("interpolate -1"), with("interpolate 2"));
    EXPECT_EQ(with("interpolate 1 interpolate 2"), with("interpolate 2"));
    EXPECT_NE(with("interpolate 1"), with("interpolate 2"));
}

TEST_F(DensityFiles, AreNothingOutsideTheUnitCube) {
    const double below_one = 1.0 - 1e-16;
    EXPECT_GT(value("t8.df3", "", {below_one, below_one, below_one}), 0.0);
    for (const Vec3& p : {Vec3{1.0, 0.5, 0.5}, Vec3{0.5, -1e-9, 0.5}, Vec3{0.5, 0.5, 1.5}})
        EXPECT_EQ(value("t8.df3", "interpolate 1", p), 0.0);
}

TEST_F(DensityFiles, FrequencyAndTransformationsActAfterwards) {
    EXPECT_NEAR(value("t8.df3", "translate 0.2 frequency 2.5 phase 0.3", places[1] + 0.2),
                2.5 * 0.619607843 + 0.3 - 1.00001, 2e-7);
}

TEST_F(DensityFiles, OfAnotherLengthAreRefused) {
    const std::string good = grid(3, 4, 2, 1);
    write("header.df3", "abc");
    write("empty.df3", "");
    write("short.df3", good.substr(0, 20));
    write("long.df3", good + "abc");
    write("three_bytes.df3", header(2, 2, 2) + std::string(24, 'x'));
    write("huge.df3", header(65535, 65535, 65535) + "abc");
    for (const char* name : {"header", "empty", "short", "long", "three_bytes", "huge", "missing"}) {
        try {
            pattern_of(statement(fmt::format("{}.df3", name), ""));
            ADD_FAILURE() << name;
        } catch (const SceneError& error) {
            EXPECT_NE(error.diagnostic().where.begin, error.diagnostic().where.end) << name;
        }
    }
    write("no_samples.df3", header(0, 4, 2));
    EXPECT_EQ(value("no_samples.df3", "interpolate 2", places[0]), 0.0);
}

}  // namespace
}  // namespace rb
