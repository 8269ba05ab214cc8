#include "grammar/lexical.h"
#include "language/number_run.h"
#include "language/token_file.h"

#include <algorithm>

#include <fmt/format.h>

namespace rb {

namespace {

namespace pegtl = tao::pegtl;

constexpr size_t shortest_run = 8;

/// Collects tokens while the grammar runs.
class Lexer {
public:
    Lexer(TokenFile& out, Words& words, bool runs) : out_(out), words_(words), runs_(runs) {}

    void add(Tok kind, const char* begin, const char* end, uint32_t aux = 0) {
        out_.tokens.push_back({offset(begin), static_cast<uint32_t>(end - begin), aux, kind});
    }
    void add_word(std::string_view spelling) {
        add(Tok::word, spelling.data(), spelling.data() + spelling.size(), words_.number(spelling));
    }
    void add_number(std::string_view spelling) {
        add(Tok::number, spelling.data(), spelling.data() + spelling.size(),
            static_cast<uint32_t>(out_.numbers.size()));
        out_.numbers.push_back(parse_number(spelling));
    }
    void error(const char* begin, const char* end, std::string message) {
        out_.errors.push_back({static_cast<uint32_t>(out_.tokens.size()), std::move(message)});
        add(Tok::invalid, begin, end);
    }

    /// Size of the run that starts here, 0 if there is none worth keeping.
    size_t take_run(const char* at, const char* end) {
        if (!runs_ || *at != '<' || offset(at) < no_run_before_) return 0;
        if (out_.tokens.empty() || out_.tokens.back().kind != Tok::comma) return 0;
        const NumberRun run = find_number_run({at, static_cast<size_t>(end - at)});
        if (run.count < shortest_run) {
            no_run_before_ = offset(at) + static_cast<uint32_t>(run.looked);
            return 0;
        }
        add(Tok::run, at, at + run.size, static_cast<uint32_t>(run.terms));
        return run.size;
    }

private:
    uint32_t offset(const char* at) const { return static_cast<uint32_t>(at - out_.text.data()); }

    TokenFile& out_;
    Words& words_;
    bool runs_;
    uint32_t no_run_before_ = 0;
};

Tok sign_kind(char c) {
    constexpr std::string_view signs = "()[]{}<>=+-*/!&|?:;,.#";
    constexpr Tok kinds[] = {Tok::lparen, Tok::rparen,   Tok::lbracket, Tok::rbracket,  Tok::lbrace,
                             Tok::rbrace, Tok::langle,   Tok::rangle,   Tok::equals,    Tok::plus,
                             Tok::minus,  Tok::star,     Tok::slash,    Tok::bang,      Tok::ampersand,
                             Tok::bar,    Tok::question, Tok::colon,    Tok::semicolon, Tok::comma,
                             Tok::dot,    Tok::hash};
    const size_t at = signs.find(c);
    return at == std::string_view::npos ? Tok::other_sign : kinds[at];
}

template <class Rule>
struct action : pegtl::nothing<Rule> {};

template <>
struct action<lexical::word> {
    template <class In>
    static void apply(const In& in, Lexer& lexer) {
        if (in.size() > 255) {
            lexer.error(in.begin(), in.end(), "String too long.");
        } else {
            lexer.add_word({in.begin(), in.size()});
        }
    }
};

template <>
struct action<lexical::second_point> {
    template <class In>
    static void apply(const In& in, Lexer& lexer) {
        lexer.error(in.begin(), in.end(), "Unexpected additional '.' in floating-point number");
    }
};

template <>
struct action<lexical::number> {
    template <class In>
    static void apply(const In& in, Lexer& lexer) {
        lexer.add_number({in.begin(), in.size()});
    }
};

template <>
struct action<lexical::text> {
    template <class In>
    static void apply(const In& in, Lexer& lexer) {
        // The raw characters between the quotes count.
        if (in.size() > 257) {
            lexer.error(in.begin(), in.begin() + 1, "String too long.");
        } else {
            lexer.add(Tok::text, in.begin(), in.end());
        }
    }
};

template <>
struct action<lexical::open_text> {
    template <class In>
    static void apply(const In& in, Lexer& lexer) {
        lexer.error(in.begin(), in.begin() + 1, "No end quote for string.");
    }
};

template <>
struct action<lexical::open_comment> {
    template <class In>
    static void apply(const In& in, Lexer& lexer) {
        lexer.error(in.begin(), in.begin() + 2, "No */ closing comment found.");
    }
};

template <>
struct action<lexical::illegal> {
    template <class In>
    static void apply(const In& in, Lexer& lexer) {
        lexer.error(in.begin(), in.end(),
                    fmt::format("Illegal character in input file, value is {:02x}",
                                static_cast<unsigned char>(in.peek_char())));
    }
};

template <>
struct action<lexical::single_sign> {
    template <class In>
    static void apply(const In& in, Lexer& lexer) {
        lexer.add(sign_kind(in.peek_char()), in.begin(), in.end());
    }
};

template <Tok kind>
struct add_sign {
    template <class In>
    static void apply(const In& in, Lexer& lexer) {
        lexer.add(kind, in.begin(), in.end());
    }
};
template <>
struct action<lexical::less_equal> : add_sign<Tok::less_equal> {};
template <>
struct action<lexical::greater_equal> : add_sign<Tok::greater_equal> {};
template <>
struct action<lexical::not_equal> : add_sign<Tok::not_equal> {};

bool continues(Keyword word, Keyword opener) {
    if (word == Keyword::else_) {
        return opener == Keyword::if_ || opener == Keyword::ifdef || opener == Keyword::ifndef ||
               opener == Keyword::switch_;
    }
    if (word == Keyword::elseif) {
        return opener == Keyword::if_ || opener == Keyword::ifdef || opener == Keyword::ifndef;
    }
    return (word == Keyword::case_ || word == Keyword::range) && opener == Keyword::switch_;
}

/// Links each branch of a conditional, loop or macro to the next one.
void link_branches(TokenFile& out) {
    struct Open {
        Keyword word;
        uint32_t last;
    };
    std::vector<Open> open;
    for (uint32_t i = 0; i + 1 < out.tokens.size(); ++i) {
        if (out.tokens[i].kind != Tok::hash || out.tokens[i + 1].kind != Tok::word) continue;
        const uint32_t number = out.tokens[i + 1].aux;
        if (!Words::is_keyword(number)) continue;
        const auto word = static_cast<Keyword>(number);
        if (opens_branches(word)) {
            open.push_back({word, i});
        } else if (open.empty()) {
            continue;
        } else if (word == Keyword::end) {
            out.tokens[open.back().last].aux = i;
            open.pop_back();
        } else if (continues(word, open.back().word)) {
            out.tokens[open.back().last].aux = i;
            open.back().last = i;
        }
    }
}

}  // namespace

bool opens_branches(Keyword word) {
    return word == Keyword::if_ || word == Keyword::ifdef || word == Keyword::ifndef ||
           word == Keyword::while_ || word == Keyword::for_ || word == Keyword::switch_ ||
           word == Keyword::macro;
}

TokenFilePtr lex(uint32_t file, std::string_view text, Words& words, const LexOptions& options) {
    auto out = std::make_shared<TokenFile>();
    out->file = file;
    out->text = text;
    const auto end = std::min<size_t>(options.end, text.size());
    size_t begin = options.begin;
    if (options.is_main) {
        while (begin < end && static_cast<unsigned char>(text[begin]) >= 128) ++begin;
    }
    Lexer lexer(*out, words, options.runs);
    pegtl::memory_input<pegtl::tracking_mode::lazy, pegtl::eol::lf_crlf, std::string_view> in(
        text.data() + begin, text.data() + end, std::string_view{});
    pegtl::parse<lexical::file, action>(in, lexer);
    out->tokens.push_back({static_cast<uint32_t>(end), 0, 0, Tok::end});
    link_branches(*out);
    return out;
}

}  // namespace rb
