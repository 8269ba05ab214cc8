// What #version, the command line's version and assumed_gamma decide (language spec 6).
#include "reading.h"

#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

namespace rb {
namespace {

struct Header {
    const char* text;
    int effective;
    bool gamma;
};

TEST(VersionTable, GammaHandling) {
    // An include that executes #version counts for the whole scene.
    const std::string include = std::string(RB_BINARY_DIR) + "/version_test.inc";
    std::ofstream(include) << "#declare Former = version; #version 3.5; #version Former;\n";
    const std::string included = "#include \"" + include + "\"";
    for (const Header& h : {Header{"", 362, false},
                            {"#version 3.7;", 370, true},
                            {"#version 3.6;", 360, false},
                            {"#version 3.7; global_settings { assumed_gamma 1 }", 370, true},
                            {"#version 3.6; global_settings { assumed_gamma 1 }", 360, true},
                            {"global_settings { assumed_gamma 2.2 }", 362, true},
                            {"#version 3.7; #version 3.5;", 350, false},
                            {"#version 3.5; #version 3.7;", 370, true},
                            {"#version 3.1; #declare A = 1", 310, false},
                            {included.c_str(), 370, true}}) {
        const Reading reading = read_scene(std::string(h.text) + " sphere { 0, 1 }");
        ASSERT_TRUE(reading.done) << h.text << "\n" << reading.report;
        EXPECT_EQ(reading.scene.effective_version, h.effective) << h.text;
        EXPECT_EQ(reading.scene.has_gamma_handling(), h.gamma) << h.text;
    }
}

TEST(VersionTable, CommandLineCountsAsDirective) {
    LoadOptions options;
    options.version = 3.7;
    EXPECT_EQ(read_scene("sphere { 0, 1 }", options).scene.effective_version, 370);
    options.version = 3.1;
    const Reading old = read_scene("#declare A = 1 sphere { 0, A }", options);
    EXPECT_TRUE(old.done) << old.report;
    EXPECT_EQ(old.scene.language_version, 350);  // raised at the end
}

TEST(VersionTable, FirstAssumedGammaStays) {
    const Reading twice = read_scene(
        "#version 3.7; global_settings { assumed_gamma 1 } global_settings { assumed_gamma 2.2 } sphere { 0, "
        "1 }");
    ASSERT_TRUE(twice.done) << twice.report;
    EXPECT_EQ(std::get<double>(*twice.scene.settings.assumed_gamma), 1.0);
    EXPECT_FALSE(twice.warnings.empty());
}

TEST(VersionTable, BackgroundTransmit) {
    const auto transmit = [](const std::string& header) {
        return read_scene(header + " background { rgbt <1, 1, 1, .75> } sphere { 0, 1 }")
            .scene.background->transmit;
    };
    EXPECT_FLOAT_EQ(transmit("#version 3.7; global_settings { assumed_gamma 1 }"), 0.75f);
    EXPECT_FLOAT_EQ(transmit("#version 3.6; global_settings { assumed_gamma 1 }"), 0.0f);
    EXPECT_FLOAT_EQ(transmit(""), 0.0f);
}

TEST(VersionTable, NoiseGenerator) {
    const auto generator = [](const std::string& header) {
        return read_scene(header + " sphere { 0, 1 }").scene.settings.noise_generator;
    };
    EXPECT_EQ(generator(""), 2);
    EXPECT_EQ(generator("#version 3.1;"), 1);
    EXPECT_EQ(generator("#version 3.5;"), 2);
    EXPECT_EQ(generator("#version 3.1; #version 3.7;"), 2);
    EXPECT_EQ(generator("global_settings { noise_generator 3 } #version 3.1;"), 3);
}

}  // namespace
}  // namespace rb
