// Messages (language spec 24, 26.6) and what bad input must not do.
#include "reading.h"

#include <random>

#include <gtest/gtest.h>

namespace rb {
namespace {

TEST(Warning, BlackHolesMustFitTheirBlocks) {
    const auto warnings = [](const std::string& repeat) {
        const std::string hole = "warp { black_hole 0.5, 0.7 repeat " + repeat + " turbulence 0.3 }";
        return read_scene("#version 3.7; global_settings { assumed_gamma 1 } sphere { 0, 1 pigment { bozo " +
                          hole + " } }")
            .warnings;
    };
    EXPECT_TRUE(warnings("x * 1.8").empty());
    ASSERT_EQ(warnings("y * 1.5").size(), 1u);
    EXPECT_EQ(warnings("y * 1.5").front(), "Black Hole repeat vector Y too small; increased to 1.7.");
}

TEST(Error, WordsOfTheReference) {
    EXPECT_EQ(first_error("box{0,1 foo}"),
              "No matching } in 'box', undeclared identifier 'foo' found instead");
    EXPECT_EQ(first_error("#declare A=sphere{0,1} #declare B=A union{A B}"),
              "No matching } in 'union', object identifier found instead");
    EXPECT_EQ(first_error("sphere{0 1 no_shadow on}"),
              "No matching } in 'sphere', float function 'on' found instead");
    EXPECT_EQ(first_error("sphere{0,1 sturm}"), "Keyword 'sturm' cannot be used with this object.");
    EXPECT_EQ(first_error("sphere{<1,2,3,4>,1}"), "Vector expected but color expression found.");
    EXPECT_EQ(first_error("sphere{0,<1,2>}"), "Float expected but vector or color expression found.");
    EXPECT_EQ(first_error("#declare X=1<2;").substr(0, 46), "All #declares of float, vector, and color requ");
    EXPECT_EQ(first_error("#declare F=function{x/0}"), "Division by zero.");
    EXPECT_EQ(first_error("sphere{0,1 pigment{bozo color_map{[0 rgb 0][1 <1,1,1>]}}}"),
              "Expected 'color', < found instead");
    EXPECT_EQ(first_error("light_source{0 rgb 1 radius 5 spotlight}"),
              "Keyword 'radius' cannot be used with standard light source.");
    EXPECT_EQ(first_error("#declare F=fog{distance 1} F"),
              "Expected 'object or directive', fog identifier found instead");
    EXPECT_EQ(first_error("sphere 1"),
              "Missing { after 'sphere', float function 'float constant' found instead");
    EXPECT_EQ(first_error("pigment{rgb 1}"), "Expected 'object or directive', pigment found instead");
    EXPECT_EQ(first_error("#include \"nowhere.inc\""), "Cannot open include file nowhere.inc.");
    EXPECT_EQ(first_error("#error \"stop\""), "Parse halted by #error directive: stop");
    EXPECT_EQ(read_scene("#version 3.7; #declare C=srgb .5; sphere{0,1}").errors.at(0).substr(3),
              "Cannot parse sRGB colors before assumed_gamma has been set.");
}

TEST(Error, Hints) {
    EXPECT_NE(first_error("shpere{0,1}").find("did you mean 'sphere'"), std::string::npos);
    EXPECT_NE(first_error("#declare Radius=1; sphere{0, Radus}").find("did you mean 'Radius'"),
              std::string::npos);
}

TEST(Error, GoesOnBehindTheStatement) {
    const Reading reading = read_probe(
        "sphere { 0, 1\n foo }\n"
        "box { 0, 1 }\n"
        "#declare T = texture { pigment { bzo } }\n"
        "sphere { 0, 1 texture { T } }\n"
        "union { sphere { 0, 1 } box { 0 } }\n"
        "cylinder { 0, y }\n");
    ASSERT_EQ(reading.errors.size(), 4u) << reading.report;
    EXPECT_EQ(reading.errors[0].substr(0, 2), "2:");
    EXPECT_EQ(reading.errors[1].substr(0, 2), "4:");
    EXPECT_EQ(reading.errors[2].substr(0, 2), "6:");
    EXPECT_EQ(reading.errors[3].substr(0, 2), "7:");
}

TEST(Error, MacrosAndIncludesAreNamed) {
    const Reading reading = read_probe(
        "#macro Inner(R) sphere { 0, R nonsense } #end\n"
        "#macro Outer(R) Inner(R) #end\n"
        "Outer(1)");
    EXPECT_NE(reading.report.find("in the expansion of macro 'Inner'"), std::string::npos) << reading.report;
    EXPECT_NE(reading.report.find("in the expansion of macro 'Outer'"), std::string::npos);
}

TEST(Error, NotMoreThanTwenty) {
    std::string text;
    for (int i = 0; i < 100; ++i) text += "sphere { 0, 1 nonsense" + std::to_string(i) + " }\n";
    EXPECT_EQ(read_probe(text).errors.size(), 20u);
}

TEST(Robust, DeepNesting) {
    for (const std::string open :
         {"(", "<", "abs(", "-", "!", "array[1]{", "function{", "{", "union{", "pigment{"}) {
        std::string text = "#declare A = ";
        for (int i = 0; i < 100000; ++i) text += open;
        EXPECT_FALSE(read_probe(text).done) << open;
        text = "union { ";
        for (int i = 0; i < 100000; ++i) text += open;
        EXPECT_FALSE(read_probe(text).done) << open;
    }
    std::string text;
    for (int i = 0; i < 10000; ++i) text += "#if (1) ";
    EXPECT_FALSE(read_probe(text).done);
    text.clear();
    for (int i = 0; i < 10000; ++i) text += "#if (0 #if (";
    EXPECT_FALSE(read_probe(text).done);
}

TEST(Robust, CutAnywhere) {
    const std::string scene =
        "#version 3.7; global_settings { assumed_gamma 1 } #macro M(A,B) sphere { A, B pigment { checker rgb "
        "1, rgb 0 } }"
        "#end camera { location -z*5 look_at 0 } #declare F = function(a,b) { a*b + sum(i,1,3,i) }"
        "#for (I,1,3) M(<I,0,0>, 0.5) #end #declare A = array[2]{1,2} #switch (A[0]) #case (1) box { 0, 1 } "
        "#break #end"
        " union { object { sphere { 0, 1 } scale 2 } cone { 0, 1, y, 0 open } } #debug concat(\"a\", "
        "str(F(1,2),0,3))"
        " text { ttf \"f.ttf\" \"hi\" 1, 0 } isosurface { function { x } contained_by { box { -1, 1 } } }";
    for (size_t end = 0; end < scene.size(); ++end) read_scene(scene.substr(0, end));
    std::mt19937 random(7);
    for (int i = 0; i < 2000; ++i) {
        std::string broken = scene;
        for (int k = 0; k < 3; ++k) {
            const size_t at = random() % broken.size();
            constexpr std::string_view signs = "{}()<>[]#;,\"xA1.";
            broken[at] = signs[random() % signs.size()];
        }
        LoadOptions options;
        options.max_tokens = 100000;
        read_scene(broken, options);
    }
}

}  // namespace
}  // namespace rb
