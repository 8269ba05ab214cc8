#include "grammar/lexical.h"
#include "grammar/value.h"

#include <gtest/gtest.h>
#include <tao/pegtl/contrib/analyze.hpp>

namespace tao::pegtl {

template <typename Name>
struct analyze_traits<Name, rb::lexical::block_comment> : analyze_any_traits<> {};
template <typename Name>
struct analyze_traits<Name, rb::lexical::number_run> : analyze_any_traits<> {};
template <typename Name, rb::Tok... kinds>
struct analyze_traits<Name, rb::grammar::is<kinds...>> : analyze_any_traits<> {};
template <typename Name, rb::Tok... kinds>
struct analyze_traits<Name, rb::grammar::is_not<kinds...>> : analyze_any_traits<> {};
template <typename Name, rb::Keyword keyword>
struct analyze_traits<Name, rb::grammar::word_is<keyword>> : analyze_any_traits<> {};
template <typename Name>
struct analyze_traits<Name, rb::grammar::vector_open> : analyze_any_traits<> {};
template <typename Name>
struct analyze_traits<Name, rb::grammar::defined_test> : analyze_any_traits<> {};
template <typename Name, bool full>
struct analyze_traits<Name, rb::grammar::quick_expression<full>> : analyze_any_traits<> {};
template <typename Name, typename Rest>
struct analyze_traits<Name, rb::grammar::quick_items<Rest>> : analyze_opt_traits<> {};
template <typename Name, typename Plain, typename Items, typename Close>
struct analyze_traits<Name, rb::grammar::block_rest<Plain, Items, Close>>
    : analyze_seq_traits<Plain, Items, must<Close>> {};
template <typename Name>
struct analyze_traits<Name, rb::grammar::open_next> : analyze_opt_traits<> {};
template <typename Name, typename Question>
struct analyze_traits<Name, rb::grammar::ask<Question>> : analyze_opt_traits<> {};
template <typename Name, typename... Rules>
struct analyze_traits<Name, rb::grammar::nested<Rules...>> : analyze_seq_traits<Rules...> {};
template <typename Name, typename... Rules>
struct analyze_traits<Name, rb::grammar::quiet<Rules...>> : analyze_seq_traits<Rules...> {};

}  // namespace tao::pegtl

namespace rb {
namespace {

TEST(Grammar, LexicalRulesAlwaysAdvance) { EXPECT_EQ(tao::pegtl::analyze<lexical::file>(), 0u); }
TEST(Grammar, TokenRulesAlwaysAdvance) {
    EXPECT_EQ(tao::pegtl::analyze<grammar::rvalue>(), 0u);
    EXPECT_EQ(tao::pegtl::analyze<grammar::inner>(), 0u);
}

}  // namespace
}  // namespace rb
