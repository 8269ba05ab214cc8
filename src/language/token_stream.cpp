#include "language/token_stream.h"

#include "language/parser.h"

#include <algorithm>

#include <fmt/format.h>

namespace rb {

Produced TokenStream::next() {
    while (true) {
        if (!pushback_.empty()) {
            Produced token = std::move(pushback_.back());
            pushback_.pop_back();
            if (token.kind != Tok::hash || locked) return token;
            const Token word = raw_next();
            execute(word.kind == Tok::word ? word.aux : 0xffffffff, cover(token.where, range(word)),
                    token.word);
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
            if (locked) return hash;
            const Token word = raw_next();
            execute(word.kind == Tok::word ? word.aux : 0xffffffff, cover(hash.where, range(word)), index);
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
        if (const auto* macro = std::get_if<MacroPtr>(&out.place.value()); macro && !quiet) {
            call(*macro, out.where);
            return false;
        }
        return true;
    }
    if (token.kind == Tok::invalid) {
        const auto& errors = top().tokens->errors;
        const auto index = static_cast<uint32_t>(&token - top().tokens->tokens.data());
        for (const LexicalError& error : errors) {
            if (error.token == index) session_.fail(out.where, error.message);
        }
    }
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

void TokenStream::call(const MacroPtr& macro, SourceRange where) {
    std::vector<Operand> arguments;
    {
        Parser parser(session_);
        parser.expect(Tok::lparen, "(");
        for (size_t i = 0; i < macro->parameters.size(); ++i) {
            if (parser.peek().kind == Tok::rparen) {
                session_.fail(parser.peek().where, fmt::format("Expected {} parameters but only {} found.",
                                                               macro->parameters.size(), i));
            }
            if (parser.peek().kind == Tok::undeclared) {
                session_.fail(
                    parser.peek().where,
                    "Cannot pass uninitialized identifier as macro parameter. Initialize identifier first.");
            }
            parser.lock(true);
            arguments.push_back(parser.rvalue());
            parser.take_if(Tok::comma);
            parser.lock(false);
        }
        parser.lock(true);
        parser.expect(Tok::rparen, ")");
    }
    if (session_.symbols.depth() >= Symbols::limit) session_.fail(where, "Too many nested symbol tables");
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
    frame.at = macro->body_begin;
    frame.end = macro->body_end;
    frame.conds = conds_.size();
    frame.own_table = true;
    frame.called = where;
    frame.name = macro->name;
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

void TokenStream::mark() {
    marked_frames_ = frames_.size();
    marked_at_ = frames_.empty() ? 0 : top().at;
}

void TokenStream::recover() {
    pushback_.clear();
    locked = quiet = before_first_case_ = false;
    // Leave macro calls: the statement that called them is lost.
    while (frames_.size() > 1 && top().kind != Frame::Kind::file) {
        conds_.resize(std::min(conds_.size(), top().conds));
        if (top().own_table) session_.symbols.close();
        frames_.pop_back();
    }
    if (frames_.empty()) return;
    Frame& frame = top();
    const bool same_frame = frames_.size() == marked_frames_;
    int depth = 0;
    const auto weigh = [&](const Token& token) {
        if (token.kind == Tok::lbrace) ++depth;
        if (token.kind == Tok::rbrace) --depth;
    };
    if (same_frame && marked_at_ <= frame.at) {
        for (uint32_t i = marked_at_; i < frame.at; ++i) weigh(frame.tokens->tokens[i]);
    }
    while (frame.at < frame.end && depth > 0) weigh(frame.tokens->tokens[frame.at++]);
    // Then on to something that can begin a statement or a directive.
    while (frame.at < frame.end) {
        const Token& token = frame.tokens->tokens[frame.at];
        if (token.kind == Tok::hash) break;
        const bool block_follows = frame.tokens->tokens[frame.at + 1].kind == Tok::lbrace;
        if (token.kind == Tok::word && Words::kind(token.aux) == Tok::keyword && block_follows) break;
        ++frame.at;
    }
}

}  // namespace rb
