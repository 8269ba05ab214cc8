// Expressions made by scripts/remake_expressions.py say what povray says, byte for byte.
#include "reading.h"

#include <fstream>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace rb {
namespace {

struct Case {
    std::string expression;
    std::string expected;
};

constexpr std::string_view refusal = "refused: ";

struct Corpus {
    std::string declarations;
    std::vector<Case> said;
    std::vector<Case> refused;

    Corpus() {
        std::ifstream in(std::string(RB_SOURCE_DIR) + "/tests/language/expressions.txt");
        for (std::string line; std::getline(in, line);) {
            const size_t tab = line.find('\t');
            if (tab == std::string::npos) {
                declarations += line + "\n";
                continue;
            }
            const Case made{line.substr(0, tab), line.substr(tab + 1)};
            (made.expected.starts_with(refusal) ? refused : said).push_back(made);
        }
    }
    std::string scene(std::string_view rest) const {
        return fmt::format("#version 3.7; global_settings {{ assumed_gamma 1 }}\n{}{}sphere {{ 0, 1 }}",
                           declarations, rest);
    }
};

TEST(ExpressionCorpus, SaysWhatPovraySays) {
    const Corpus corpus;
    ASSERT_GE(corpus.said.size(), 1000u);
    std::string lines;
    for (const Case& c : corpus.said) lines += fmt::format("#debug concat({}, \"\\n\")\n", c.expression);
    const Reading reading = read_scene(corpus.scene(lines));
    ASSERT_TRUE(reading.done) << reading.report;
    std::string_view rest = reading.debug;
    for (const Case& c : corpus.said) {
        const size_t end = rest.find('\n');
        ASSERT_NE(end, std::string_view::npos) << c.expression;
        EXPECT_EQ(rest.substr(0, end), c.expected) << c.expression;
        rest.remove_prefix(end + 1);
    }
}

TEST(ExpressionCorpus, RefusesWhatPovrayRefuses) {
    const Corpus corpus;
    for (const Case& c : corpus.refused) {
        const Reading reading = read_scene(corpus.scene(fmt::format("#debug {}\n", c.expression)));
        ASSERT_FALSE(reading.errors.empty()) << c.expression;
        EXPECT_NE(reading.errors[0].find(c.expected.substr(refusal.size())), std::string::npos)
            << c.expression << "\n"
            << reading.errors[0];
    }
}

}  // namespace
}  // namespace rb
