// #while, #for, #end, #break.
#include "language/parser.h"

#include <cmath>

#include <fmt/format.h>

namespace rb {

/// Evaluates the condition at the loop's head and reads the body or goes on behind it.
void TokenStream::pass_while(const Cond& cond) {
    const SourceRange where = range(token_at(cond.hash));
    const size_t frame = frames_.size();
    jump(cond.resume);
    double value = 0;
    try {
        value = condition();
    } catch (const SceneError&) {
        if (frames_.size() == frame && token_at(cond.hash).aux != 0) jump(end_of(cond.hash, where) + 2);
        throw;
    }
    if (frames_.size() != frame) session_.fail(where, "#while loop did not end in file where it started.");
    if (std::abs(value) > 1e-10) {
        conds_.push_back(cond);
    } else {
        jump(end_of(cond.hash, where) + 2);
    }
}

void TokenStream::do_while(uint32_t hash, SourceRange where) {
    if (conds_.size() >= 200) session_.fail(where, "Too many nested conditionals or loops.");
    Cond cond;
    cond.kind = Cond::Kind::while_;
    cond.hash = hash;
    cond.resume = top().at;
    pass_while(cond);
}

void TokenStream::do_for(uint32_t hash, SourceRange where) {
    if (conds_.size() >= 200) session_.fail(where, "Too many nested conditionals or loops.");
    Cond cond;
    cond.kind = Cond::Kind::for_;
    cond.hash = hash;
    raw_expect(Tok::lparen, "(");
    const SourceRange at = range(raw_peek());
    cond.variable = raw_name("identifier");
    if (raw_peek().kind == Tok::lbracket) {
        session_.fail(at, "#for loop variable must not be an array element");
    }
    std::vector<double> values;
    const size_t frame = frames_.size();
    const bool comma = quick_take(Tok::comma);
    bool closed = false;
    Operand bound;
    while (!closed && values.size() < 3 && quick_sum(bound, {Tok::comma, Tok::rparen})) {
        values.push_back(to_float(bound));
        closed = values.size() >= 2 && quick_take(Tok::rparen);
        if (!closed) quick_take(Tok::comma);
    }
    if (!closed) {
        Parser parser(session_);
        if (!comma && values.empty()) parser.take_if(Tok::comma);
        while (values.size() < 3) {
            parser.lock(true);
            values.push_back(parser.number());
            if (parser.peek().kind == Tok::rparen) break;
            parser.take_if(Tok::comma);
            parser.lock(false);
        }
        parser.lock(true);
        if (values.size() < 2) parser.fail_expected("numeric expression");
        parser.expect(Tok::rparen, ")");
    }
    if (frames_.size() != frame) session_.fail(where, "#for loop did not end in file where it started.");
    cond.end = values[1];
    cond.step = values.size() > 2 ? values[2] : 1;
    if (cond.step == 0) session_.fail(where, "#for loop increment must be non-zero.");
    SlotPtr slot = session_.symbols.find_local(cond.variable);
    if (!slot) slot = session_.symbols.create_local(cond.variable);
    slot->value = Terms{{values[0]}, 1};
    cond.slot = slot;
    const bool runs = cond.step > 0 ? values[0] < cond.end + 1e-10 : values[0] > cond.end - 1e-10;
    if (!runs) {
        jump(end_of(hash, where) + 2);
        return;
    }
    cond.resume = top().at;
    conds_.push_back(cond);
}

void TokenStream::do_end(SourceRange where) {
    if (!has_cond()) session_.fail(where, "Mis-matched '#end'.");
    const Cond cond = conds_.back();
    if (cond.kind != Cond::Kind::for_) conds_.pop_back();
    if (cond.kind == Cond::Kind::while_) pass_while(cond);
    if (cond.kind != Cond::Kind::for_) return;
    auto* terms = std::get_if<Terms>(&cond.slot->value);
    if (!terms || terms->count != 1 || session_.symbols.find(cond.variable) != cond.slot) {
        conds_.pop_back();
        session_.fail(where, "#for loop variable must remain defined and numerical during loop.");
    }
    terms->v[0] += cond.step;
    const bool stops = cond.step > 0 ? terms->v[0] > cond.end + 1e-10 : terms->v[0] < cond.end - 1e-10;
    if (stops) {
        conds_.pop_back();
    } else {
        jump(cond.resume);
    }
}

void TokenStream::do_break(SourceRange where) {
    while (has_cond()) {
        const Cond cond = conds_.back();
        conds_.pop_back();
        if (cond.kind == Cond::Kind::if_) continue;
        jump(end_of(cond.hash, where) + 2);
        return;
    }
    if (top().kind != Frame::Kind::macro) session_.fail(where, "Invalid context for #break");
    jump(top().end);
}

}  // namespace rb
