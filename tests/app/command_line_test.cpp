#include "app/command_line.h"

#include "app/animation.h"
#include "app/ini_options.h"

#include <cmath>
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

namespace rb {
namespace {

Settings parse(std::vector<std::string> words) {
    // An empty INI file, so that none of this machine counts.
    const auto empty = std::filesystem::path(testing::TempDir()) / "empty.ini";
    std::ofstream{empty};
    setenv("POVINI", empty.c_str(), 1);
    setenv("HOME", "/nonexistent", 1);
    return parse_command_line(words).settings;
}

TEST(CommandLine, PovSwitches) {
    const Settings s = parse({"+Ia.pov", "+Oout.png", "+W640", "-H480", "+A0.1", "+AM2", "+R4", "+J0.5",
                              "+Q11", "-D", "+P", "-V", "+FN16", "+UA", "+L/x", "+WT3", "+SC0.5", "+ER20"});
    EXPECT_EQ(s.input_file, "a.pov");
    EXPECT_EQ(s.output_file, "out.png");
    EXPECT_EQ(s.width, 640);
    EXPECT_EQ(s.height, 480);
    EXPECT_TRUE(s.antialias);
    EXPECT_DOUBLE_EQ(s.antialias_options.threshold, 0.1);
    EXPECT_EQ(s.antialias_options.method, 2);
    EXPECT_EQ(s.antialias_options.depth, 4);
    EXPECT_DOUBLE_EQ(s.jitter_amount, 0.5);
    EXPECT_EQ(s.quality, 9);
    EXPECT_FALSE(s.verbose);
    EXPECT_EQ(s.bits_per_color, 16);
    EXPECT_TRUE(s.alpha);
    EXPECT_EQ(s.library_paths, std::vector<std::string>{"/x"});
    EXPECT_EQ(s.threads, 3);
    EXPECT_EQ(s.start_column, 0.5);
    EXPECT_EQ(s.end_row, 20.0);
}

TEST(CommandLine, PlainAntialiasIsMethodOne) {
    EXPECT_EQ(parse({"a.pov", "+A"}).antialias_options.method, 1);
    EXPECT_FALSE(parse({"a.pov", "+A", "-A"}).antialias);
}

TEST(CommandLine, Dithering) {
    EXPECT_FALSE(parse({"a.pov"}).dither);
    const Settings plain = parse({"a.pov", "+TH"});
    EXPECT_TRUE(plain.dither);
    EXPECT_EQ(plain.dither_method, DitherMethod::floyd_steinberg);
    const Settings named = parse({"a.pov", "Dither_Method=b3", "+TH"});
    EXPECT_TRUE(named.dither);
    EXPECT_EQ(named.dither_method, DitherMethod::bayer3);
    EXPECT_EQ(parse({"a.pov", "+THD1"}).dither_method, DitherMethod::line);
    EXPECT_FALSE(parse({"a.pov", "Dither_Method=B2"}).dither);
    EXPECT_FALSE(parse({"a.pov", "+THB2", "-TH"}).dither);
    EXPECT_THROW(parse({"a.pov", "+THX"}), UsageError);
}

TEST(CommandLine, Instances) {
    EXPECT_EQ(parse({"a.pov"}).instances, InstanceMode::automatic);
    EXPECT_EQ(parse({"a.pov", "--instances", "always"}).instances, InstanceMode::always);
    EXPECT_EQ(parse({"a.pov", "--instances", "never"}).instances, InstanceMode::never);
    EXPECT_THROW(parse({"a.pov", "--instances", "often"}), UsageError);
    EXPECT_THROW(parse({"a.pov", "--instances"}), UsageError);
}

TEST(CommandLine, NoBenchmark) {
    EXPECT_THROW(parse({"-benchmark"}), UsageError);
    EXPECT_THROW(parse({"--benchmark", "+WT2"}), UsageError);
}

// What would change the result and does not work is said; what the reference takes without effect is not.
TEST(CommandLine, OptionsWithoutEffectAreSaid) {
    for (const char* word : {"Create_Histogram=on", "Histogram_Name=h", "Clockless_Animation=on", "+RTR",
                             "Fatal_Console=off", "-UR"}) {
        EXPECT_EQ(parse({"a.pov", word}).without_effect.size(), 1u) << word;
    }
    for (const char* word :
         {"Field_Render=on", "+UO", "Light_Buffer=on", "+UV", "Bounding_Method=2", "BSP_MaxDepth=3",
          "Render_Pattern=2", "Preview_Start_Size=8", "Warning_Level=0", "+X3", "+UR", "Fatal_Console=on",
          "+GP", "Buffer_Size=3", "Histogram_Type=csv", "High_Reproducibility=on", "Display_Gamma=2.2"}) {
        EXPECT_TRUE(parse({"a.pov", word}).without_effect.empty()) << word;
    }
}

TEST(CommandLine, RadiosityFiles) {
    const Settings none = parse({"a.pov"});
    EXPECT_FALSE(none.radiosity_from_file || none.radiosity_to_file);
    EXPECT_EQ(none.radiosity_file, "object.rca");  // as the reference has it
    const Settings words = parse({"a.pov", "+RFmy.rca", "+RFI", "+RFO"});
    EXPECT_EQ(words.radiosity_file, "my.rca");
    EXPECT_TRUE(words.radiosity_from_file && words.radiosity_to_file);
    EXPECT_FALSE(parse({"a.pov", "+RFI", "-RFI"}).radiosity_from_file);
    const Settings names =
        parse({"a.pov", "Radiosity_File_Name=x", "Radiosity_To_File=on", "Radiosity_From_File=off"});
    EXPECT_EQ(names.radiosity_file, "x");
    EXPECT_TRUE(names.radiosity_to_file && !names.radiosity_from_file);
}

TEST(CommandLine, MessageFiles) {
    const Settings s = parse(
        {"a.pov", "All_File=a.txt", "+GDon", "Warning_File=x.txt", "Warning_File=off", "-GFf.txt", "+GP"});
    const auto name = [&](MessageStream stream) { return s.message_files[static_cast<size_t>(stream)]; };
    EXPECT_EQ(name(MessageStream::all), "a.txt");
    EXPECT_EQ(name(MessageStream::debug), "debug.out");
    EXPECT_EQ(name(MessageStream::fatal), "f.txt");
    EXPECT_EQ(name(MessageStream::warning), "");
    EXPECT_TRUE(s.append_files);
}

// The reference refuses these (shading spec 12.1).
TEST(CommandLine, WrongWordsAreErrors) {
    for (const char* word : {"+A.3", "+A1.0", "+Z", "Bogus=1", "+W", "+Wabc", "+FX", "nosuch.txt", "-res"}) {
        EXPECT_THROW(parse({"a.pov", word}), UsageError) << word;
    }
    EXPECT_THROW(parse({}), UsageError);
    EXPECT_THROW(parse({"a.pov", "+W100000", "+H100000"}), UsageError);
    EXPECT_THROW(parse({"a.pov", "+W0"}), UsageError);
}

// Callers pass several switches in one argument, and quotes that reach us.
TEST(CommandLine, ArgumentsAreSplitAndUnquoted) {
    const Settings s = parse({"+Q11 +R3 +A0.1 +J0.5", "+I\"/tmp/some scene.pov\"", "Library_Path='/a b'",
                              "Output_File_Name='x.png'", "Declare=_stereo=0", "Antialias=On", "Jitter=Off"});
    EXPECT_EQ(s.antialias_options.depth, 3);
    EXPECT_EQ(s.input_file, "/tmp/some scene.pov");
    EXPECT_EQ(s.library_paths.back(), "/a b");
    EXPECT_EQ(s.output_file, "x.png");
    ASSERT_EQ(s.declares.size(), 1u);
    EXPECT_EQ(s.declares[0].first, "_stereo");
    EXPECT_FALSE(s.jitter);
}

TEST(CommandLine, LongOptions) {
    const Settings s = parse({"render", "a.pov", "-o", "x.exr", "--size", "320x200", "--threads", "2",
                              "--geometry", "exact", "--stats", "json", "+A0.2", "--no-skip"});
    EXPECT_EQ(s.width, 320);
    EXPECT_EQ(s.height, 200);
    EXPECT_EQ(s.threads, 2);
    EXPECT_EQ(s.file_type, FileType::exr);
    EXPECT_EQ(s.geometry, GeometryMode::exact);
    EXPECT_EQ(s.stats_file, "-");
    EXPECT_FALSE(s.skip_unneeded);
    EXPECT_DOUBLE_EQ(s.antialias_options.threshold, 0.2);
    EXPECT_THROW(parse({"a.pov", "--geometry", "round"}), UsageError);
    EXPECT_THROW(parse({"a.pov", "--bogus"}), UsageError);
}

TEST(CommandLine, Sampling) {
    const Settings plain = parse({"a.pov"});
    EXPECT_EQ(plain.seed, 0u);
    EXPECT_EQ(plain.area_lights, AreaLightMode::as_written);
    EXPECT_FALSE(plain.antialias);
    const Settings s =
        parse({"a.pov", "--error", "0.25%", "--max-samples", "64", "--seed", "7", "--area-light", "true"});
    EXPECT_TRUE(s.antialias);
    EXPECT_EQ(s.antialias_options.method, method_by_error);
    EXPECT_DOUBLE_EQ(s.antialias_options.error, 0.0025);
    EXPECT_EQ(s.antialias_options.max_samples, 64u);
    EXPECT_EQ(s.seed, 7u);
    EXPECT_EQ(s.area_lights, AreaLightMode::true_area);
    EXPECT_DOUBLE_EQ(parse({"a.pov", "--error", "0.01"}).antialias_options.error, 0.01);
    EXPECT_EQ(plain.gi_error, 0.0);
    EXPECT_DOUBLE_EQ(parse({"a.pov", "--gi-error", "0.5%"}).gi_error, 0.005);
    EXPECT_EQ(parse({"a.pov", "+AM3", "+AC0.95"}).antialias_options.method, 3);
    EXPECT_DOUBLE_EQ(parse({"a.pov", "+AM3", "+AC0.95"}).antialias_options.confidence, 0.95);
    for (const char* bad : {"", "%", "x", "0", "-1%", "1%%", "nan", "inf"}) {
        EXPECT_THROW(parse({"a.pov", std::string("--error=") + bad}), UsageError) << bad;
        EXPECT_THROW(parse({"a.pov", std::string("--gi-error=") + bad}), UsageError) << bad;
    }
    EXPECT_THROW(parse({"a.pov", "--max-samples", "0"}), UsageError);
    EXPECT_THROW(parse({"a.pov", "--area-light", "round"}), UsageError);
    EXPECT_THROW(parse({"a.pov", "Antialias_Confidence=1"}), UsageError);
}

TEST(Ini, SectionsCommentsAndSwitches) {
    const auto path = std::filesystem::path(testing::TempDir()) / "settings.ini";
    std::ofstream(path)
        << "; a comment\nWidth =800\nHeight = 600.0 ; another\n-d\nInput_File_Name=\"scene.pov\"\n"
           "[small]\nWidth=80\n+H60\n[other]\nWidth=1\n";
    EXPECT_EQ(parse({path.string()}).width, 800);
    const Settings s = parse({path.string() + "[SMALL]"});
    EXPECT_EQ(s.width, 80);
    EXPECT_EQ(s.height, 60);
    EXPECT_EQ(s.input_file, "scene.pov");
    std::ofstream(path) << "Width=80\nWydth=80\n";
    try {
        parse({path.string()});
        FAIL();
    } catch (const UsageError& error) {
        EXPECT_NE(std::string(error.what()).find(":2: unknown option 'Wydth'"), std::string::npos)
            << error.what();
    }
    std::ofstream(path) << "Include_Ini=" << path.string() << "\n";
    EXPECT_THROW(parse({path.string()}), UsageError);
}

TEST(Output, NamesFollowTheReference) {
    Settings s;
    s.input_file = "dir/scene.pov";
    EXPECT_EQ(output_path(s, ""), "dir/scene.png");
    EXPECT_EQ(output_path(s, "07"), "dir/scene07.png");
    s.output_file = "out/";
    EXPECT_EQ(output_path(s, ""), "out/scene.png");
    s.output_file = "q.png";
    EXPECT_EQ(output_path(s, ""), "q.png");
    EXPECT_EQ(output_path(s, "3"), "q3.png");
    s.output_file = "q.jpg";
    EXPECT_EQ(output_path(s, ""), "q.jpg.png");
    s.output_file = "scene.pov.tga";
    s.file_type = FileType::tga;
    EXPECT_EQ(output_path(s, ""), "scene.pov.tga");
    s.output_file = "-";
    EXPECT_EQ(output_path(s, ""), "-");
}

TEST(Region, FractionsAndPixels) {
    Settings s;
    s.width = s.height = 4;
    s.start_column = 2;
    s.end_column = 3;
    PixelBlock r = region_of(s);
    EXPECT_EQ(r.x0, 1);
    EXPECT_EQ(r.x1, 3);
    s.end_column.reset();
    s.start_column = 0.5;
    r = region_of(s);
    EXPECT_EQ(r.x0, 2);
    EXPECT_EQ(r.x1, 4);
    s.start_column = 5;
    EXPECT_THROW(region_of(s), UsageError);
    s.start_column = 3;
    s.end_column = 2;
    EXPECT_EQ(region_of(s).width(), 0);
}

// Language spec 26.5, measured.
TEST(Animation, FramesAndClocks) {
    const auto clocks = [](std::vector<std::string> words) {
        words.insert(words.begin(), "a.pov");
        std::vector<std::pair<int, double>> out;
        for (const AnimationFrame& f : frames_of(parse(words))) out.emplace_back(f.number, f.clock);
        return out;
    };
    using List = std::vector<std::pair<int, double>>;
    EXPECT_EQ(clocks({"+KFF3"}), (List{{1, 0}, {2, .5}, {3, 1}}));
    EXPECT_EQ(clocks({"+KFI2", "+KFF4", "+KI1", "+KF2"}), (List{{2, 1}, {3, 1.5}, {4, 2}}));
    EXPECT_EQ(clocks({"+KFI1", "+KFF4", "+KF0", "+SF3"}), (List{{3, 0}, {4, 0}}));
    EXPECT_EQ(clocks({"+KFI1", "+KFF4", "+KF0", "+STP2"}), (List{{1, 0}, {3, 0}}));
    EXPECT_EQ(clocks({"+KFI0", "+KFF1"}), (List{{0, 0}, {1, 1}}));
    EXPECT_EQ(clocks({"+KI1", "+KF2"}), (List{{0, 0}}));
    EXPECT_EQ(clocks({"+KFF10", "+SF0.5"}), (List{{5, 4.0f / 9.0f},
                                                  {6, 5.0f / 9.0f},
                                                  {7, 6.0f / 9.0f},
                                                  {8, 7.0f / 9.0f},
                                                  {9, 8.0f / 9.0f},
                                                  {10, 1}}));
    EXPECT_EQ(clocks({"+KFF4", "+EF2", "+KF3"}), (List{{1, 0}, {2, 1}}));
    EXPECT_EQ(clocks({"+KFI0"}), (List{{0, 0}}));
    EXPECT_EQ(clocks({"+KFI1", "+KFF1"}), (List{{0, 0}}));
    EXPECT_EQ(clocks({"+KFI0", "+KFF1", "+KC"}), (List{{0, 0}, {1, .5}}));
    const auto cyclic = frames_of(parse({"a.pov", "+KFI1", "+KFF9", "+KC"}));
    EXPECT_EQ(cyclic.size(), 9u);
    EXPECT_EQ(cyclic.front().digits, 2);
    EXPECT_EQ(cyclic.front().final_frame, 10);
}

// One frame is an animation unless both ends are given as 1, or as 0; its clock is 0/0.
TEST(Animation, OfOneFrame) {
    for (const std::vector<std::string>& words :
         {std::vector<std::string>{"a.pov", "+KFF1"}, {"a.pov", "+KFI1"}, {"a.pov", "+KFI1", "+KFF0"}}) {
        const auto frames = frames_of(parse(words));
        ASSERT_EQ(frames.size(), 1u) << words.back();
        EXPECT_EQ(frames.front().number, 1) << words.back();
        EXPECT_EQ(frames.front().digits, 1) << words.back();
        EXPECT_TRUE(std::isnan(frames.front().clock)) << words.back();
    }
}

}  // namespace
}  // namespace rb
