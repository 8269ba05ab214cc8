// Directives other than declarations, loops and files.
#include "language/find_file.h"
#include "language/parser.h"
#include "language/read.h"

#include <cmath>

#include <fmt/format.h>

namespace rb {

/// Counts a directive while it is carried out.
class TokenStream::Executing {
public:
    explicit Executing(int& count) : count_(count) { ++count_; }
    Executing(const Executing&) = delete;
    Executing& operator=(const Executing&) = delete;
    ~Executing() { --count_; }

private:
    int& count_;
};

void TokenStream::execute(uint32_t word, SourceRange where, uint32_t hash) {
    // A loop whose last directive wants a value that is not there would begin again within itself.
    constexpr int deepest = 400;
    if (executing_ >= deepest) session_.fail(where, "Too many nested directives.");
    const Executing executing(executing_);
    // Other directives may stand between #switch and its first #case.
    const bool waiting = before_first_case_;
    const size_t conds = conds_.size();
    before_first_case_ = false;
    const size_t frame = frames_.size();
    try {
        dispatch(word, where, hash);
    } catch (const SceneError&) {
        // A conditional, loop or macro whose head is wrong is left out as a whole.
        const bool opens = Words::is_keyword(word) && opens_branches(static_cast<Keyword>(word));
        if (opens && frames_.size() == frame && token_at(hash).aux > hash) {
            pushback_.clear();
            jump(end_of(hash, where) + 2);
        }
        throw;
    }
    const bool decides = word == word_of(Keyword::case_) || word == word_of(Keyword::range);
    if (waiting && !decides && conds_.size() >= conds) before_first_case_ = true;
}

void TokenStream::dispatch(uint32_t word, SourceRange where, uint32_t hash) {
    if (!Words::is_keyword(word)) {
        session_.fail(where, fmt::format("Unknown directive '#{}'{}", session_.words.spelling(word),
                                         session_.hint(session_.words.spelling(word))));
    }
    switch (static_cast<Keyword>(word)) {
        case Keyword::include:
            return do_include(where);
        case Keyword::declare:
        case Keyword::local:
            return do_declare(word == word_of(Keyword::local), where);
        case Keyword::undef:
            return do_undef();
        case Keyword::default_:
            return do_default(where);
        case Keyword::version:
            return do_version(where);
        case Keyword::if_:
            return do_if(hash, where);
        case Keyword::ifdef:
        case Keyword::ifndef:
            return do_ifdef(word == word_of(Keyword::ifdef), hash, where);
        case Keyword::else_:
            return do_else(hash, where);
        case Keyword::elseif:
            return do_elseif(hash, where);
        case Keyword::switch_:
            return do_switch(hash, where);
        case Keyword::case_:
        case Keyword::range:
            return do_case(word == word_of(Keyword::range), hash, where);
        case Keyword::while_:
            return do_while(hash, where);
        case Keyword::for_:
            return do_for(hash, where);
        case Keyword::end:
            return do_end(where);
        case Keyword::break_:
            return do_break(where);
        case Keyword::macro:
            return do_macro(hash, where);
        case Keyword::fopen:
            return do_fopen(where);
        case Keyword::fclose:
            return do_fclose();
        case Keyword::read:
            return do_read(where);
        case Keyword::write:
            return do_write(where);
        case Keyword::debug:
        case Keyword::warning:
        case Keyword::error:
        case Keyword::render:
        case Keyword::statistics:
            return execute_message(word, where);
        default:
            session_.fail(where, fmt::format("Unknown directive '#{}'", session_.words.spelling(word)));
    }
}

namespace {

void debug(Session& session, std::string_view stream, std::string text) {
    if (text.size() > 200) text = text.substr(0, 156) + "...";
    session.debug_line += text;
    while (true) {
        const size_t line_end = session.debug_line.find('\n');
        if (line_end != std::string::npos) {
            session.message(stream, std::string_view(session.debug_line).substr(0, line_end + 1));
            session.debug_line.erase(0, line_end + 1);
        } else if (session.debug_line.size() > 160) {
            session.message(stream, session.debug_line.substr(0, 160) + "\n");
            session.debug_line.erase(0, 160);
        } else {
            break;
        }
    }
}

}  // namespace

void TokenStream::execute_message(uint32_t word, SourceRange where) {
    std::string text;
    {
        Parser parser(session_);
        text = parser.text();
    }
    const auto directive = static_cast<Keyword>(word);
    if (directive == Keyword::debug) return debug(session_, "debug", std::move(text));
    if (directive == Keyword::render || directive == Keyword::statistics) {
        return debug(session_, session_.words.spelling(word), std::move(text));
    }
    if (text.size() > 160) text = text.substr(0, 124) + "...";
    if (directive == Keyword::error) session_.fail(where, "Parse halted by #error directive: " + text);
    Diagnostic said{Severity::warning, where, text, trail()};
    session_.diagnostics.report(std::move(said));
}

void TokenStream::do_include(SourceRange where) {
    std::string name;
    SourceRange at;
    {
        Parser parser(session_);
        at = parser.peek().where;
        name = parser.file_name();
    }
    const auto path = find_file(session_, name, SoughtFile::include, at);
    if (!path) {
        throw missing_file(session_, name, SoughtFile::include, at,
                           fmt::format("Cannot open include file {}.", name));
    }
    open_file(session_.tokens_of(*path), cover(where, at), true);
}

void TokenStream::do_undef() {
    const SourceRange where = range(raw_peek());
    const uint32_t name = raw_name("identifier");
    if (raw_peek().kind == Tok::lbracket) {
        const Place place = session_.symbols.find_place(name);
        if (place.known() && std::holds_alternative<ArrayPtr>(place.value())) {
            raw_element(place, where).value() = std::monostate{};
            return;
        }
    }
    if (!session_.symbols.remove(name)) {
        session_.warn(
            where, fmt::format("Attempt to undef unknown identifier '{}'.", session_.words.spelling(name)));
    }
}

void TokenStream::do_version(SourceRange where) {
    Parser parser(session_);
    if (parser.at_word(Keyword::unofficial)) parser.take();
    parser.lock(true);
    const double value = parser.number();
    if (value > 3.70 + 1e-9) {
        session_.fail(where, fmt::format("Your scene file requires POV-Ray version {:g} or later!", value));
    }
    session_.language_version = static_cast<int>(100 * value + 0.5);
    session_.version_seen = true;
    if (!session_.noise_generator_set) session_.set_noise_generator(session_.language_version < 350 ? 1 : 2);
    if (!parser.take_if(Tok::semicolon)) session_.warn(where, "Expected ';' after #version");
}

void TokenStream::do_default(SourceRange) {
    Parser parser(session_);
    const SourceRange at = parser.peek().where;
    Produced keyword{Tok::keyword, word_of(Keyword::default_), 0, at, {}};
    const auto block = parser.block(keyword);
    read_default(session_, *block);
}

void TokenStream::check_cond(Cond::Kind kind, SourceRange where, std::string_view what) {
    if (!has_cond() || conds_.back().kind != kind) {
        session_.fail(where, fmt::format("Mis-matched '#{}'.", what));
    }
}

uint32_t TokenStream::skip_from(uint32_t hash, SourceRange where) {
    const uint32_t next = token_at(hash).aux;
    if (next == 0) {
        top().at = top().end;
        session_.fail(where, "End of file reached but #end expected.");
    }
    for (const LexicalError& error : top().tokens->errors) {
        if (error.token > hash && error.token < next)
            session_.fail(range(token_at(error.token)), error.message);
    }
    return next;
}

uint32_t TokenStream::end_of(uint32_t hash, SourceRange where) {
    uint32_t at = skip_from(hash, where);
    while (token_at(at + 1).aux != word_of(Keyword::end)) at = skip_from(at, where);
    return at;
}

void TokenStream::jump(uint32_t to) { top().at = to; }

/// Looks for the next branch that is read: `cond.hash` is the `#` of the branch that is not.
void TokenStream::skip_branches(Cond cond, SourceRange where) {
    while (true) {
        const uint32_t next = skip_from(cond.hash, where);
        const auto word = static_cast<Keyword>(token_at(next + 1).aux);
        jump(next + 2);
        cond.hash = next;
        if (word == Keyword::end) return;
        if (word == Keyword::else_) {
            cond.taken = true;
            conds_.push_back(cond);
            return;
        }
        const SourceRange at = range(token_at(next + 1));
        bool reads = false;
        if (word == Keyword::elseif) {
            reads = std::abs(condition()) > 1e-10;
        } else {
            Parser parser(session_);
            const bool is_range = word == Keyword::range;
            const auto values = parser.numbers_in_parentheses(is_range ? 2 : 1, is_range ? 2 : 1);
            reads = is_range ? values[0] <= cond.value && cond.value <= values[1]
                             : std::abs(values[0] - cond.value) < 1e-10;
        }
        if (reads) {
            cond.taken = true;
            conds_.push_back(cond);
            return;
        }
        where = at;
    }
}

void TokenStream::do_if(uint32_t hash, SourceRange where) {
    if (conds_.size() >= 200) session_.fail(where, "Too many nested conditionals or loops.");
    const size_t frame = frames_.size();
    const double value = condition();
    if (frames_.size() != frame) session_.fail(where, "#if did not end in the file where it started.");
    Cond cond;
    cond.hash = hash;
    if (std::abs(value) > 1e-10) {
        cond.taken = true;
        conds_.push_back(cond);
    } else {
        skip_branches(cond, where);
    }
}

bool TokenStream::defined_in_parentheses() {
    raw_expect(Tok::lparen, "(");
    const Token token = raw_next();
    bool set = false;
    if (token.kind != Tok::word) {
        session_.fail(range(token), fmt::format("Expected 'identifier', {} found instead", found(token)));
    }
    Place place = session_.symbols.find_place(token.aux);
    set = place.known() && is_set(place.value());
    if (raw_peek().kind == Tok::lbracket && place.known() &&
        std::holds_alternative<ArrayPtr>(place.value())) {
        place = raw_element(place, range(token));
        set = is_set(place.value());
    }
    raw_expect(Tok::rparen, ")");
    return set;
}

bool defined_name(Session& session) { return session.stream.defined_in_parentheses(); }

void TokenStream::do_ifdef(bool wanted, uint32_t hash, SourceRange where) {
    if (conds_.size() >= 200) session_.fail(where, "Too many nested conditionals or loops.");
    Cond cond;
    cond.hash = hash;
    if (defined_in_parentheses() == wanted) {
        cond.taken = true;
        conds_.push_back(cond);
    } else {
        skip_branches(cond, where);
    }
}

void TokenStream::do_else(uint32_t hash, SourceRange where) {
    if (has_cond() && conds_.back().kind == Cond::Kind::switch_) {
        // A matched case falls through into the #else body too.
        conds_.back().hash = hash;
        return;
    }
    check_cond(Cond::Kind::if_, where, "else");
    const uint32_t end = end_of(conds_.back().hash, where);
    conds_.pop_back();
    jump(end + 2);
}

void TokenStream::do_elseif(uint32_t, SourceRange where) {
    check_cond(Cond::Kind::if_, where, "elseif");
    const uint32_t end = end_of(conds_.back().hash, where);
    conds_.pop_back();
    jump(end + 2);
}

void TokenStream::do_switch(uint32_t hash, SourceRange where) {
    if (conds_.size() >= 200) session_.fail(where, "Too many nested conditionals or loops.");
    Cond cond;
    cond.kind = Cond::Kind::switch_;
    cond.hash = hash;
    cond.before_first_case = true;
    {
        Parser parser(session_);
        cond.value = parser.condition();
    }
    conds_.push_back(cond);
    before_first_case_ = true;
}

void TokenStream::do_case(bool is_range, uint32_t hash, SourceRange where) {
    if (!has_cond() || conds_.back().kind != Cond::Kind::switch_) {
        session_.fail(where, "Mis-matched '#case' or '#range'.");
    }
    before_first_case_ = false;
    double low = 0;
    double high = 0;
    {
        Parser parser(session_);
        const auto values = parser.numbers_in_parentheses(is_range ? 2 : 1, is_range ? 2 : 1);
        low = values.front();
        high = values.back();
    }
    Cond& cond = conds_.back();
    cond.hash = hash;
    cond.before_first_case = false;
    if (cond.taken) return;
    if (is_range ? low <= cond.value && cond.value <= high : std::abs(low - cond.value) < 1e-10) {
        cond.taken = true;
        return;
    }
    const Cond waiting = cond;
    conds_.pop_back();
    skip_branches(waiting, where);
}

void TokenStream::read_macro_head(Macro& macro) {
    raw_expect(Tok::lparen, "(");
    while (raw_peek().kind != Tok::rparen) {
        Token token = raw_next();
        // `optional` is no reserved word: alone it is the name of a parameter.
        const bool optional = token.kind == Tok::word && raw_peek().kind == Tok::word &&
                              session_.words.spelling(token.aux) == "optional";
        if (optional) token = raw_next();
        const bool slot_word = token.kind == Tok::word;
        if (!slot_word || (Words::is_keyword(token.aux) && Words::kind(token.aux) != Tok::keyword)) {
            session_.fail(range(token), fmt::format("Expected 'identifier', {} found instead", found(token)));
        }
        macro.parameters.push_back(token.aux);
        macro.optional.push_back(optional);
        if (macro.parameters.size() > 55) session_.fail(range(token), "Too many parameters");
        if (raw_peek().kind == Tok::comma) raw_next();
    }
    raw_expect(Tok::rparen, ")");
}

void TokenStream::do_macro(uint32_t hash, SourceRange where) {
    if (session_.language_version < 310) session_.fail(where, "Macros require #version 3.1 or later.");
    auto macro = std::make_shared<Macro>();
    const uint32_t end = skip_from(hash, where);
    const SourceRange at = range(raw_peek());
    const uint32_t name = raw_name("undeclared identifier");
    macro->name = std::string(session_.words.spelling(name));
    const Place known = session_.symbols.find_place(name);
    const bool macro_before = known.known() && std::holds_alternative<MacroPtr>(known.value());
    if (known.known() && !macro_before) {
        session_.fail(
            at, fmt::format("Expected 'undeclared identifier', {} found instead", kind_name(known.value())));
    }
    try {
        read_macro_head(*macro);
    } catch (const SceneError&) {
        if (!session_.symbols.find(name)) session_.symbols.create_global(name)->value = Poison{};
        throw;
    }
    macro->file = top().tokens;
    macro->body_begin = top().at;
    macro->body_end = end;
    jump(macro->body_end + 2);
    const SlotPtr slot = macro_before ? known.slot : session_.symbols.create_global(name);
    slot->value = MacroPtr(std::move(macro));
}

}  // namespace rb
