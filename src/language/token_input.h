#pragma once
#include "language/session.h"

#include <algorithm>
#include <array>
#include <exception>

#include <tao/pegtl.hpp>

namespace rb {

/// The token stream as a PEGTL input: the iterator is the number of a token; tokens are produced when they
/// are looked at, and rewinding moves the number. Only the last few tokens are kept: the grammar looks ahead
/// by one token (two behind a word), so it never rewinds further.
class TokenInput {
public:
    using iterator_t = size_t;

    struct action_t {
        action_t(const size_t& begin, const TokenInput& input) : begin_(begin), input_(input) {}
        const Produced& first() const { return input_.token(begin_); }
        const TokenInput& input() const { return input_; }

    private:
        size_t begin_;
        const TokenInput& input_;
    };

    explicit TokenInput(Session& session) : session_(session) {}
    TokenInput(const TokenInput&) = delete;
    TokenInput& operator=(const TokenInput&) = delete;
    ~TokenInput() {
        // An error makes the grammar's rules rewind, but what they took is gone.
        if (std::uncaught_exceptions() > exceptions_) at_ = std::max(at_, taken_);
        while (produced_ > at_) session_.stream.give_back(std::move(ring_[--produced_ % kept]));
    }

    template <tao::pegtl::rewind_mode M>
    tao::pegtl::internal::marker<iterator_t, M> mark() {
        return tao::pegtl::internal::marker<iterator_t, M>(at_);
    }

    const Produced& peek() {
        if (at_ == produced_) {
            produce();
        } else if (at_ + 1 == produced_ && last().waiting && session_.stream.is_pending(last())) {
            // A directive or macro that was only looked at runs now.
            session_.stream.give_back(std::move(ring_[--produced_ % kept]));
            produce();
        }
        return ring_[at_ % kept];
    }
    Tok kind() { return peek().kind; }
    bool at_keyword(Keyword keyword) {
        const Produced& token = peek();
        return token.kind != Tok::number && token.kind != Tok::hash && token.kind != Tok::run &&
               token.word == word_of(keyword) && token.kind == Words::kind(token.word);
    }
    void bump() { taken_ = std::max(taken_, ++at_); }
    const Produced& token(size_t number) const { return ring_[number % kept]; }
    const Produced& previous() const { return ring_[(at_ - 1) % kept]; }
    const Produced& current() const { return ring_[at_ % kept]; }

    void produce_unlocked() {
        const bool locked = session_.stream.locked;
        session_.stream.locked = false;
        peek();
        session_.stream.locked = locked;
    }
    /// A plain expression without the grammar; false: nothing was read.
    template <class State>
    bool take_quick(bool full, State& state) {
        if (at_ != produced_ && !(may_begin_quick(ring_[at_ % kept].kind) && steps_back())) return false;
        Operand operand;
        TokenStream& stream = session_.stream;
        if (!(full ? stream.quick_full(operand) : stream.quick_sum(operand))) return false;
        ring_[at_ % kept] = {Tok::number, 0, 0, operand.where, {}};
        bump();
        produced_ = at_;
        state.push(std::move(operand));
        return true;
    }
    /// An item of a block that is plain, and the comma behind it; false: nothing was read.
    template <class State>
    bool take_quick_item(State& state) {
        if (at_ != produced_ && !(may_be_quick_item() && steps_back())) return false;
        TokenStream& stream = session_.stream;
        if (Tok kind = stream.quick_peek(); kind == Tok::rbrace || kind == Tok::hash) return false;
        Terms terms;
        SourceRange where;
        if (stream.quick_terms(terms, where)) {
            state.add_terms(terms, where);
        } else if (Produced word; stream.quick_word(word)) {
            state.add_word(word);
        } else if (!take_quick_color(state)) {
            return false;
        }
        stream.quick_take(Tok::comma);
        return true;
    }
    /// `keyword {` of a statement; false: nothing was read.
    bool take_quick_statement(Produced& keyword) {
        TokenStream& stream = session_.stream;
        return at_ == produced_ && stream.quick_at_statement() && stream.quick_open(keyword);
    }
    /// The brace behind the keyword of a statement.
    bool take_quick_brace() { return at_ == produced_ && session_.stream.quick_brace(); }
    /// `keyword {`; false: nothing was read.
    template <class State>
    bool take_quick_open(State& state) {
        Produced word;
        if (at_ != produced_ && !(ring_[at_ % kept].kind == Tok::keyword && steps_back())) return false;
        if (!session_.stream.quick_open(word)) return false;
        state.open_block(session_.words.spelling(word.word), word.where);
        return true;
    }
    /// The `}` of a block; false: nothing was read.
    template <class State>
    bool take_quick_close(State& state) {
        SourceRange where;
        if (at_ != produced_ || !session_.stream.quick_close(where)) return false;
        state.close_inner_block(where);
        return true;
    }
    void take_quick_comma() {
        if (at_ == produced_) session_.stream.quick_take(Tok::comma);
    }
    void open_run() {
        const SourceRange where = peek().where;
        --produced_;
        session_.stream.open_run(where);
    }
    bool take_defined();

    class Quiet {
    public:
        explicit Quiet(Session& session) : session_(session), quiet_(session.stream.quiet) {
            session.stream.quiet = true;
        }
        Quiet(const Quiet&) = delete;
        Quiet& operator=(const Quiet&) = delete;
        ~Quiet() { session_.stream.quiet = quiet_; }

    private:
        Session& session_;
        bool quiet_;
    };
    Quiet be_quiet() { return Quiet(session_); }

    /// Inside brackets nothing is locked, and depth is limited.
    class Level {
    public:
        explicit Level(Session& session) : session_(session), locked_(session.stream.locked) {
            session.stream.locked = false;
            ++session.nesting;
        }
        Level(const Level&) = delete;
        Level& operator=(const Level&) = delete;
        ~Level() {
            session_.stream.locked = locked_;
            --session_.nesting;
        }

    private:
        Session& session_;
        bool locked_;
    };
    Level enter() {
        if (session_.nesting >= nesting_limit) {
            session_.fail(peek().where, "Expressions and blocks are nested too deeply.");
        }
        return Level(session_);
    }

    Session& session() const { return session_; }

private:
    static constexpr size_t kept = 16;
    static constexpr int nesting_limit = 250;

    bool may_be_quick_item() const {
        const Tok kind = ring_[at_ % kept].kind;
        if (kind == Tok::keyword) return session_.stream.quick_peek() != Tok::lbrace;
        return kind == Tok::color || kind == Tok::rgb || may_begin_quick(kind);
    }
    template <class State>
    bool take_quick_color(State& state) {
        Produced first;
        Produced word;
        Operand operand;
        if (!state.colors_allowed() || !session_.stream.quick_color(first, word, operand)) return false;
        state.open_color(first.where);
        if (first.kind == Tok::color) state.add_color_word();
        state.set_color_word(word);
        state.push(std::move(operand));
        state.add_rgb_base();
        state.add_color();
        return true;
    }
    static bool may_begin_quick(Tok kind) {
        switch (kind) {
            case Tok::number:
            case Tok::name:
            case Tok::constant:
            case Tok::call_one:
            case Tok::call_many:
            case Tok::lparen:
            case Tok::langle:
            case Tok::plus:
            case Tok::minus:
            case Tok::bang:
                return true;
            default:
                return false;
        }
    }
    /// True if the stream stands at the current token (again).
    bool steps_back() {
        if (at_ == produced_) return true;
        if (at_ + 1 != produced_ || !session_.stream.unread(ring_[at_ % kept])) return false;
        --produced_;
        return true;
    }
    Produced& last() { return ring_[(produced_ - 1) % kept]; }
    void produce() {
        ring_[produced_ % kept] = session_.stream.next();
        ++produced_;
    }

    Session& session_;
    std::array<Produced, kept> ring_;
    size_t at_ = 0;
    size_t produced_ = 0;
    size_t taken_ = 0;  ///< most that at_ has been
    int exceptions_ = std::uncaught_exceptions();
};

}  // namespace rb
