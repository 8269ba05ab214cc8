// Long lists are read in one go; the slow way must give the same blocks.
#include "reading.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace rb {
namespace {

std::string blocks(const std::string& text, bool runs) {
    LoadOptions options;
    options.input_file = "scene.pov";
    options.input_text = text;
    options.number_runs = runs;
    SourceMap sources;
    Diagnostics diagnostics;
    return dump_blocks(options, sources, diagnostics);
}

std::string list(int count, std::string_view separator, int terms) {
    std::string out;
    for (int i = 0; i < count; ++i) {
        out += i ? separator : "";
        out += fmt::format("<{}, {}.5e-1", i, -i);
        for (int k = 2; k < terms; ++k) out += fmt::format(",+{}", i + k);
        out += " >";
    }
    return out;
}

TEST(List, FastAndSlowAgree) {
    for (const std::string_view separator : {",", " , ", "\n", ", /* note */ "}) {
        for (const int terms : {2, 3, 5}) {
            const std::string values = list(40, separator, terms);
            const std::string text = "union { sphere { 0, 1 dtag \"x\" } mesh2 { vertex_vectors { 40, " +
                                     values + " } face_indices { 40, " + values + ", <1,2,3> * 2 } } }";
            EXPECT_EQ(blocks(text, true), blocks(text, false)) << separator << terms;
        }
    }
}

TEST(List, WorksOutsideBlocksToo) {
    const std::string values = list(20, ", ", 3);
    const auto found = values_of("#declare A = array[21] { <0,0,0>, " + values + " }", "A[20].x;A[1].z");
    ASSERT_EQ(found.size(), 2u);
    EXPECT_EQ(found[0], 19);
    EXPECT_EQ(found[1], 2);
    EXPECT_EQ(
        values_of("#macro M(A,B,C,D,E,F,G,H,I,J) J.x #end #declare R = M(<0,0,0>," + list(9, ",", 3) + ");",
                  "R")
            .at(0),
        8);
}

}  // namespace
}  // namespace rb
