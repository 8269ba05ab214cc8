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
    void add_number(std::string_view spelling) { add_number(spelling, parse_number(spelling)); }
    void add_number(std::string_view spelling, double value) {
        add(Tok::number, spelling.data(), spelling.data() + spelling.size(),
            static_cast<uint32_t>(out_.numbers.size()));
        out_.numbers.push_back(value);
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
        lexer.error(in.end() - 1, in.end(), "Unexpected additional '.' in floating-point number");
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

using CharacterInput = pegtl::memory_input<pegtl::tracking_mode::lazy, pegtl::eol::lf_crlf, std::string_view>;

bool begins_word(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }

/// Words, numbers and signs by hand; the grammar is the slow twin and takes whatever else there is.
class QuickLexer {
public:
    QuickLexer(Lexer& lexer, const char* begin, const char* end) : lexer_(lexer), at_(begin), end_(end) {}

    void run() {
        while (at_ != end_) {
            if (!step()) leave_to_grammar();
        }
    }

private:
    bool step() {
        const char c = *at_;
        switch (c) {
            case ' ':
            case '\n':
            case '\t':
            case '\r':
                ++at_;
                return true;
            case '<':
                if (const size_t size = lexer_.take_run(at_, end_); size > 0) {
                    at_ += size;
                    return true;
                }
                return next_is('=') ? sign(Tok::less_equal, 2) : sign(Tok::langle, 1);
            case '>':
                return next_is('=') ? sign(Tok::greater_equal, 2) : sign(Tok::rangle, 1);
            case ',':
                return sign(Tok::comma, 1);
            case '-':
                return sign(Tok::minus, 1);
            case '{':
                return sign(Tok::lbrace, 1);
            case '}':
                return sign(Tok::rbrace, 1);
            case '/':
                return !next_is('/') && !next_is('*') && sign(Tok::slash, 1);
            case '.':
                return end_ - at_ > 1 && !is_digit(at_[1]) && sign(Tok::dot, 1);
            case '(':
            case ')':
            case '[':
            case ']':
            case '+':
            case '*':
            case '=':
            case ';':
            case '#':
                return sign(sign_kind(c), 1);
            default:
                return begins_word(c) ? word() : is_digit(c) && number();
        }
    }

    bool next_is(char c) const { return end_ - at_ > 1 && at_[1] == c; }

    bool sign(Tok kind, size_t size) {
        lexer_.add(kind, at_, at_ + size);
        at_ += size;
        return true;
    }

    bool word() {
        const char* last = at_;
        while (last != end_ && (begins_word(*last) || is_digit(*last))) ++last;
        if (last - at_ > 255) return false;
        lexer_.add_word({at_, static_cast<size_t>(last - at_)});
        at_ = last;
        return true;
    }

    /// Digits, and perhaps a point and more digits. Both the digits and the power of ten are exact as doubles
    /// (up to 2^53 and 10^22), so that their quotient is the nearest number.
    bool number() {
        constexpr double powers[] = {1,   1e1, 1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                     1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15};
        uint64_t digits = 0;
        const char* last = at_;
        while (last != end_ && is_digit(*last) && last - at_ < 16)
            digits = 10 * digits + static_cast<uint64_t>(*last++ - '0');
        size_t places = 0;
        if (last != end_ && *last == '.') {
            ++last;
            while (last != end_ && is_digit(*last) && last - at_ < 16) {
                digits = 10 * digits + static_cast<uint64_t>(*last++ - '0');
                ++places;
            }
        }
        if (last - at_ >= 16) return false;
        if (last != end_ && (*last == '.' || *last == 'e' || *last == 'E')) return false;
        lexer_.add_number({at_, static_cast<size_t>(last - at_)},
                          static_cast<double>(digits) / powers[places]);
        at_ = last;
        return true;
    }

    void leave_to_grammar() {
        CharacterInput in(at_, end_, std::string_view{});
        pegtl::parse<lexical::piece, action>(in, lexer_);
        at_ = in.current();
    }

    Lexer& lexer_;
    const char* at_;
    const char* end_;
};

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
    // More than most files need; what is not used takes no memory.
    out->tokens.reserve((end - begin) / 2);
    Lexer lexer(*out, words, options.runs);
    if (options.quick) {
        QuickLexer(lexer, text.data() + begin, text.data() + end).run();
    } else {
        CharacterInput in(text.data() + begin, text.data() + end, std::string_view{});
        pegtl::parse<lexical::file, action>(in, lexer);
    }
    out->tokens.push_back({static_cast<uint32_t>(end), 0, 0, Tok::end});
    link_branches(*out);
    return out;
}

}  // namespace rb
