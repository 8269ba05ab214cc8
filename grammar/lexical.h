#pragma once
// Characters to tokens. Language spec 1. Every rule matches one thing without the space around it.
#include <string_view>

#include <tao/pegtl.hpp>

namespace rb::lexical {

using namespace tao::pegtl;

/// line_comment = "//" { any } end of line
struct line_comment : seq<two<'/'>, until<at<sor<one<'\n', '\r'>, eof>>>> {};

/// block_comment = "/*" { block_comment | any } "*/"      (comments nest, to any depth: so no recursion here)
struct block_comment {
    using rule_t = block_comment;
    using subs_t = empty_list;
    template <class Input>
    static bool match(Input& in) {
        const std::string_view rest(in.current(), in.size());
        if (!rest.starts_with("/*")) return false;
        size_t depth = 0;
        for (size_t i = 0; i + 1 < rest.size(); ++i) {
            const bool open = rest[i] == '/' && rest[i + 1] == '*';
            const bool close = rest[i] == '*' && rest[i + 1] == '/';
            if (open) ++depth;
            if (close) --depth;
            if (open || close) ++i;
            if (depth == 0) {
                in.bump(i + 1);
                return true;
            }
        }
        return false;
    }
};
struct open_comment : seq<string<'/', '*'>, star<any>> {};

/// space = blank, line end, NUL, Ctrl-Z
struct blank : plus<one<' ', '\n', '\t', '\r', '\f', '\v', '\0', '\x1a'>> {};
struct ignored : sor<blank, line_comment, block_comment, open_comment> {};

/// number = digits [ "." { digit } ] [ exponent ] | "." digits [ exponent ]
/// exponent = ("e" | "E") [ "+" | "-" ] { digit }
struct exponent : seq<one<'e', 'E'>, opt<one<'+', '-'>>, star<digit>> {};
struct mantissa : sor<seq<plus<digit>, opt<one<'.'>, star<digit>>>, seq<one<'.'>, plus<digit>>> {};
struct number : seq<mantissa, opt<exponent>> {};
/// An error at its end.
struct second_point : seq<mantissa, one<'.'>> {};

/// word = (letter | "_") { letter | digit | "_" }
struct word : identifier {};

/// text = '"' { "\" any | any but '"' } '"'
struct text_escape : seq<one<'\\'>, any> {};
struct text_end : one<'"'> {};
struct text : seq<one<'"'>, until<text_end, sor<text_escape, any>>> {};
struct open_text : seq<one<'"'>, star<any>> {};

/// sign = "<=" | ">=" | "!=" | one of the single signs
struct less_equal : string<'<', '='> {};
struct greater_equal : string<'>', '='> {};
struct not_equal : string<'!', '='> {};
struct single_sign : one<'(', ')', '[', ']', '{', '}', '<', '>', '=', '+', '-', '*', '/', '!', '&', '|', '?',
                         ':', ';', ',', '.', '#', '%', '^', '~', '@', '$', '\'', '`', '\\'> {};

/// A long list `<1,2,3>, <4,5,6>, ...` of plain numbers becomes one token. The rule is hand-written
/// (`State::take_run`), since such lists are megabytes; a grammar that leaves it out gives the same values.
struct number_run {
    using rule_t = number_run;
    using subs_t = empty_list;
    template <apply_mode, rewind_mode, template <class...> class, template <class...> class, class Input,
              class State>
    static bool match(Input& in, State& state) {
        const size_t size = state.take_run(in.current(), in.end());
        in.bump(size);
        return size > 0;
    }
};

struct illegal : any {};

/// file = { ignored | token } end
struct token : sor<word, second_point, number, number_run, text, open_text, less_equal, greater_equal,
                   not_equal, single_sign> {};
struct piece : sor<ignored, token, illegal> {};
struct file : until<eof, piece> {};

}  // namespace rb::lexical
