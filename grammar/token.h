#pragma once
#include <cstdint>
#include <string_view>

namespace rb {

/// Kinds of tokens. A file holds `word`s; the token stream hands them on as `name` (declared), `undeclared`,
/// or as the kind that grammar/keywords.def gives to a reserved word.
enum class Tok : uint8_t {
    end,
    number,
    text,
    word,
    name,
    undeclared,
    // reserved words
    keyword,
    constant,
    call_one,
    call_many,
    defined,
    color,
    rgb,
    component,
    function,
    // signs
    lparen,
    rparen,
    lbracket,
    rbracket,
    lbrace,
    rbrace,
    langle,
    rangle,
    less_equal,
    greater_equal,
    not_equal,
    equals,
    plus,
    minus,
    star,
    slash,
    bang,
    ampersand,
    bar,
    question,
    colon,
    semicolon,
    comma,
    dot,
    hash,
    other_sign,
    run,     ///< a long list of plain number vectors, kept as text
    invalid  ///< a place that cannot be a token; TokenFile::errors says why
};

/// Reserved words by number; a word's number below `Keyword::count` is its Keyword.
enum class Keyword : uint16_t {
#define RB_KEYWORD(name, spelling, kind) name,
#include "grammar/keywords.def"
#undef RB_KEYWORD
    count
};

inline constexpr std::string_view keyword_spellings[] = {
#define RB_KEYWORD(name, spelling, kind) spelling,
#include "grammar/keywords.def"
#undef RB_KEYWORD
};

inline constexpr Tok keyword_kinds[] = {
#define RB_KEYWORD(name, spelling, kind) Tok::kind,
#include "grammar/keywords.def"
#undef RB_KEYWORD
};

}  // namespace rb
