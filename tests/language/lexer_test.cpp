#include "language/number_run.h"
#include "language/token_file.h"

#include <cmath>

#include <gtest/gtest.h>

namespace rb {
namespace {

struct Lexed {
    explicit Lexed(std::string text, LexOptions options = {})
        : source(std::move(text)), tokens(lex(1, source, words, options)) {}

    std::vector<Tok> kinds() const {
        std::vector<Tok> out;
        for (const Token& token : tokens->tokens) out.push_back(token.kind);
        return out;
    }
    double number(size_t i) const { return tokens->numbers[tokens->tokens[i].aux]; }
    std::string error() const { return tokens->errors.empty() ? "" : tokens->errors.front().message; }

    std::string source;
    Words words;
    TokenFilePtr tokens;
};

TEST(Lexer, Numbers) {
    const Lexed in("5. .5 1e 1e400 1.5e-3 007");
    EXPECT_DOUBLE_EQ(in.number(0), 5);
    EXPECT_DOUBLE_EQ(in.number(1), 0.5);
    EXPECT_DOUBLE_EQ(in.number(2), 1);
    EXPECT_TRUE(std::isinf(in.number(3)));
    EXPECT_DOUBLE_EQ(in.number(4), 0.0015);
    EXPECT_DOUBLE_EQ(in.number(5), 7);
}

TEST(Lexer, SecondPointIsAnError) {
    const Lexed in("1.2.3");
    EXPECT_EQ(in.error(), "Unexpected additional '.' in floating-point number");
    // The number's token once reached back over that of the error.
    EXPECT_EQ(in.kinds(), (std::vector{Tok::invalid, Tok::number, Tok::end}));
    EXPECT_EQ(in.tokens->tokens[0].begin, 3u);
    EXPECT_EQ(in.tokens->tokens[1].begin, 4u);
}

TEST(Lexer, HexIsANumberAndAWord) {
    EXPECT_EQ(Lexed("0x10").kinds(), (std::vector{Tok::number, Tok::word, Tok::end}));
}

TEST(Lexer, CommentsNest) {
    EXPECT_EQ(Lexed("/* a /* b */ c */ x // y\n z").kinds(), (std::vector{Tok::word, Tok::word, Tok::end}));
    EXPECT_EQ(Lexed("/* a /* b */").error(), "No */ closing comment found.");
    std::string deep;
    for (int i = 0; i < 200000; ++i) deep += "/*";
    EXPECT_EQ(Lexed(deep).error(), "No */ closing comment found.");
}

TEST(Lexer, Signs) {
    EXPECT_EQ(Lexed("<=>=!=<>{").kinds(), (std::vector{Tok::less_equal, Tok::greater_equal, Tok::not_equal,
                                                       Tok::langle, Tok::rangle, Tok::lbrace, Tok::end}));
}

TEST(Lexer, Strings) {
    EXPECT_EQ(Lexed(R"("a\"b" "c")").kinds(), (std::vector{Tok::text, Tok::text, Tok::end}));
    EXPECT_EQ(Lexed("\"abc").error(), "No end quote for string.");
    EXPECT_EQ(Lexed('"' + std::string(256, 'a') + '"').error(), "String too long.");
    EXPECT_EQ(Lexed('"' + std::string(255, 'a') + '"').error(), "");
}

TEST(Lexer, IllegalBytes) {
    EXPECT_EQ(Lexed("a \xe9").error(), "Illegal character in input file, value is e9");
    EXPECT_EQ(Lexed("/* \xe9 */ \"\xe9\"").error(), "");
    LexOptions main_file;
    main_file.is_main = true;
    EXPECT_EQ(Lexed("\xef\xbb\xbfx", main_file).kinds(), (std::vector{Tok::word, Tok::end}));
}

TEST(Lexer, BranchesKnowTheNextOne) {
    const Lexed in("#if (1) a #else #while (1) #end #end");
    const auto& tokens = in.tokens->tokens;
    const uint32_t next = tokens[0].aux;
    EXPECT_EQ(tokens[next].kind, Tok::hash);
    EXPECT_EQ(tokens[next + 1].aux, word_of(Keyword::else_));
    EXPECT_EQ(tokens[next].aux, tokens.size() - 3);
}

TEST(NumberRun, LongListsAreOneToken) {
    std::string list = "{ 10";
    for (int i = 0; i < 10; ++i) list += ", <1, -2.5, +3e2>";
    const Lexed in(list + " }");
    EXPECT_EQ(in.kinds(),
              (std::vector{Tok::lbrace, Tok::number, Tok::comma, Tok::run, Tok::rbrace, Tok::end}));
    std::vector<double> numbers;
    parse_number_run(in.tokens->spelling(in.tokens->tokens[3]), numbers);
    ASSERT_EQ(numbers.size(), 30u);
    EXPECT_EQ(numbers[28], -2.5);
    EXPECT_EQ(numbers[29], 300);
}

TEST(NumberRun, StopsBeforeAnExpression) {
    const std::string list = "<1,2>,<1,2>,<1,2>*2,<1,2>";
    EXPECT_EQ(find_number_run(list).count, 2u);
    EXPECT_EQ(find_number_run("<1,2>,<1,2,3>,<1,2>").count, 1u);
    EXPECT_EQ(find_number_run("<1 2>,<1,2>").count, 0u);
    EXPECT_EQ(find_number_run("<1,2>,<1,2>").count, 1u);
    EXPECT_EQ(find_number_run("<1,2> <1,2> }").count, 2u);
}

}  // namespace
}  // namespace rb
