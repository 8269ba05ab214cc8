// renderboy check; file names as other systems write them; where a scene may write.
#include "app/commands.h"
#include "app/create_ini.h"
#include "app/write_access.h"
#include "language/load.h"

#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

namespace rb {
namespace {

namespace fs = std::filesystem;

/// Works in a folder of its own, with a small library folder `lib`.
class Check : public testing::Test {
protected:
    void SetUp() override {
        before_ = fs::current_path();
        folder_ = fs::path(testing::TempDir()) / "rb_check";
        fs::remove_all(folder_);
        fs::create_directories(folder_ / "lib/Pics");
        fs::current_path(folder_);
        write("lib/Shades.INC", "#declare Shade = 0.5;\n");
        fs::copy_file(fs::path(RB_SOURCE_DIR) / "scenes/textures/swatch.png", "lib/Pics/Wood.PNG");
        write("empty.ini", "");
        setenv("POVINI", "empty.ini", 1);
    }
    void TearDown() override {
        fs::current_path(before_);
        fs::remove_all(folder_);
    }

    static void write(const std::string& name, const std::string& text) { std::ofstream(name) << text; }
    static std::string scene(const std::string& text) {
        return "#version 3.7; global_settings { assumed_gamma 1 }\n" + text;
    }

    struct Outcome {
        int code;
        std::string out;
        std::string err;
    };
    static Outcome run_words(const std::vector<std::string>& words) {
        testing::internal::CaptureStdout();
        testing::internal::CaptureStderr();
        const int code = run(words);
        const std::string out = testing::internal::GetCapturedStdout();
        return {code, out, testing::internal::GetCapturedStderr()};
    }
    static Outcome check(const std::string& text, std::vector<std::string> more = {}) {
        write("scene.pov", scene(text));
        more.insert(more.begin(), {"check", "scene.pov", "+Llib"});
        return run_words(more);
    }
    static bool has(const std::string& text, const std::string& part) {
        return text.find(part) != std::string::npos;
    }

    fs::path folder_, before_;
};

TEST_F(Check, NothingMissing) {
    const Outcome done = check("sphere { 0, 1 }");
    EXPECT_EQ(done.code, 0) << done.err;
    EXPECT_EQ(done.out, "");
    EXPECT_FALSE(fs::exists("scene.png"));
}

TEST_F(Check, ListsWhatIsMissing) {
    const std::string ball = "sphere { 0, 1 finish { subsurface { anisotropy 1 } } }\n";
    const Outcome done = check(ball + "global_settings { subsurface { radiosity on } }\n" + ball);
    EXPECT_EQ(done.code, 1);
    EXPECT_TRUE(
        has(done.out, "scene.pov:2:37: anisotropy: light is scattered in all directions alike (2 places)\n"))
        << done.out;
    EXPECT_TRUE(has(done.out, "scene.pov:3:32: radiosity of subsurface: lights alone shine into bodies\n"))
        << done.out;
    EXPECT_FALSE(has(done.err, "subsurface")) << done.err;
}

TEST_F(Check, ErrorsAreShown) {
    const Outcome done = check("sphere { 0, foo }");
    EXPECT_EQ(done.code, 1);
    EXPECT_TRUE(has(done.err, "scene.pov:2:13: error:")) << done.err;
}

TEST_F(Check, ListsFiles) {
    write("first.inc", "#include \"Shades.INC\"\n");
    write("data.txt", "1, 2");
    write("set.ini", "Width=10\n");
    const Outcome done = check(
        "#include \"first.inc\" #include \"first.inc\" #fopen F \"data.txt\" read #read (F, A) #fclose F\n"
        "sphere { 0, 1 pigment { image_map { png \"lib/Pics/Wood.PNG\" } } }",
        {"set.ini", "--deps"});
    EXPECT_EQ(done.code, 0) << done.err;
    EXPECT_EQ(done.out,
              "empty.ini\nset.ini\nscene.pov\nfirst.inc\nlib/Shades.INC\ndata.txt\nlib/Pics/Wood.PNG\n");
}

TEST_F(Check, FileNamesOfOtherSystems) {
    struct Case {
        const char* statement;
        const char* found;
    };
    const Case cases[] = {
        {"#include \"shades.inc\"", "lib/Shades.INC"},
        {"#include \"SHADES\"", "lib/Shades.INC"},
        {"#include \"LIB\\shades.inc\"", "lib/Shades.INC"},
        {"#include \"C:\\povray\\include\\shades.inc\"", "lib/Shades.INC"},
        {"#include \"/usr/nosuch/shades.inc\"", "lib/Shades.INC"},
        {"plane { y, -9 pigment { image_map { png \"PICS\\wood.png\" } } }", "lib/Pics/Wood.PNG"},
        {"plane { y, -9 pigment { image_map { png \"D:\\lib\\other\\wood.png\" } } }", ""},
    };
    for (const Case& c : cases) {
        const Outcome done = check(std::string(c.statement) + "\nsphere { 0, 1 }");
        const bool found = *c.found;
        EXPECT_EQ(has(done.err, "error:"), !found) << c.statement << "\n" << done.err;
        if (found) {
            EXPECT_TRUE(has(done.err, std::string("'") + c.found + "' is used instead")) << done.err;
        }
        EXPECT_TRUE(has(done.err, "scene.pov:2:")) << done.err;
        EXPECT_TRUE(has(check(std::string(c.statement), {"--strict"}).err, "error: Cannot open"))
            << c.statement;
    }
}

TEST_F(Check, AskingForAFileIsExact) {
    EXPECT_EQ(check("#if (file_exists(\"shades.inc\")) #error \"there\" #end sphere { 0, 1 }").code, 0);
    EXPECT_EQ(check("#if (!file_exists(\"Shades.INC\")) #error \"not there\" #end sphere { 0, 1 }").code, 0);
}

TEST_F(Check, MissingFilesNameEveryPlace) {
    for (const char* statement : {"#include \"nosuch.inc\"", "#fopen F \"nosuch.inc\" read",
                                  "sphere { 0, 1 pigment { image_map { png \"nosuch.inc\" } } }"}) {
        const Outcome done = check(statement);
        EXPECT_EQ(done.code, 1);
        EXPECT_TRUE(has(done.err, "nosuch.inc")) << done.err;
        EXPECT_TRUE(has(done.err, "in the current directory, 'lib'")) << done.err;
        EXPECT_TRUE(has(done.err, "Possible Parse Error: Cannot find file 'nosuch.inc'")) << done.err;
    }
}

TEST_F(Check, SemicolonsByVersion) {
    const auto outcome = [](const std::string& text, std::vector<std::string> words) {
        write("old.pov", text);
        words.insert(words.begin(), {"check", "+Iold.pov"});
        return run_words(words);
    };
    const std::string rest = " #declare A = 1\nsphere { 0, A }";
    EXPECT_FALSE(has(outcome("#version 3.0;" + rest, {}).err, "semi-colon"));
    EXPECT_TRUE(has(outcome("#version 3.1;" + rest, {"--strict"}).err, "warning: All #declares"));
    EXPECT_TRUE(has(outcome("#version 3.7;" + rest, {"--strict"}).err, "error: All #declares"));
    EXPECT_TRUE(has(outcome("#version 3.7;" + rest, {}).err, "old.pov:1:29: warning: All #declares"));
    EXPECT_EQ(outcome("#version 3.7;" + rest, {}).code, 0);
    EXPECT_EQ(outcome("#version 3.7; #declare A = 1 // one\nsphere { 0, A }", {}).code, 0);
    EXPECT_TRUE(has(outcome("#version 3.7; #declare A = 1 sphere { 0, A }", {}).err, "error: All #declares"));
}

// Declared strings have their name before a macro that follows is called.
TEST_F(Check, MacroBehindAText) {
    const Outcome done = check(
        "#macro M(S) #debug S #end #declare A = \"one\" M(A) #declare B = concat(\"t\", \"wo\") M(B)\nsphere "
        "{ 0, 1 }");
    EXPECT_EQ(done.code, 0) << done.err;
}

TEST_F(Check, RadiosityImportanceIsRead) {
    EXPECT_EQ(
        check("#default { radiosity { importance 0.5 } } sphere { 0, 1 radiosity { importance 0.3 } }").code,
        0);
    EXPECT_EQ(check("sphere { 0, 1 radiosity { importance 2 } }").code, 1);
    write("kept.pov", scene("#default { radiosity { importance 0.5 } }\nsphere { 0, 1 }"));
    EXPECT_TRUE(has(run_words({"kept.pov", "--dump", "scene"}).out, "radiosity importance 0.5"));
}

TEST_F(Check, WhereASceneMayWrite) {
    Settings settings;
    settings.input_file = "scene.pov";
    setenv("TMPDIR", "/var/tmp", 1);
    fs::create_directories("below");
    const WriteAccess access(settings);
    EXPECT_TRUE(access.allows("a.txt"));
    EXPECT_TRUE(access.allows("below/a.txt"));
    EXPECT_TRUE(access.allows("/tmp/a.txt"));
    EXPECT_FALSE(access.allows("/a.txt"));
    EXPECT_FALSE(access.allows("/tmpx/a.txt"));
    EXPECT_FALSE(access.allows("/tmp/../a.txt"));
    fs::create_directory_symlink("/usr", "link");
    EXPECT_FALSE(access.allows("link/a.txt"));
    settings.output_file = "/srv/pictures/x.png";
    EXPECT_TRUE(WriteAccess(settings).allows("/srv/pictures/a.txt"));
    settings.output_to_file = false;
    EXPECT_FALSE(WriteAccess(settings).allows("/srv/pictures/a.txt"));
    settings.allow_write = {"/srv"};
    EXPECT_TRUE(WriteAccess(settings).allows("/srv/pictures/a.txt"));
}

TEST_F(Check, WritingElsewhereIsAnError) {
    for (const char* mode : {"write", "append"}) {
        const std::string text = std::string("#fopen F \"/proc/nosuch/x\" ") + mode + "\nsphere { 0, 1 }";
        EXPECT_TRUE(has(check(text).err, "error: Writing to /proc/nosuch/x is not allowed"));
        EXPECT_TRUE(has(check(text, {"--allow-write", "/proc"}).err, "error: Cannot open user file"));
    }
    EXPECT_EQ(check("#fopen F \"made.txt\" write #write (F, 1) #fclose F sphere { 0, 1 }").code, 0);
    EXPECT_TRUE(fs::exists("made.txt"));
}

TEST_F(Check, CreateIniRepeatsTheRun) {
    write("scene.pov", scene("sphere { 0, 1 }"));
    const std::vector<std::string> words{"scene.pov", "+W16",  "+H12",    "+Llib",         "Declare=A=1",
                                         "+UA",       "+A0.5", "+Oq.png", "+GIrepeat.ini", "-V"};
    EXPECT_EQ(run_words(words).code, 0);
    std::ifstream in("repeat.ini");
    const std::string text{std::istreambuf_iterator<char>(in), {}};
    for (const char* line :
         {"Width=16\n", "Input_File_Name=scene.pov\n", "Library_Path=lib\n", "Declare=A=1\n",
          "Output_Alpha=on\n", "Antialias=on\n", "Antialias_Threshold=0.5\n"}) {
        EXPECT_TRUE(has(text, line)) << line << text;
    }
    const CommandLine again = parse_command_line({"repeat.ini"});
    EXPECT_EQ(again.settings.width, 16);
    EXPECT_TRUE(again.settings.alpha);
    EXPECT_TRUE(again.settings.antialias);
    EXPECT_EQ(again.settings.library_paths, std::vector<std::string>{"lib"});
}

}  // namespace
}  // namespace rb
