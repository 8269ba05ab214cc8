#pragma once
// User functions. Language spec 14: an expression language of its own over floats.
#include "grammar/expression.h"

namespace rb::grammar {

struct block;
struct f_or;

/// function = "function" [ "(" [ parameter { [","] parameter } ] ")" ] "{" body "}"
/// A word `function` that is followed by something else stays a word.
struct function_word : is<Tok::function> {};
struct parameter : is<Tok::name, Tok::undeclared, Tok::constant> {};
struct parameters_open : is<Tok::lparen> {};
struct parameters : if_must<parameters_open, nested<star<parameter, opt_comma>, must<paren_close>>> {};
struct body_open : is<Tok::lbrace> {};
struct body_close : is<Tok::rbrace> {};

/// spline = "spline" "{" [ spline identifier ] { spline type | full "," full [","] } "}"
struct spline_word : word_is<Keyword::spline> {};
struct spline_value : seq<full> {};
struct spline_close : is<Tok::rbrace> {};
struct spline : if_must<spline_word, is<Tok::lbrace>,
                        nested<star<sor<spline_type, spline_value>, opt_comma>, must<spline_close>>> {};

/// body = "internal" "(" sum ")" | spline | block | or
struct internal_word : word_is<Keyword::internal> {};
struct internal_number : seq<sum> {};
struct internal_body : if_must<internal_word, paren_open, nested<internal_number, must<paren_close>>> {};
struct block_body : seq<block> {};
struct spline_body : seq<spline> {};
struct expression_body : seq<f_or> {};
struct body : sor<internal_body, spline_body, block_body, expression_body> {};
struct function_begin : seq<function_word, sor<tao::pegtl::at<body_open>, tao::pegtl::at<parameters_open>>> {
};
struct function_literal
    : if_must<function_begin, opt<parameters>, body_open, nested<body, must<body_close>>> {};

/// image = "function" sum [","] sum "{" body "}"        or "function" function identifier
struct value_is_number {
    template <class State>
    static bool ask(State& state) {
        return state.value_is_number();
    }
};
struct image_word : seq<function_word, tao::pegtl::not_at<is<Tok::lbrace, Tok::lparen>>> {};
struct image_value : seq<sum> {};
struct image_body_open : is<Tok::lbrace> {};
struct image_body : if_must<image_body_open, nested<body, must<body_close>>> {};
struct image_size : seq<ask<value_is_number>, opt_comma> {};
struct function_image : if_must<image_word, image_value, opt<if_must<image_size, image_value, image_body>>> {
};

/// operand = number | constant | identifier | parameter | "(" or ")" | call
struct f_number : is<Tok::number> {};
struct f_group : if_must<paren_open, nested<f_or, must<paren_close>>> {};
/// call = word "(" or { [","] or } ")" [ component ]
struct f_argument : seq<f_or> {};
struct f_call_word : is<Tok::call_one, Tok::call_many, Tok::keyword> {};
struct f_call_open : seq<f_call_word, paren_open> {};
struct f_call_close : is<Tok::rparen> {};
struct f_call : if_must<f_call_open, nested<plus<f_argument, opt_comma>, must<f_call_close>>> {};
/// sum = ("sum" | "prod") "(" variable "," or "," or "," or ")"
struct f_loop_word : sor<word_is<Keyword::sum>, word_is<Keyword::prod>> {};
struct f_loop_open : seq<f_loop_word, paren_open> {};
struct f_loop_variable : is<Tok::name, Tok::undeclared, Tok::constant> {};
struct f_loop_close : is<Tok::rparen> {};
struct f_loop : if_must<f_loop_open, nested<f_loop_variable, opt_comma, f_or, opt_comma, f_or, opt_comma,
                                            f_or, must<f_loop_close>>> {};
/// name = identifier { "[" sum "]" } [ "(" or { [","] or } ")" [ component ] ]
struct f_name_token : is<Tok::name, Tok::undeclared, Tok::constant> {};
struct f_is_array {
    template <class State>
    static bool ask(State& state) {
        return state.function_name_is_array();
    }
};
struct f_is_callable {
    template <class State>
    static bool ask(State& state) {
        return state.function_name_is_callable();
    }
};
struct f_subscript : if_must<seq<ask<f_is_array>, is<Tok::lbracket>>, nested<sum, must<subscript_close>>> {};
struct f_value_open : seq<ask<f_is_callable>, paren_open> {};
struct f_value_close : is<Tok::rparen> {};
struct f_component_name : is<Tok::constant, Tok::component, Tok::keyword> {};
struct f_component : if_must<is<Tok::dot>, f_component_name> {};
struct f_value_call
    : seq<if_must<f_value_open, nested<star<f_argument, opt_comma>, must<f_value_close>>>, opt<f_component>> {
};
struct f_name_end : success {};
struct f_name : seq<f_name_token, star<f_subscript>, opt<f_value_call>, f_name_end> {};
struct f_operand : sor<f_number, f_name, f_group, f_loop, f_call> {};

/// unary = [ "+" | "-" ] operand
struct f_negated : if_must<is<Tok::minus>, f_operand> {};
struct f_plain : seq<opt<is<Tok::plus>>, f_operand> {};
struct f_unary : sor<f_negated, f_plain> {};

/// The chains, lowest last; operands are collected, since constants are folded along a chain.
struct f_times : if_must<is<Tok::star>, f_unary> {};
struct f_over : if_must<is<Tok::slash>, f_unary> {};
struct f_product : seq<f_unary, star<sor<f_times, f_over>>> {};
struct f_plus : if_must<is<Tok::plus>, f_product> {};
struct f_minus : if_must<is<Tok::minus>, f_product> {};
struct f_sum : seq<f_product, star<sor<f_plus, f_minus>>> {};
struct f_less : if_must<is<Tok::langle>, f_sum> {};
struct f_less_equal : if_must<is<Tok::less_equal>, f_sum> {};
struct f_equal : if_must<is<Tok::equals>, f_sum> {};
struct f_unequal : if_must<is<Tok::not_equal>, f_sum> {};
struct f_greater_equal : if_must<is<Tok::greater_equal>, f_sum> {};
struct f_greater : if_must<is<Tok::rangle>, f_sum> {};
struct f_rel : seq<f_sum, star<sor<f_less, f_less_equal, f_equal, f_unequal, f_greater_equal, f_greater>>> {};
struct f_both : if_must<is<Tok::ampersand>, f_rel> {};
struct f_and : seq<f_rel, star<f_both>> {};
struct f_either : if_must<is<Tok::bar>, f_and> {};
struct f_or : seq<f_and, star<f_either>> {};

}  // namespace rb::grammar
