#pragma once
// What the rules of the token grammar do: each action is a call of ParseState. Only parser.cpp includes this.
#include "grammar/value.h"
#include "language/parse_state.h"
#include "language/token_input.h"

#include <fmt/format.h>

namespace rb {

template <class Rule>
struct action : tao::pegtl::nothing<Rule> {};

/// Actions that need the first token, the last token, or nothing. The first one is known only of rules of a
/// few tokens (TokenInput keeps no more).
template <auto member>
struct on_first {
    template <class In>
    static void apply(const In& in, ParseState& state) {
        (state.*member)(in.first());
    }
};
template <auto member>
struct on_first_place {
    template <class In>
    static void apply(const In& in, ParseState& state) {
        (state.*member)(in.first().where);
    }
};
template <auto member>
struct on_match {
    static void apply0(ParseState& state) { (state.*member)(); }
};
template <Operator op>
struct on_operator {
    static void apply0(ParseState& state) { state.apply(op); }
};
template <auto member>
struct on_function_first {
    template <class In>
    static void apply(const In& in, ParseState& state) {
        (state.functions().*member)(in.first());
    }
};
template <auto member>
struct on_function {
    static void apply0(ParseState& state) { (state.functions().*member)(); }
};
template <char level, char op>
struct on_chain {
    static void apply0(ParseState& state) { state.functions().chain(level, op); }
};

// Expressions.
template <>
struct action<grammar::number> {
    template <class In>
    static void apply(const In& in, ParseState& state) {
        state.push(Terms{{in.first().number}, 1}, in.first().where);
    }
};
template <>
struct action<grammar::name_token> : on_first<&ParseState::push_name> {};
template <>
struct action<grammar::constant> : on_first<&ParseState::push_constant> {};
template <>
struct action<grammar::text_literal> : on_first<&ParseState::push_text> {};
template <>
struct action<grammar::component_name> : on_first<&ParseState::take_component> {};
template <>
struct action<grammar::subscript_close> : on_first_place<&ParseState::take_subscript> {};
template <>
struct action<grammar::group_open> : on_first_place<&ParseState::open_place> {};
template <>
struct action<grammar::group_close> : on_first_place<&ParseState::close_group> {};
template <>
struct action<grammar::vector_begin> {
    template <class In>
    static void apply(const In& in, ParseState& state) {
        state.open_list(in.first().where);
    }
};
template <>
struct action<grammar::vector_close> : on_first_place<&ParseState::close_vector> {};
template <>
struct action<grammar::call_one_open> {
    template <class In>
    static void apply(const In& in, ParseState& state) {
        state.open_list(in.first().where, in.first().word);
    }
};
template <>
struct action<grammar::call_many_open> : action<grammar::call_one_open> {};
template <>
struct action<grammar::call_close> : on_first_place<&ParseState::close_call> {};
template <>
struct action<grammar::value_call_open> {
    template <class In>
    static void apply(const In& in, ParseState& state) {
        state.open_list(in.first().where);
    }
};
template <>
struct action<grammar::value_call_close> : on_first_place<&ParseState::close_value_call> {};
template <>
struct action<grammar::spline_type> : on_first<&ParseState::set_spline_type> {};
template <>
struct action<grammar::defined_test> {
    template <class In>
    static void apply(const In& in, ParseState& state) {
        state.push(Terms{{in.first().number}, 1}, in.first().where);
    }
};
template <>
struct action<grammar::negation_sign> : on_first_place<&ParseState::open_place> {};
template <>
struct action<grammar::negation> : on_match<&ParseState::negate> {};
template <>
struct action<grammar::plus_sign> : on_match<&ParseState::close_plus> {};
template <>
struct action<grammar::inversion_sign> : on_first_place<&ParseState::open_place> {};
template <>
struct action<grammar::inversion> : on_match<&ParseState::invert> {};
template <>
struct action<grammar::multiplied> : on_operator<Operator::multiply> {};
template <>
struct action<grammar::divided> : on_operator<Operator::divide> {};
template <>
struct action<grammar::added> : on_operator<Operator::add> {};
template <>
struct action<grammar::subtracted> : on_operator<Operator::subtract> {};
template <>
struct action<grammar::less> : on_operator<Operator::less> {};
template <>
struct action<grammar::less_or_equal> : on_operator<Operator::less_equal> {};
template <>
struct action<grammar::equal> : on_operator<Operator::equal> {};
template <>
struct action<grammar::unequal> : on_operator<Operator::unequal> {};
template <>
struct action<grammar::greater_or_equal> : on_operator<Operator::greater_equal> {};
template <>
struct action<grammar::greater> : on_operator<Operator::greater> {};
template <>
struct action<grammar::both> : on_operator<Operator::both> {};
template <>
struct action<grammar::either> : on_operator<Operator::either> {};
template <>
struct action<grammar::choice> : on_match<&ParseState::choose> {};

// Colours.
template <>
struct action<grammar::color_begin> {
    template <class In>
    static void apply(const In& in, ParseState& state) {
        state.open_color(in.input().current().where);
    }
};
template <>
struct action<grammar::color_word> : on_match<&ParseState::add_color_word> {};
template <>
struct action<grammar::rgb_word> : on_first<&ParseState::set_color_word> {};
template <>
struct action<grammar::channel_word> : on_first<&ParseState::set_color_word> {};
template <>
struct action<grammar::rgb_base> : on_match<&ParseState::add_rgb_base> {};
template <>
struct action<grammar::channel> : on_match<&ParseState::add_channel> {};
template <>
struct action<grammar::bare_base> : on_match<&ParseState::add_bare_base> {};

// Blocks.
template <>
struct action<grammar::block_open> {
    template <class In>
    static void apply(const In& in, ParseState& state) {
        state.open_block(state.session().words.spelling(in.first().word), in.first().where);
    }
};
template <>
struct action<grammar::block_close> : on_first_place<&ParseState::close_inner_block> {};
template <>
struct action<grammar::entry_open> {
    template <class In>
    static void apply(const In& in, ParseState& state) {
        state.open_block("[", in.first().where);
    }
};
template <>
struct action<grammar::entry_close> : on_first_place<&ParseState::close_inner_block> {};
template <>
struct action<grammar::tuple_open> {
    template <class In>
    static void apply(const In& in, ParseState& state) {
        state.add_word(in.first());
        state.open_list(in.first().where);
    }
};
template <>
struct action<grammar::tuple_close> {
    template <class In>
    static void apply(const In& in, ParseState& state) {
        state.close_tuple(in.first().where);
        state.add_value();
    }
};
template <>
struct action<grammar::srgb_gamma> {
    template <class In>
    static void apply(const In& in, ParseState& state) {
        state.add_word(in.first());
        state.add_word(in.input().previous());
    }
};
template <>
struct action<grammar::packed_run> : on_first<&ParseState::add_run> {};
template <>
struct action<grammar::color_item> : on_match<&ParseState::add_color> {};
template <>
struct action<grammar::value_item> : on_match<&ParseState::add_value> {};
template <>
struct action<grammar::function_item> : on_match<&ParseState::add_function> {};
template <>
struct action<grammar::plain_word> : on_first<&ParseState::add_word> {};
template <>
struct action<grammar::radius_word> : on_first<&ParseState::add_word> {};
template <>
struct action<grammar::stray> : on_first<&ParseState::add_stray> {};
template <>
struct action<grammar::lone_comma> : on_first<&ParseState::add_stray> {};

// Right sides.
template <>
struct action<grammar::color_value> : on_match<&ParseState::push_color_value> {};
template <>
struct action<grammar::block_value> : on_match<&ParseState::push_block_value> {};
template <>
struct action<grammar::layer_block> : on_match<&ParseState::merge_layer> {};
template <>
struct action<grammar::transform_value> : on_match<&ParseState::push_transform_value> {};
template <>
struct action<grammar::array_word> : on_first_place<&ParseState::open_array> {};
template <>
struct action<grammar::array_size> : on_match<&ParseState::size_array> {};
template <>
struct action<grammar::array_sizes> : on_match<&ParseState::check_array> {};
template <>
struct action<grammar::array> : on_match<&ParseState::push_array> {};
template <>
struct action<grammar::rows_open> : on_match<&ParseState::open_rows> {};
template <>
struct action<grammar::rows_close> : on_first_place<&ParseState::close_rows> {};
template <>
struct action<grammar::array_item> : on_match<&ParseState::add_row_item> {};
template <>
struct action<grammar::spline_word> : action<grammar::vector_begin> {};
template <>
struct action<grammar::spline_close> : on_first_place<&ParseState::push_spline> {};

// User functions.
template <>
struct action<grammar::function_begin> {
    template <class In>
    static void apply(const In& in, ParseState& state) {
        state.functions().begin(in.first().where);
        state.open_barrier();
    }
};
template <>
struct action<grammar::image_word> : on_first<&ParseState::add_word> {};
template <>
struct action<grammar::image_value> : on_match<&ParseState::add_image_value> {};
template <>
struct action<grammar::image_body_open> : action<grammar::function_begin> {};
template <>
struct action<grammar::image_body> {
    template <class In>
    static void apply(const In& in, ParseState& state) {
        state.close_barrier();
        state.push_function(cover(state.functions().place(), in.input().previous().where));
        state.add_function();
    }
};
template <>
struct action<grammar::spline_body> : on_match<&ParseState::set_function_spline> {};
template <>
struct action<grammar::parameters_open> : on_function<&FunctionBuilder::begin_parameters> {};
template <>
struct action<grammar::parameter> : on_function_first<&FunctionBuilder::add_parameter> {};
template <>
struct action<grammar::internal_number> {
    static void apply0(ParseState& state) { state.functions().set_internal(state.pop()); }
};
template <>
struct action<grammar::block_body> : on_match<&ParseState::set_function_block> {};
template <>
struct action<grammar::expression_body> : on_function<&FunctionBuilder::set_expression> {};
template <>
struct action<grammar::function_literal> {
    template <class In>
    static void apply(const In& in, ParseState& state) {
        state.close_barrier();
        state.push_function(cover(state.functions().place(), in.input().previous().where));
    }
};
template <>
struct action<grammar::f_number> {
    template <class In>
    static void apply(const In& in, ParseState& state) {
        state.functions().push_number(in.first().number);
    }
};
template <>
struct action<grammar::f_name_token> {
    template <class In>
    static void apply(const In& in, ParseState& state) {
        state.open_function_name(in.first());
    }
};
template <>
struct action<grammar::f_value_open> : on_match<&ParseState::open_function_value> {};
template <>
struct action<grammar::f_value_close> : on_function<&FunctionBuilder::close_value_call> {};
template <>
struct action<grammar::f_component_name> : on_function_first<&FunctionBuilder::take_component> {};
template <>
struct action<grammar::f_name_end> : on_match<&ParseState::close_function_name> {};
template <>
struct action<grammar::f_group> : on_function<&FunctionBuilder::close_group> {};
template <>
struct action<grammar::f_call_open> : on_function_first<&FunctionBuilder::open_call> {};
template <>
struct action<grammar::f_call_close> : on_function<&FunctionBuilder::close_call> {};
template <>
struct action<grammar::f_loop_open> : on_function_first<&FunctionBuilder::open_call> {};
template <>
struct action<grammar::f_loop_variable> : on_function_first<&FunctionBuilder::add_loop_variable> {};
template <>
struct action<grammar::f_loop_close> : on_function<&FunctionBuilder::close_loop> {};
template <>
struct action<grammar::f_negated> : on_function<&FunctionBuilder::negate> {};
template <>
struct action<grammar::f_times> : on_chain<'*', '*'> {};
template <>
struct action<grammar::f_over> : on_chain<'*', '/'> {};
template <>
struct action<grammar::f_plus> : on_chain<'+', '+'> {};
template <>
struct action<grammar::f_minus> : on_chain<'+', '-'> {};
template <>
struct action<grammar::f_less> : on_chain<'<', '<'> {};
template <>
struct action<grammar::f_less_equal> : on_chain<'<', 'l'> {};
template <>
struct action<grammar::f_equal> : on_chain<'<', '='> {};
template <>
struct action<grammar::f_unequal> : on_chain<'<', '!'> {};
template <>
struct action<grammar::f_greater_equal> : on_chain<'<', 'g'> {};
template <>
struct action<grammar::f_greater> : on_chain<'<', '>'> {};
template <>
struct action<grammar::f_both> : on_chain<'&', '&'> {};
template <>
struct action<grammar::f_either> : on_chain<'|', '|'> {};

/// What a rule that must match is called in a message: its sign, or what can stand for most rules.
template <class Rule>
constexpr std::string_view expected_text() {
    if constexpr (std::is_base_of_v<grammar::is<Tok::rparen>, Rule>) return ")";
    if constexpr (std::is_base_of_v<grammar::is<Tok::lparen>, Rule>) return "(";
    if constexpr (std::is_base_of_v<grammar::is<Tok::rbracket>, Rule>) return "]";
    if constexpr (std::is_base_of_v<grammar::is<Tok::rbrace>, Rule>) return "}";
    if constexpr (std::is_base_of_v<grammar::is<Tok::lbrace>, Rule>) return "{";
    if constexpr (std::is_base_of_v<grammar::is<Tok::rangle>, Rule>) return ">";
    if constexpr (std::is_base_of_v<grammar::is<Tok::colon>, Rule>) return ":";
    if constexpr (std::is_same_v<Rule, grammar::component_name> ||
                  std::is_same_v<Rule, grammar::f_component_name>) {
        return "x, y, z, u, v, t, red, green, blue, filter, transmit or gray";
    }
    return "numeric expression";
}

template <class Rule>
struct control : tao::pegtl::normal<Rule> {
    template <class Input>
    [[noreturn]] static void raise(const Input& in, ParseState& state) {
        const Session& session = state.session();
        const Produced& token = in.current();
        SceneError error(token.where, fmt::format("Expected '{}', {} found instead", expected_text<Rule>(),
                                                  found_text(session, token)));
        std::string& message = error.diagnostic().message;
        const Block* block = state.open_block();
        if constexpr (std::is_same_v<Rule, grammar::block_close> ||
                      std::is_same_v<Rule, grammar::entry_close>) {
            message = fmt::format("No matching }} in '{}', {} found instead", block ? block->keyword : "",
                                  found_text(session, token));
        }
        if (token.kind == Tok::undeclared) message += session.hint(session.words.spelling(token.word));
        if (token.kind == Tok::end && block) {
            error.diagnostic().notes.push_back(
                {Severity::note, block->where, fmt::format("'{}' begins here", block->keyword), {}});
        }
        throw error;
    }
};

}  // namespace rb
