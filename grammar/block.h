#pragma once
// Generic blocks: `keyword { items }`. What a torus takes is not known here; its reader looks at the items.
#include "grammar/expression.h"
#include "grammar/function.h"

namespace rb::grammar {

struct items;

/// block = keyword "{" items "}"
struct block_open : seq<is<Tok::keyword>, is<Tok::lbrace>> {};
struct block_close : is<Tok::rbrace> {};
struct inner;
struct plain_items : quick_items<inner> {};
struct further_items;
struct inner : block_rest<plain_items, further_items, block_close> {};
struct block : if_must<block_open, inner> {};

/// entry = "[" items "]"        of a map
struct entry_open : is<Tok::lbracket> {};
struct entry_close : is<Tok::rbracket> {};
struct entry : if_must<entry_open, nested<items, must<entry_close>>> {};

/// tuple = ( "pwr" | "xyz" ) "(" sum { [","] sum } ")" [ ":" ]        one value of several terms
struct tuple_word : sor<word_is<Keyword::pwr>, word_is<Keyword::xyz>> {};
struct tuple_open : seq<tuple_word, paren_open> {};
struct tuple_close : is<Tok::rparen> {};
struct tuple : if_must<tuple_open, nested<plus<sum, opt_comma>, must<tuple_close>, opt<is<Tok::colon>>>> {};

/// gamma = ( "gamma" | "assumed_gamma" ) "srgb"        the only place where that is no colour
struct gamma_word : sor<word_is<Keyword::assumed_gamma>, word_is<Keyword::gamma>> {};
struct srgb_gamma : seq<gamma_word, word_is<Keyword::srgb>> {};

struct colors_allowed {
    template <class State>
    static bool ask(State& state) {
        return state.colors_allowed();
    }
};
struct packed_run : is<Tok::run> {};
struct color_item : seq<ask<colors_allowed>, color> {};
/// A text is no term of a sum: what follows it may begin with a minus.
struct value_item : sor<text_literal, sum> {};
struct function_item : seq<function_literal> {};
/// A function word that no "(" follows is a plain word (`julia_fractal{... exp}`), and so is `filter` in an
/// image.
struct plain_word : is<Tok::keyword, Tok::function, Tok::call_one, Tok::call_many, Tok::component> {};
struct stray : is_not<Tok::rbrace, Tok::rbracket> {};

/// items = { item [","] }
struct item : sor<packed_run, color_item, srgb_gamma, block, value_item, function_item, function_image, tuple,
                  plain_word, entry, stray> {};
/// Behind `radius` a value may be left out: `radius , 2`. Its comma is an item then.
struct radius_word : word_is<Keyword::radius> {};
struct lone_comma : is<Tok::comma> {};
struct sparse_item : sor<radius_word, lone_comma> {};
struct further_items : star<sor<sparse_item, seq<item, opt_comma>>, plain_items> {};
struct items : seq<plain_items, further_items> {};

}  // namespace rb::grammar
