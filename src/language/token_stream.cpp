#include "language/token_stream.h"

#include "language/parser.h"
#include "language/read.h"

#include <algorithm>

#include <fmt/format.h>

namespace rb {

Produced TokenStream::next() {
    while (true) {
        if (!pushback_.empty()) {
            Produced token = std::move(pushback_.back());
            pushback_.pop_back();
            if (!is_pending(token)) return token;
            if (token.kind == Tok::hash) {
                run_hash(token);
            } else {
                call(std::get<MacroPtr>(token.place.value()), token.where);
            }
            continue;
        }
        if (frames_.empty()) return {};
        Frame& frame = top();
        if (frame.at >= frame.end) {
            if (frames_.size() == 1 && !has_cond()) {
                const Token& last = frame.tokens->tokens.back();
                return {Tok::end, 0, 0, frame.tokens->range(last), {}};
            }
            close_frame();
            continue;
        }
        const uint32_t index = frame.at++;
        const Token& token = frame.tokens->tokens[index];
        ++produced_;
        if (session_.options.max_tokens != 0 && produced_ > session_.options.max_tokens) {
            session_.fail(range(token), "The scene takes too many steps.");
        }
        if (token.kind == Tok::hash) {
            Produced hash{Tok::hash, index, 0, range(token), {}};
            hash.waiting = locked;
            if (locked) return hash;
            run_hash(hash);
            continue;
        }
        if (before_first_case_) {
            before_first_case_ = false;
            session_.fail(range(token), "#switch not followed by #case or #range.");
        }
        Produced out;
        if (resolve(token, out)) return out;
    }
}

bool TokenStream::is_pending(const Produced& token) const {
    if (!token.waiting) return false;
    if (token.kind == Tok::hash) return !locked;
    return token.kind == Tok::name && !quiet && !locked &&
           std::holds_alternative<MacroPtr>(token.place.value());
}

void TokenStream::run_hash(const Produced& hash) {
    const Token word = raw_peek();
    const bool is_word = word.kind == Tok::word && word.begin == hash.where.end;
    const bool keyword = word.kind == Tok::word && Words::is_keyword(word.aux);
    if (!keyword && !is_word) {
        session_.warn(hash.where, "A '#' that begins no directive is ignored.");
        return;
    }
    raw_next();
    execute(word.aux, cover(hash.where, range(word)), hash.word);
}

bool TokenStream::resolve(const Token& token, Produced& out) {
    out.kind = token.kind;
    out.where = range(token);
    if (token.kind == Tok::number) {
        out.number = top().tokens->numbers[token.aux];
        return true;
    }
    if (token.kind == Tok::word) {
        out.word = token.aux;
        if (Words::is_keyword(token.aux)) {
            out.kind = Words::kind(token.aux);
            return true;
        }
        out.place = session_.symbols.find_place(token.aux);
        out.kind = out.place.known() ? Tok::name : Tok::undeclared;
        if (!out.place.known()) return true;
        if (!out.place.slot->deprecated.empty()) warn_deprecated(*out.place.slot, out);
        if (const auto* macro = std::get_if<MacroPtr>(&out.place.value()); macro && !quiet && !locked) {
            call(*macro, out.where);
            return false;
        }
        out.waiting = (quiet || locked) && std::holds_alternative<MacroPtr>(out.place.value());
        return true;
    }
    if (token.kind == Tok::invalid) {
        const auto& errors = top().tokens->errors;
        const auto index = static_cast<uint32_t>(&token - top().tokens->tokens.data());
        for (const LexicalError& error : errors) {
            if (error.token == index) session_.fail(out.where, error.message);
        }
    }
    if (token.kind == Tok::lbrace) ++open_braces_;
    if (token.kind == Tok::rbrace) --open_braces_;
    out.word = token.aux;
    return true;
}

void TokenStream::warn_deprecated(Slot& slot, const Produced& at) {
    session_.warn(at.where, slot.deprecated);
    if (slot.deprecated_once) slot.deprecated.clear();
}

void TokenStream::open_file(TokenFilePtr tokens, SourceRange included_at, bool own_table) {
    if (include_depth() >= 32) session_.fail(included_at, "Too many nested include files.");
    if (own_table) {
        if (session_.symbols.depth() >= Symbols::limit)
            session_.fail(included_at, "Too many nested symbol tables");
        session_.symbols.open();
    }
    Frame frame;
    frame.kind = Frame::Kind::file;
    frame.end = static_cast<uint32_t>(tokens->tokens.size()) - 1;
    frame.tokens = std::move(tokens);
    frame.conds = conds_.size();
    frame.own_table = own_table;
    frame.called = included_at;
    frames_.push_back(std::move(frame));
}

void TokenStream::open_run(const SourceRange& run) {
    LexOptions options;
    options.runs = false;
    options.begin = run.begin;
    options.end = run.end;
    Frame frame;
    frame.kind = Frame::Kind::list;
    frame.tokens = lex(run.file, session_.sources.text(run.file), session_.words, options);
    frame.end = static_cast<uint32_t>(frame.tokens->tokens.size()) - 1;
    frame.conds = conds_.size();
    frames_.push_back(std::move(frame));
}

void TokenStream::close_frame() {
    Frame& frame = top();
    if (has_cond()) {
        const Token& at = frame.tokens->tokens[conds_.back().hash];
        const SourceRange where = range(at);
        conds_.resize(frame.conds);
        session_.fail(where, "End of file reached but #end expected.");
    }
    if (frame.own_table) session_.symbols.close();
    frames_.pop_back();
}

size_t TokenStream::include_depth() const {
    return static_cast<size_t>(std::count_if(frames_.begin(), frames_.end(),
                                             [](const Frame& f) { return f.kind == Frame::Kind::file; }));
}

void TokenStream::fail_arguments(const Macro& macro, size_t found, SourceRange where) {
    std::string names;
    for (size_t i = 0; i < macro.parameters.size(); ++i) {
        const std::string_view name = session_.words.spelling(macro.parameters[i]);
        names += fmt::format("{}{}{}", names.empty() ? "" : ", ", macro.optional[i] ? "optional " : "", name);
    }
    throw SceneError(where,
                     fmt::format("Expected {} parameters but only {} found.", macro.parameters.size(), found),
                     fmt::format("usage: {}({})", macro.name, names));
}

std::vector<Operand> TokenStream::read_arguments(const Macro& macro) {
    std::vector<Operand> arguments;
    arguments.reserve(macro.parameters.size());
    const bool opened = quick_take(Tok::lparen);
    if (opened && quick_arguments(macro, arguments)) return arguments;
    Parser parser(session_);
    if (!opened) parser.expect(Tok::lparen, "(");
    for (size_t i = arguments.size(); i < macro.parameters.size(); ++i) {
        const Produced& next = parser.peek();
        const bool is_missing = next.kind == Tok::rparen || next.kind == Tok::comma;
        if (is_missing && macro.optional[i]) {
            arguments.emplace_back();
            parser.take_if(Tok::comma);
            continue;
        }
        if (next.kind == Tok::rparen) fail_arguments(macro, i, next.where);
        const SourceRange at = next.where;
        bool is_set = next.kind != Tok::undeclared;
        if (is_set) {
            parser.lock(true);
            arguments.push_back(parser.rvalue());
            is_set = macro.optional[i] || rb::is_set(arguments.back().value);
        }
        if (!is_set) {
            session_.fail(
                at, "Cannot pass uninitialized identifier as macro parameter. Initialize identifier first.");
        }
        // Only a numeric expression keeps the lock on what follows it.
        parser.lock(std::holds_alternative<Terms>(arguments.back().value));
        if (parser.peek().kind == Tok::hash) parser.fail_expected(")");
        parser.take_if(Tok::comma);
        parser.lock(false);
    }
    parser.expect(Tok::rparen, ")");
    return arguments;
}

void TokenStream::call(const MacroPtr& macro, SourceRange where) {
    std::vector<Operand> arguments = read_arguments(*macro);
    if (session_.symbols.depth() >= Symbols::limit) {
        throw SceneError(where, "Too many nested symbol tables",
                         fmt::format("at most {} macro calls and include files nest", Symbols::limit - 2));
    }
    session_.symbols.open();
    for (size_t i = 0; i < arguments.size(); ++i) {
        Operand& argument = arguments[i];
        if (argument.place.known() && !is_function(argument.value)) {
            session_.symbols.alias(macro->parameters[i], argument.place);
        } else {
            session_.symbols.create_local(macro->parameters[i])->value = std::move(argument.value);
        }
    }
    Frame frame;
    frame.kind = Frame::Kind::macro;
    frame.tokens = macro->file;
    frame.begin = frame.at = macro->body_begin;
    frame.end = macro->body_end;
    frame.conds = conds_.size();
    frame.own_table = true;
    frame.called = where;
    frame.name = macro->name;
    frame.braces = open_braces_;
    frames_.push_back(std::move(frame));
}

Token TokenStream::raw_next() {
    while (frames_.size() > 1 && top().at >= top().end && !has_cond()) close_frame();
    Frame& frame = top();
    if (frame.at >= frame.end) return frame.tokens->tokens.back();
    ++produced_;
    return frame.tokens->tokens[frame.at++];
}

Token TokenStream::raw_peek() {
    const Frame& frame = top();
    if (frame.at >= frame.end) return {frame.tokens->tokens.back().begin, 0, 0, Tok::end};
    return frame.tokens->tokens[frame.at];
}

bool TokenStream::operator_follows() {
    const Tok kind = raw_peek().kind;
    return kind == Tok::plus || kind == Tok::minus || kind == Tok::star || kind == Tok::slash;
}

std::string TokenStream::found(const Token& token) {
    Produced out{token.kind, token.aux, 0, range(token), {}};
    if (token.kind == Tok::word) {
        out.kind = Words::kind(token.aux);
        out.place = session_.symbols.find_place(token.aux);
        if (out.place.known()) out.kind = Tok::name;
    }
    return found_text(session_, out);
}

void TokenStream::raw_expect(Tok kind, std::string_view spelling) {
    const Token token = raw_peek();
    if (token.kind != kind) {
        session_.fail(range(token), fmt::format("Expected '{}', {} found instead", spelling, found(token)));
    }
    raw_next();
}

bool TokenStream::take_semicolon() {
    if (!pushback_.empty()) {
        if (pushback_.back().kind != Tok::semicolon) return false;
        pushback_.pop_back();
        return true;
    }
    // A macro may end right before the semicolon that belongs to its last declaration.
    while (frames_.size() > 1 && top().at >= top().end && !has_cond()) close_frame();
    if (raw_peek().kind != Tok::semicolon) return false;
    raw_next();
    return true;
}

uint32_t TokenStream::raw_name(std::string_view expected) {
    const Token token = raw_peek();
    if (token.kind != Tok::word || Words::is_keyword(token.aux)) {
        session_.fail(range(token), fmt::format("Expected '{}', {} found instead", expected, found(token)));
    }
    raw_next();
    return token.aux;
}

std::vector<Diagnostic> TokenStream::trail() const {
    std::vector<Diagnostic> notes;
    for (auto frame = frames_.rbegin(); frame != frames_.rend(); ++frame) {
        if (!frame->called.known()) continue;
        if (notes.size() >= 8) {
            notes.push_back({Severity::note, {}, "...", {}});
            break;
        }
        notes.push_back({Severity::note,
                         frame->called,
                         frame->kind == Frame::Kind::macro
                             ? fmt::format("in the expansion of macro '{}'", frame->name)
                             : std::string("included from here"),
                         {}});
    }
    return notes;
}

void TokenStream::mark() { open_braces_ = 0; }

/// What was looked at but not used is read again.
void TokenStream::rewind_pushback() {
    for (const Produced& token : pushback_) {
        if (token.kind == Tok::lbrace) --open_braces_;
        if (token.kind == Tok::rbrace) ++open_braces_;
        if (frames_.empty() || token.where.file != top().tokens->file) continue;
        const auto& tokens = top().tokens->tokens;
        const auto at = std::lower_bound(tokens.begin(), tokens.end(), token.where.begin,
                                         [](const Token& t, uint32_t begin) { return t.begin < begin; });
        top().at = std::min(top().at, static_cast<uint32_t>(at - tokens.begin()));
    }
    pushback_.clear();
}

void TokenStream::recover() {
    rewind_pushback();
    locked = quiet = before_first_case_ = false;
    // Leave macro calls: the statement that called them is lost.
    while (frames_.size() > 1 && top().kind != Frame::Kind::file) {
        conds_.resize(std::min(conds_.size(), top().conds));
        if (top().own_table) session_.symbols.close();
        if (top().kind == Frame::Kind::macro) open_braces_ = top().braces;
        frames_.pop_back();
    }
    if (frames_.empty()) return;
    Frame& frame = top();
    int depth = open_braces_;
    int level = 0;
    while (frame.at < frame.end && depth > 0) {
        const Token& token = frame.tokens->tokens[frame.at++];
        if (token.kind == Tok::lbrace) ++depth;
        if (token.kind == Tok::rbrace) --depth;
        if (token.kind != Tok::hash) continue;
        // Conditionals and loops that end in the lost part are over.
        const Token& word = frame.tokens->tokens[frame.at];
        const auto keyword = static_cast<Keyword>(word.aux);
        if (word.kind != Tok::word) continue;
        if (keyword == Keyword::end && level-- == 0) {
            level = 0;
            if (has_cond()) conds_.pop_back();
        } else if (opens_branches(keyword)) {
            ++level;
        }
    }
    // Then on to something that can begin a statement or a directive.
    while (frame.at < frame.end) {
        const Token& token = frame.tokens->tokens[frame.at];
        if (token.kind == Tok::hash) break;
        const bool block_follows = frame.tokens->tokens[frame.at + 1].kind == Tok::lbrace;
        if (token.kind == Tok::word && block_follows && begins_statement(session_.words.spelling(token.aux)))
            break;
        ++frame.at;
    }
}

}  // namespace rb
