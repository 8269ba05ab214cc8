#pragma once
// Numeric, string and colour expressions. Language spec 7 to 10. Operands are values of any kind (numbers,
// strings, identifiers of things); operators take numbers.
#include "grammar/token_rules.h"

namespace rb::grammar {

struct sum;
struct full;

struct comma : is<Tok::comma> {};
struct opt_comma : opt<comma> {};
struct paren_open : is<Tok::lparen> {};
struct paren_close : is<Tok::rparen> {};
struct bracket_close : is<Tok::rbracket> {};
struct vector_close : is<Tok::rangle> {};

/// component = "." ( "x" | "y" | ... | "red" | ... | "gray" )
struct component_name : is<Tok::constant, Tok::component, Tok::keyword> {};
struct component : if_must<is<Tok::dot>, component_name> {};

/// subscripts = { "[" sum "]" }        as long as the value is an array
struct value_is_array {
    template <class State>
    static bool ask(State& state) {
        return state.value_is_array();
    }
};
struct subscript_close : is<Tok::rbracket> {};
struct subscript : if_must<is<Tok::lbracket>, nested<sum, must<subscript_close>>> {};
struct element : seq<ask<value_is_array>, subscript> {};

/// call_of_value = "(" sum { [","] sum } [ [","] spline type ] ")"        if the value is a function or a
/// spline
struct value_is_callable {
    template <class State>
    static bool ask(State& state) {
        return state.value_is_callable();
    }
};
struct spline_type : sor<word_is<Keyword::linear_spline>, word_is<Keyword::quadratic_spline>,
                         word_is<Keyword::cubic_spline>, word_is<Keyword::natural_spline>> {};
struct value_call_open : is<Tok::lparen> {};
struct value_call_close : is<Tok::rparen> {};
struct value_call : if_must<seq<ask<value_is_callable>, value_call_open>,
                            nested<star<sor<spline_type, sum>, opt_comma>, must<value_call_close>>> {};

/// name = identifier subscripts [ call_of_value ]
struct name_token : is<Tok::name> {};
struct name : seq<name_token, star<element>, opt<value_call>> {};

struct number : is<Tok::number> {};
struct constant : is<Tok::constant> {};
struct text_literal : is<Tok::text> {};

/// group = "(" full ")"
struct group_open : is<Tok::lparen> {};
struct group_close : is<Tok::rparen> {};
struct group : if_must<group_open, nested<full, must<group_close>>> {};

/// vector = "<" sum { [","] sum } [","] ">"
struct vector_begin : vector_open {};
struct vector : if_must<vector_begin, nested<plus<sum, opt_comma>, must<vector_close>>> {};

/// call = function "(" full ")" | function "(" sum { [","] sum } ")"
struct call_close : is<Tok::rparen> {};
struct call_one_open : seq<is<Tok::call_one>, paren_open> {};
struct call_one : if_must<call_one_open, nested<full, must<call_close>>> {};
struct call_many_open : seq<is<Tok::call_many>, paren_open> {};
struct call_many : if_must<call_many_open, nested<plus<sum, opt_comma>, must<call_close>>> {};

/// defined = "defined" "(" identifier subscripts ")"
struct defined_test {
    using rule_t = defined_test;
    using subs_t = empty_list;
    template <class Input>
    static bool match(Input& in) {
        return in.take_defined();
    }
};

/// primary = name | number | constant | text | group | vector | call
struct primary : sor<number, name, vector, constant, group, call_one, call_many, text_literal, defined_test> {
};

/// factor = primary [ component ] | "+" factor | "-" factor | "!" factor
struct factor;
struct plus_sign : if_must<is<Tok::plus>, nested<factor>> {};
struct negation_sign : is<Tok::minus> {};
struct negation : if_must<negation_sign, nested<factor>> {};
struct inversion_sign : is<Tok::bang> {};
struct inversion : if_must<inversion_sign, nested<factor>> {};
struct operand : seq<primary, opt<component>> {};
struct factor : seq<open_next, sor<operand, negation, inversion, plus_sign>> {};

/// term = factor { ("*" | "/") factor }
struct multiplied : if_must<is<Tok::star>, factor> {};
struct divided : if_must<is<Tok::slash>, factor> {};
struct term : seq<factor, star<sor<multiplied, divided>>> {};

/// sum = term { ("+" | "-") term }
struct added : if_must<is<Tok::plus>, term> {};
struct subtracted : if_must<is<Tok::minus>, term> {};
struct any_sum : seq<term, star<sor<added, subtracted>>> {};
struct sum : sor<quick_expression<false>, any_sum> {};

/// rel = sum { ("<" | "<=" | "=" | "!=" | ">=" | ">") sum }
struct less : if_must<is<Tok::langle>, sum> {};
struct less_or_equal : if_must<is<Tok::less_equal>, sum> {};
struct equal : if_must<is<Tok::equals>, sum> {};
struct unequal : if_must<is<Tok::not_equal>, sum> {};
struct greater_or_equal : if_must<is<Tok::greater_equal>, sum> {};
struct greater : if_must<is<Tok::rangle>, sum> {};
struct rel : seq<any_sum, star<sor<less, less_or_equal, equal, unequal, greater_or_equal, greater>>> {};

/// logical = rel { ("&" | "|") rel }
struct both : if_must<is<Tok::ampersand>, rel> {};
struct either : if_must<is<Tok::bar>, rel> {};
struct logical : seq<rel, star<sor<both, either>>> {};

/// full = logical [ "?" full ":" full ]
struct choice_colon : is<Tok::colon> {};
struct choice : if_must<is<Tok::question>, nested<full, must<choice_colon>>, nested<full>> {};
struct full : sor<quick_expression<true>, seq<logical, opt<choice>>> {};

/// color = [ "color" ] [ base ] { channel }        base only first, channels in any order and number
/// base = ( "rgb" | "rgbf" | ... ) full | full     the bare form only behind "color"
/// channel = ( "red" | "green" | "blue" | "filter" | "transmit" | "alpha" ) sum
struct color_begin : tao::pegtl::at<is<Tok::color, Tok::rgb, Tok::component>> {};
struct color_word : is<Tok::color> {};
struct rgb_word : is<Tok::rgb> {};
struct rgb_base : if_must<rgb_word, full> {};
struct channel_word : is<Tok::component> {};
struct channel : if_must<channel_word, sum> {};
struct bare_base : seq<full> {};
struct color
    : seq<color_begin, sor<seq<color_word, open_next, opt<sor<rgb_base, channel, bare_base>>, star<channel>>,
                           seq<sor<rgb_base, channel>, star<channel>>>> {};

}  // namespace rb::grammar
