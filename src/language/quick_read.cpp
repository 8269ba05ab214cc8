// What the token stream reads without the grammar, as long as it is plain.
#include "language/parser.h"
#include "language/quick_expression.h"
#include "language/read.h"

namespace rb {

namespace {

/// The grammar's limit is 250 levels.
constexpr int deepest_quick = 200;

/// Reading the token again gives the same and has no other effect.
bool is_repeatable(const Produced& token) {
    switch (token.kind) {
        case Tok::end:
        case Tok::undeclared:
        case Tok::lbrace:
        case Tok::rbrace:
        case Tok::hash:
        case Tok::invalid:
            return false;
        case Tok::name:
            return token.place.slot->deprecated.empty() &&
                   !std::holds_alternative<MacroPtr>(token.place.value());
        default:
            return true;
    }
}

}  // namespace

bool TokenStream::reads_plainly() const {
    return pushback_.empty() && !before_first_case_ && !frames_.empty() &&
           session_.options.quick_expressions && session_.nesting < deepest_quick;
}

bool TokenStream::unread(const Produced& token) {
    if (!reads_plainly() || !is_repeatable(token)) return false;
    Frame& frame = top();
    if (frame.at <= frame.begin || frame.tokens->file != token.where.file) return false;
    const Token& last = frame.tokens->tokens[frame.at - 1];
    if (last.begin != token.where.begin || last.begin + last.size != token.where.end) return false;
    --frame.at;
    --produced_;
    return true;
}

/// `take(expression)` takes over what was read.
template <class Take>
bool TokenStream::quick(Level level, std::initializer_list<Tok> ends, Take&& take) {
    if (!reads_plainly()) return false;
    Frame& frame = top();
    uint32_t end = frame.end;
    if (const uint64_t most = session_.options.max_tokens; most != 0) {
        end = static_cast<uint32_t>(std::min<uint64_t>(end, frame.at + (most - std::min(most, produced_))));
    }
    if (frame.at >= end) return false;
    QuickExpression expression(session_, *frame.tokens, frame.at, end);
    if (level == Level::color) expression.leave_channels();
    if (!(level == Level::sum ? expression.read_sum(ends) : expression.read_full(ends))) return false;
    take(expression);
    produced_ += expression.at() - frame.at;
    frame.at = expression.at();
    return true;
}

bool TokenStream::quick_operand(Level level, std::initializer_list<Tok> ends, Operand& out) {
    return quick(level, ends, [&](const QuickExpression& expression) {
        out.value = expression.terms();
        out.place = expression.place();
        out.where = expression.where();
    });
}

bool TokenStream::quick_terms(Terms& out, SourceRange& where) {
    return quick(Level::sum, {}, [&](const QuickExpression& expression) {
        out = expression.terms();
        where = expression.where();
    });
}

bool TokenStream::quick_open(Produced& word) {
    if (!reads_plainly()) return false;
    Frame& frame = top();
    if (frame.at + 1 >= frame.end) return false;
    const Token* const tokens = frame.tokens->tokens.data() + frame.at;
    if (tokens[0].kind != Tok::word || tokens[1].kind != Tok::lbrace) return false;
    if (Words::kind(tokens[0].aux) != Tok::keyword) return false;
    word.kind = Tok::keyword;
    word.word = tokens[0].aux;
    word.where = frame.tokens->range(tokens[0]);
    frame.at += 2;
    produced_ += 2;
    ++open_braces_;
    return true;
}

bool TokenStream::quick_at_statement() const {
    if (quick_peek() != Tok::word) return false;
    const uint32_t word = top().tokens->tokens[top().at].aux;
    return Words::is_keyword(word) && begins_statement(session_.words.spelling(word));
}

bool TokenStream::quick_brace() {
    if (!quick_take(Tok::lbrace)) return false;
    ++open_braces_;
    return true;
}

bool TokenStream::quick_close(SourceRange& where) {
    if (quick_peek() != Tok::rbrace) return false;
    Frame& frame = top();
    where = frame.tokens->range(frame.tokens->tokens[frame.at++]);
    ++produced_;
    --open_braces_;
    return true;
}

bool TokenStream::quick_take(Tok kind) {
    if (!reads_plainly()) return false;
    Frame& frame = top();
    if (frame.at >= frame.end || frame.tokens->tokens[frame.at].kind != kind) return false;
    ++frame.at;
    ++produced_;
    return true;
}

Tok TokenStream::quick_peek() const {
    if (!reads_plainly() || top().at >= top().end) return Tok::end;
    return top().tokens->tokens[top().at].kind;
}

/// Nothing happens when the token is produced.
bool TokenStream::is_plain(const Token& token) const {
    if (token.kind == Tok::hash || token.kind == Tok::invalid) return false;
    if (token.kind != Tok::word || Words::is_keyword(token.aux)) return true;
    const Place* place = session_.symbols.look(token.aux);
    return !place || (place->slot->deprecated.empty() && !std::holds_alternative<MacroPtr>(place->value()));
}

bool TokenStream::quick_word(Produced& out) {
    if (!reads_plainly()) return false;
    Frame& frame = top();
    if (frame.at + 1 >= frame.end) return false;
    const Token* const tokens = frame.tokens->tokens.data() + frame.at;
    if (tokens[0].kind != Tok::word || Words::kind(tokens[0].aux) != Tok::keyword) return false;
    switch (static_cast<Keyword>(tokens[0].aux)) {
        case Keyword::gamma:
        case Keyword::assumed_gamma:
        case Keyword::pwr:
        case Keyword::xyz:
        case Keyword::radius:
            return false;
        default:
            break;
    }
    if (tokens[1].kind == Tok::lbrace || !is_plain(tokens[1])) return false;
    out = {Tok::keyword, tokens[0].aux, 0, frame.tokens->range(tokens[0]), {}};
    ++frame.at;
    ++produced_;
    return true;
}

bool TokenStream::quick_color(Produced& first, Produced& word, Operand& base) {
    if (!reads_plainly()) return false;
    Frame& frame = top();
    const uint32_t start = frame.at;
    const auto take = [&](Tok kind, Produced& out) {
        if (frame.at >= frame.end) return false;
        const Token& token = frame.tokens->tokens[frame.at];
        if (token.kind != Tok::word || Words::kind(token.aux) != kind) return false;
        out = {kind, token.aux, 0, frame.tokens->range(token), {}};
        ++frame.at;
        ++produced_;
        return true;
    };
    const bool has_color = take(Tok::color, first);
    if (take(Tok::rgb, word)) {
        if (!has_color) first = word;
        if (quick_operand(Level::color, {}, base)) return true;
    }
    produced_ -= frame.at - start;
    frame.at = start;
    return false;
}

double TokenStream::condition() {
    Operand value;
    if (quick_take(Tok::lparen)) {
        if (quick_full(value, {Tok::rparen})) {
            quick_take(Tok::rparen);
            return to_float(value);
        }
        --top().at;
        --produced_;
    }
    Parser parser(session_);
    return parser.condition();
}

/// An identifier alone, of whatever kind: it stands for its place.
bool TokenStream::quick_argument(Operand& out) {
    if (!reads_plainly()) return false;
    Frame& frame = top();
    if (frame.at + 1 >= frame.end) return false;
    const Token* const tokens = frame.tokens->tokens.data() + frame.at;
    const bool alone = tokens[1].kind == Tok::comma || tokens[1].kind == Tok::rparen;
    if (!alone || tokens[0].kind != Tok::word || Words::is_keyword(tokens[0].aux)) return false;
    const Place* place = session_.symbols.look(tokens[0].aux);
    if (!place || !place->slot->deprecated.empty()) return false;
    const Value& value = place->value();
    if (!is_set(value) || std::holds_alternative<MacroPtr>(value) || std::holds_alternative<Poison>(value) ||
        is_function(value))
        return false;
    out.place = *place;
    out.where = frame.tokens->range(tokens[0]);
    ++frame.at;
    ++produced_;
    return true;
}

/// As many arguments as are plain; true if these are all, and their parenthesis is closed.
bool TokenStream::quick_arguments(const Macro& macro, std::vector<Operand>& arguments) {
    while (arguments.size() < macro.parameters.size()) {
        Operand argument;
        if (!quick_argument(argument) && !quick_sum(argument, {Tok::comma, Tok::rparen})) return false;
        arguments.push_back(std::move(argument));
        quick_take(Tok::comma);
    }
    return quick_take(Tok::rparen);
}

}  // namespace rb
