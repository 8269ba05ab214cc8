// What is read without the grammar must be what the grammar reads: same blocks, same scene, same messages.
#include "reading.h"

#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace rb {
namespace {

namespace fs = std::filesystem;

std::string all_of(const LoadOptions& options) {
    Reading reading = read_scene(*options.input_text, options);
    SourceMap sources;
    Diagnostics diagnostics;
    const std::string tokens = dump_tokens(options, sources, diagnostics);
    return tokens + dump_blocks(options, sources, diagnostics) + dump(reading.scene) + reading.debug +
           reading.report;
}

void expect_same(LoadOptions options, const std::string& text) {
    options.input_text = text;
    options.max_tokens = 1000000;
    options.quick_expressions = true;
    const std::string quick = all_of(options);
    options.quick_expressions = false;
    EXPECT_EQ(quick, all_of(options)) << text.substr(0, 2000);
}

void expect_same(const std::string& text) {
    LoadOptions options;
    options.input_file = "scene.pov";
    expect_same(options, text);
}

TEST(Quick, ReadsScenesAsTheGrammarDoes) {
    int count = 0;
    for (const char* folder : {"scenes", "tests/language"}) {
        for (const auto& entry : fs::recursive_directory_iterator(fs::path(RB_SOURCE_DIR) / folder)) {
            if (entry.path().extension() != ".pov") continue;
            std::ifstream in(entry.path(), std::ios::binary);
            std::stringstream text;
            text << in.rdbuf();
            LoadOptions options;
            options.input_file = entry.path().filename().string();
            options.library_paths = {entry.path().parent_path().string()};
            expect_same(options, text.str());
            ++count;
        }
    }
    EXPECT_GT(count, 50);
}

TEST(Quick, LeavesToTheGrammarWhatIsNotPlain) {
    constexpr const char* texts[] = {
        "#declare A = 1 #declare B = 2;",
        "#declare A = 1 + #declare B = 2; B; sphere { 0, A }",
        "#macro M() + 2 #end #declare A = 1 M(); sphere { A, A }",
        "#macro M() 2 * #end sphere { M() 3, 1 }",
        "#macro M(A) #declare A = A + 1; A #end #declare X = 1; sphere { M(X), M(X) * X }",
        "#macro M(A) #declare A = 5; #end #declare X = 1; M(X) M(+X) M((X)) M(-X) sphere { X, 1 }",
        "#macro M(A) #declare A = 5; #end #declare X = array[2] { 1, 2 } M(X[0]) M(X[1]) sphere { X[0], X[1] "
        "}",
        "#macro M(A, B) sphere { A, B } #end M(0) M(0, 1, 2) M(0 1) M(0, 1,) M(, 1) M(U, 1) M(0, \"a\")",
        "#declare A = 1 / 0; #declare B = <1, 2> / <0, 0>; sphere { A, 1 }",
        "#declare A = sqrt(-1); #declare B = ln(0); #declare C = asin(2); sphere { C, 1 }",
        "#declare A = <1, 2, 3> > 2; #declare B = 1 < 2; #declare C = (1 < 2) + (3 = 3); sphere { B, C }",
        "#declare R = seed(3); #declare A = rand(R) + rand(R); #declare B = rand(R) + strlen(\"a\"); sphere "
        "{ A, B }",
        "#declare R = seed(3); sphere { rand(R), rand(R) #if (rand(R) > 0.5) scale 2 #end translate rand(R) "
        "}",
        "#declare R = seed(3); sphere { <rand(R), rand(R) U>, 1 } sphere { rand(R), 1 }",
        "#declare A = array[2][2] { { 1, 2 }, { 3, 4 } } sphere { A[1][0], A[0][1] } sphere { A[2][0], 1 } "
        "A[0]",
        "#declare A = array[2] sphere { A[1], 1 } sphere { A[-1], 1 } sphere { A[0.5], 1 }",
        "#declare A = <1, 2, 3>; sphere { A.y + A.x * A.z, A.gray } sphere { A.t, 1 } sphere { A.foo, 1 }",
        "#declare A = <1, 2> + <1, 2, 3>; #declare B = -<1, 2> * <1, 2, 3>; #declare C = !<0, 1>; sphere { "
        "B, C.x }",
        "sphere { (1 + 1 + 1 + 1 + 1 + 1 + 1 + 1 + 1 + 1 + 1 + <1, 2, 3, 4, 5>), 1 } sphere { -(1 + 1 + 1 + "
        "1 + 1 + "
        "1 + 1 + 1 + 1 + 1 + 1 + <1, 2, 3, 4, 5>) foo }",
        "#declare A = array[2] { 1, 2 } sphere { A[1 + 1 + 1 + 1 + 1 + 1 + 1 + 1 + 1 - 8] * <1, 2, 3, 4, 5>, "
        "1 }",
        "difference { box { 0, 1 rotate y * 3 } sphere { 0, 1 scale <1, 1 + 3 / 200, 1> } translate <3 * 2 - "
        "11 + "
        "0.01 * 3, -A, V.x> }",
        "sphere { 0, 1 #if (1) pigment { rgb 1 #if (1) } #end } sphere { 0, 1 pigment { rgb <1, 2, 3> } "
        "finish { "
        "ambient #if (1) 1 } #end } union { sphere { 0 1 } box { 0, 1 } #macro M() } #end M()",
        "#macro M(A, optional B) #ifdef (B) sphere { A, B } #else sphere { A, 1 } #end #end M(1) M(1,) M(1, "
        "2) M(,)",
        "#declare A = +1; #declare B = + +A; #declare C = +-1; sphere { A, B }",
        "#declare A = <1>; #declare B = <1, 2, 3, 4, 5, 6>; sphere { 0, 1 }",
        "#declare A = (1 ? 2 : 3) + (0 ? <1, 2> : 4); #declare B = <1, 2> ? 1 : 2; sphere { A, 1 }",
        "#declare A = vlength(<3, 4, 0>) + vdot(x, 2) + max(1, 2, 3); #declare B = vnormalize(0); sphere { "
        "A, 1 }",
        "#declare A = mod(7 3) + pow(2, 3) + atan2(0, 0); #declare B = pow(2); #declare C = abs(1, 2); "
        "sphere { A, 1 }",
        "#declare deprecated A = 1; sphere { A, 1 }",
        "#declare A = 1;; sphere { A, 1 } #declare B = 2 sphere { B, 1 }",
        "#version 3.1; #declare A = 1 sphere { A, 1 }",
        "#for (I, 1, 3) sphere { I, 1 } #end #for (I 3 1 -1) sphere { I, 1 } #end #for (I, 1, 2,) #end #for "
        "(I, 1) #end",
        "#switch (2) 1 + 1 #case (2) sphere { 0, 1 } #end",
        "#while (rand(0)) #end #if (<1, 2>) #end #if (1 sphere { 0, 1 } #end",
        "sphere { 0, 1 pigment { rgb <1, 0, 0> transmit 0.5 } } sphere { 0, 1 pigment { color red 1 green "
        "0.5 } }",
        "sphere { 0, 1 pigment { rgb <1, 0, 0> filter 0.5 + 0.1 } } sphere { 0, 1 pigment { color rgbt 1 } }",
        "sphere { 0, 1 pigment { color <1, 2, 3> * 0.1 } } sphere { 0, 1 pigment { rgb 1 rotate 2 } finish { "
        "phong } }",
        "sphere { 0, 1 pigment { rgb <1, 0, 0> < 2 } } sphere { 0, 1 pigment { rgb \"a\" } } sphere { 0, 1 "
        "pigment { rgb } }",
        "sphere { 0, 1 translate x rotate scale 2 } sphere { 0 1 foo } sphere { 0, 1 hollow 1 inverse "
        "no_shadow }",
        "sphere { 0, 1, } sphere { 0, 1 ] } sphere { 0, 1 ) } sphere { 0, 1",
        "union { sphere { 0, 1 } #local A = 2; sphere { A, 1 }, box { 0, A } translate A * x }",
        "mesh { triangle { x, y, z } triangle { x, y, 2 * z } } polygon { 4, <0, 0>, <0, 1>, <1, 1>, <0, 0> "
        "}",
        "#declare P = pigment { gradient x color_map { [0 rgb 1] [0.5, 1 color rgb 0 color rgb 1] } }",
        "#declare F = function(x) { x * 2 } #declare S = spline { 0, x 1, y } sphere { S(0.5), F(2) + F(1) }",
    };
    for (const char* text : texts) expect_same(text);
}

/// Expressions of random tokens, most of them wrong somewhere.
TEST(Quick, ReadsAnyExpressionAsTheGrammarDoes) {
    constexpr const char* parts[] = {"1",
                                     "2.5",
                                     "0",
                                     "x",
                                     "y",
                                     "pi",
                                     "A",
                                     "V",
                                     "B[1]",
                                     "B",
                                     "+",
                                     "-",
                                     "*",
                                     "/",
                                     "(",
                                     ")",
                                     "<",
                                     ">",
                                     ",",
                                     ".y",
                                     "!",
                                     "<=",
                                     "=",
                                     "&",
                                     "|",
                                     "?",
                                     ":",
                                     "sqrt(",
                                     "max(",
                                     "mod(",
                                     "vdot(",
                                     "T",
                                     "M()",
                                     "<1,",
                                     "2,3>)",
                                     "<1,2>",
                                     "sin(1)",
                                     "U",
                                     "rand(R)",
                                     "[1]",
                                     "#local A = 2;",
                                     "\"s\""};
    constexpr const char* contexts[] = {"#declare Q = {};",
                                        "sphere {{ {}, 1 }}",
                                        "#if ({}) sphere {{ 0, 1 }} #end",
                                        "N({}, 2)",
                                        "#for (I, {}, 2) #end",
                                        "box {{ 0, 1 scale {} rotate x }}",
                                        "sphere {{ 0, 1 pigment {{ rgb {} }} }}",
                                        "#declare B[{}] = 1;"};
    std::mt19937 random(11);
    const auto pick = [&](size_t n) { return static_cast<size_t>(random() % n); };
    for (int i = 0; i < 3000; ++i) {
        std::string expression;
        for (size_t n = 1 + pick(8); n > 0; --n)
            expression += std::string(parts[pick(std::size(parts))]) + " ";
        const std::string use = fmt::format(fmt::runtime(contexts[pick(std::size(contexts))]), expression);
        expect_same(
            "#version 3.7; #declare A = 3; #declare V = <1, 2, 3>; #declare B = array[2] { 4, 5 } "
            "#declare R = seed(1); #declare T = \"t\"; #macro M() 7 #end "
            "#macro N(P, Q) sphere { P, Q } #declare P = 8; #end " +
            use + " sphere { A, rand(R) }");
        if (HasFailure()) return;
    }
}

}  // namespace
}  // namespace rb
