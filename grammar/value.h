#pragma once
// Right sides of declarations and macro arguments. Language spec 4.2.
#include "grammar/block.h"

namespace rb::grammar {

struct rvalue;

/// array = "array" "[" sum "]" { "[" sum "]" } [ rows ]
/// rows = "{" row { [","] row } [","] "}"        a row is a nested list, or a right side in the last
/// dimension
struct array_word : word_is<Keyword::array> {};
struct array_size : if_must<is<Tok::lbracket>, nested<sum, must<bracket_close>>> {};
struct array_sizes : plus<array_size> {};
struct array_deep {
    template <class State>
    static bool ask(State& state) {
        return state.array_has_inner_rows();
    }
};
struct rows;
struct rows_open : is<Tok::lbrace> {};
struct rows_close : is<Tok::rbrace> {};
struct array_item : seq<rvalue> {};
struct row : sor<seq<ask<array_deep>, rows>, array_item> {};
struct rows : if_must<rows_open, nested<star<row, opt_comma>, must<rows_close>>> {};
struct array : if_must<array_word, array_sizes, opt<rows>> {};

/// A texture block may be followed by more of them; other blocks stand alone.
struct value_is_texture {
    template <class State>
    static bool ask(State& state) {
        return state.value_is_texture();
    }
};

/// A text has no operators: a macro that follows must not be called before the text has its name.
struct at_text_call
    : tao::pegtl::at<sor<word_is<Keyword::chr>, word_is<Keyword::concat>, word_is<Keyword::str>,
                         word_is<Keyword::vstr>, word_is<Keyword::substr>, word_is<Keyword::strupr>,
                         word_is<Keyword::strlwr>, word_is<Keyword::datetime>>> {};
/// With an operator behind it, it is a mistake for `sum` to explain.
struct text_stands_alone {
    template <class State>
    static bool ask(State& state) {
        return state.text_stands_alone();
    }
};
struct lone_text : seq<tao::pegtl::at<text_literal>, ask<text_stands_alone>, text_literal> {};
struct text_value : sor<lone_text, seq<at_text_call, sor<call_one, call_many>>> {};

struct color_value : seq<color> {};
struct sum_value : seq<sum> {};
struct block_value : seq<block> {};
struct texture_follows : word_is<Keyword::texture> {};
/// Only looked at: a macro that follows must not be called before the texture has its name.
struct at_texture : tao::pegtl::at<quiet<texture_follows>> {};
struct layer_block : seq<block> {};
struct more_layers : star<ask<value_is_texture>, at_texture, layer_block> {};
/// transform = "transform" transform identifier
struct transform_value : seq<word_is<Keyword::transform>, sum> {};

/// rvalue = color | array | spline | function | block { texture block } | transform identifier | text | sum
struct rvalue : seq<open_next, sor<color_value, array, spline, function_literal,
                                   seq<block_value, more_layers>, transform_value, text_value, sum_value>> {};

}  // namespace rb::grammar
