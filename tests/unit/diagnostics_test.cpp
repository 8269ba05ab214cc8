#include "base/diagnostics.h"

#include <gtest/gtest.h>

namespace rb {
namespace {

TEST(SourceMap, FindsLinesAndColumns) {
    SourceMap sources;
    const uint32_t file = sources.add("a.pov", "one\ntwo\r\nthree\rfour");
    EXPECT_EQ(sources.position(file, 0).line, 1u);
    EXPECT_EQ(sources.position(file, 4).line, 2u);
    EXPECT_EQ(sources.position(file, 6).column, 3u);
    EXPECT_EQ(sources.position(file, 9).line, 3u);
    EXPECT_EQ(sources.position(file, 15).line, 4u);
    EXPECT_EQ(sources.line_at(file, 10), "three");
    EXPECT_EQ(sources.line_at(file, 1000), "four");
}

TEST(Diagnostics, PrintCompilerStyle) {
    SourceMap sources;
    const uint32_t file = sources.add("a.pov", "sphere { 0, 1 foo }\n");
    const Diagnostic d{Severity::error,
                       {file, 14, 17},
                       "unexpected 'foo'",
                       {{Severity::note, {}, "did you mean 'hollow'?", {}}}};
    EXPECT_EQ(format(d, sources),
              "a.pov:1:15: error: unexpected 'foo'\n"
              "    1 | sphere { 0, 1 foo }\n"
              "      |               ^~~\n"
              "note: did you mean 'hollow'?\n");
}

TEST(Diagnostics, LongLinesAreCut) {
    SourceMap sources;
    const uint32_t file = sources.add("a.pov", std::string(100000, 'x'));
    EXPECT_LT(format({Severity::error, {file, 50000, 50001}, "m", {}}, sources).size(), 500u);
}

TEST(Diagnostics, UnsupportedIsSaidOncePerFeature) {
    Diagnostics diagnostics;
    diagnostics.unsupported({}, "media", "it is left out");
    diagnostics.unsupported({}, "media", "it is left out");
    EXPECT_EQ(diagnostics.all().size(), 1u);
    EXPECT_EQ(diagnostics.all_unsupported().at(0).count, 2);
    EXPECT_EQ(diagnostics.error_count(), 0);
}

TEST(Diagnostics, ClosestWord) {
    EXPECT_EQ(closest_word("spere", {"sphere", "box", "torus"}), "sphere");
    EXPECT_EQ(closest_word("qwertz", {"sphere", "box", "torus"}), "");
}

}  // namespace
}  // namespace rb
