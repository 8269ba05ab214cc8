#include "language/quick_expression.h"

#include "language/builtins.h"

#include <algorithm>
#include <cmath>

namespace rb {

namespace {

Operator relation_of(Tok kind, bool& known) {
    known = true;
    switch (kind) {
        case Tok::langle:
            return Operator::less;
        case Tok::less_equal:
            return Operator::less_equal;
        case Tok::equals:
            return Operator::equal;
        case Tok::not_equal:
            return Operator::unequal;
        case Tok::greater_equal:
            return Operator::greater_equal;
        case Tok::rangle:
            return Operator::greater;
        default:
            known = false;
            return Operator::less;
    }
}

}  // namespace

bool QuickExpression::read_sum(std::initializer_list<Tok> ends) {
    return finish(sum(value_) && has_ended(ends));
}
bool QuickExpression::read_full(std::initializer_list<Tok> ends) {
    return finish(full(value_) && has_ended(ends));
}

bool QuickExpression::finish(bool done) {
    if (!done) {
        while (draws_ > 0) {
            --draws_;
            session_.random.set_state(drawn_[draws_].stream, drawn_[draws_].state);
        }
    }
    return done;
}

Place QuickExpression::place() const {
    if (!name_ || name_begin_ != first_ || name_end_ != at_) return {};
    Place place = *name_;
    if (array_) {
        place.array = array_;
        place.index = index_;
    }
    return place;
}

/// A directive or macro behind the expression might go on with it.
bool QuickExpression::has_ended(std::initializer_list<Tok> ends) const {
    if (ends.size() > 0) return std::find(ends.begin(), ends.end(), kind()) != ends.end();
    switch (kind()) {
        case Tok::end:
        case Tok::hash:
        case Tok::invalid:
            return false;
        case Tok::word: {
            const uint32_t word = tokens_[at_].aux;
            if (Words::is_keyword(word)) return !leaves_channels_ || Words::kind(word) != Tok::component;
            const Place* place = session_.symbols.look(word);
            return !place || !std::holds_alternative<MacroPtr>(place->value());
        }
        default:
            return true;
    }
}

bool QuickExpression::apply(Operator op, Value& left, const Value& right) {
    int zero_divisions = 0;
    left.terms = combine(op, left.terms, right.terms, zero_divisions);
    left.end = right.end;
    return zero_divisions == 0;
}

bool QuickExpression::full(Value& out) {
    if (!logical(out)) return false;
    if (!take(Tok::question)) return true;
    Value then;
    Value otherwise;
    if (!full(then) || !take(Tok::colon) || !full(otherwise) || out.terms.count != 1) return false;
    out.terms = std::abs(out.terms.v[0]) > truth_tolerance ? then.terms : otherwise.terms;
    out.end = otherwise.end;
    return true;
}

bool QuickExpression::logical(Value& out) {
    if (!rel(out)) return false;
    while (kind() == Tok::ampersand || kind() == Tok::bar) {
        const Operator op = kind() == Tok::ampersand ? Operator::both : Operator::either;
        ++at_;
        Value right;
        if (!rel(right) || !apply(op, out, right)) return false;
    }
    return true;
}

bool QuickExpression::rel(Value& out) {
    if (!sum(out)) return false;
    while (true) {
        bool known = false;
        const Operator op = relation_of(kind(), known);
        if (!known) return true;
        ++at_;
        Value right;
        if (!sum(right) || !apply(op, out, right)) return false;
    }
}

bool QuickExpression::sum(Value& out) {
    const uint32_t start = at_;
    double number = 0;
    if (float_sum(number)) {
        const Token& last = tokens_[at_ - 1];
        out.terms = {{number}, 1};
        out.begin = tokens_[start].begin;
        out.end = last.begin + last.size;
        return true;
    }
    at_ = start;
    if (!term(out)) return false;
    while (kind() == Tok::plus || kind() == Tok::minus) {
        const Operator op = kind() == Tok::plus ? Operator::add : Operator::subtract;
        ++at_;
        Value right;
        if (!term(right) || !apply(op, out, right)) return false;
    }
    return true;
}

bool QuickExpression::term(Value& out) {
    if (!factor(out)) return false;
    while (kind() == Tok::star || kind() == Tok::slash) {
        const Operator op = kind() == Tok::star ? Operator::multiply : Operator::divide;
        ++at_;
        Value right;
        if (!factor(right) || !apply(op, out, right)) return false;
    }
    return true;
}

bool QuickExpression::factor(Value& out) {
    const Tok sign = kind();
    if (sign == Tok::minus || sign == Tok::bang) {
        const uint32_t begin = tokens_[at_++].begin;
        if (++depth_ > deepest || !factor(out)) return false;
        --depth_;
        out.terms = sign == Tok::minus ? negated(out.terms) : inverted(out.terms);
        out.begin = begin;
        return true;
    }
    while (take(Tok::plus)) {
    }
    return primary(out) && (kind() != Tok::dot || component(out));
}

bool QuickExpression::primary(Value& out) {
    const Token& token = tokens_[at_];
    switch (kind()) {
        case Tok::number:
            out.terms = {{file_.numbers[token.aux]}, 1};
            out.begin = token.begin;
            out.end = token.begin + token.size;
            ++at_;
            return true;
        case Tok::word:
            return word(out);
        case Tok::langle:
            return vector(out);
        case Tok::lparen:
            ++at_;
            if (++depth_ > deepest || !full(out) || !take(Tok::rparen)) return false;
            --depth_;
            out.begin = token.begin;
            out.end = tokens_[at_ - 1].begin + tokens_[at_ - 1].size;
            return true;
        default:
            return false;
    }
}

bool QuickExpression::word(Value& out) {
    const Token& token = tokens_[at_];
    if (!Words::is_keyword(token.aux)) {
        const Place* place = session_.symbols.look(token.aux);
        return place && name(*place, out);
    }
    const auto keyword = static_cast<Keyword>(token.aux);
    out.begin = token.begin;
    ++at_;
    switch (Words::kind(token.aux)) {
        case Tok::constant:
            out.terms = constant_value(session_, keyword);
            out.end = token.begin + token.size;
            return true;
        case Tok::call_one:
            return call_one(keyword, out);
        case Tok::call_many:
            return call_many(keyword, out);
        default:
            return false;
    }
}

bool QuickExpression::name(const Place& place, Value& out) {
    if (!place.slot->deprecated.empty()) return false;
    const Token& token = tokens_[at_];
    const rb::Value& value = place.value();
    name_ = &place;
    name_begin_ = at_;
    array_ = nullptr;
    out.begin = token.begin;
    out.end = token.begin + token.size;
    ++at_;
    if (const auto* terms = std::get_if<Terms>(&value)) {
        out.terms = *terms;
        name_end_ = at_;
        return true;
    }
    const auto* array = std::get_if<ArrayPtr>(&value);
    return array && elements(*array, out);
}

bool QuickExpression::elements(const ArrayPtr& array, Value& out) {
    const Place* const name = name_;
    const uint32_t begin = name_begin_;
    const ArrayPtr* from = &array;
    while (true) {
        size_t index = 0;
        for (const size_t size : (*from)->sizes) {
            Value subscript;
            if (!take(Tok::lbracket) || ++depth_ > deepest || !sum(subscript) || !take(Tok::rbracket))
                return false;
            --depth_;
            out.end = tokens_[at_ - 1].begin + tokens_[at_ - 1].size;
            const double number = subscript.terms.v[0] + 1e-10;
            if (subscript.terms.count != 1 || !(number >= 0 && number < static_cast<double>(size)))
                return false;
            index = index * size + static_cast<size_t>(number);
        }
        const rb::Value& element = (*from)->elements[index];
        if (const auto* inner = std::get_if<ArrayPtr>(&element)) {
            from = inner;
            continue;
        }
        const auto* terms = std::get_if<Terms>(&element);
        if (!terms || (*from)->sizes.empty()) return false;
        out.terms = *terms;
        name_ = name;
        name_begin_ = begin;
        name_end_ = at_;
        array_ = *from;
        index_ = index;
        return true;
    }
}

bool QuickExpression::vector(Value& out) {
    out.begin = tokens_[at_++].begin;
    if (++depth_ > deepest) return false;
    Terms terms;
    terms.count = 0;
    Value value;
    while (kind() != Tok::rangle) {
        if (terms.count == 5 || !sum(value) || value.terms.count != 1) return false;
        terms.v[static_cast<size_t>(terms.count++)] = value.terms.v[0];
        take(Tok::comma);
    }
    const Token& close = tokens_[at_++];
    --depth_;
    out.terms = terms;
    out.end = close.begin + close.size;
    return terms.count >= 2;
}

bool QuickExpression::component(Value& out) {
    ++at_;
    if (kind() != Tok::word || !Words::is_keyword(tokens_[at_].aux)) return false;
    const Token& token = tokens_[at_++];
    const int index = component_index(static_cast<Keyword>(token.aux));
    const bool plane_only = token.aux == word_of(Keyword::u) || token.aux == word_of(Keyword::v);
    if (index < 0 || index >= out.terms.count || (plane_only && index > 1)) return false;
    out.terms = {{out.terms.v[static_cast<size_t>(index)]}, 1};
    out.end = token.begin + token.size;
    return true;
}

}  // namespace rb
