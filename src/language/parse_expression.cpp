// Operands and operators of scene expressions.
#include "language/builtins.h"
#include "language/find_file.h"
#include "language/parse_state.h"

#include <cmath>

#include <fmt/format.h>

namespace rb {

namespace {

bool compare(Operator op, const std::string& a, const std::string& b) {
    const int order = compare_texts(a, b);
    switch (op) {
        case Operator::less:
            return order < 0;
        case Operator::less_equal:
            return order <= 0;
        case Operator::equal:
            return order == 0;
        case Operator::unequal:
            return order != 0;
        case Operator::greater_equal:
            return order >= 0;
        default:
            return order > 0;
    }
}

bool is_comparison(Operator op) { return op >= Operator::less && op <= Operator::greater; }

}  // namespace

Terms ParseState::numeric(const Operand& operand) const {
    if (const auto* terms = std::get_if<Terms>(&operand.value)) return *terms;
    if (is_function(operand.value) || std::holds_alternative<SplinePtr>(operand.value)) {
        session_.fail(operand.where,
                      "Identifier expected, incomplete function call or spline call found instead.");
    }
    const bool text = std::holds_alternative<std::string>(operand.value);
    session_.fail(operand.where, fmt::format("Expected 'numeric expression', {} found instead",
                                             text ? "string" : kind_name(operand.value)));
}

void ParseState::push(Value value, SourceRange where) {
    Operand operand;
    operand.value = std::move(value);
    operand.where = where;
    operands_.push_back(std::move(operand));
}

void ParseState::push_name(const Produced& token) {
    const Value& value = token.place.value();
    // The declaration has failed and has been reported.
    if (std::holds_alternative<Poison>(value)) session_.fail(token.where, "");
    Operand operand;
    operand.value = value;
    operand.place = token.place;
    operand.where = token.where;
    operands_.push_back(std::move(operand));
}

void ParseState::push_constant(const Produced& token) {
    push(constant_value(session_, static_cast<Keyword>(token.word)), token.where);
}

void ParseState::push_text(const Produced& token) {
    const std::string_view literal = session_.text_of(token.where);
    const Item* before = blocks_.empty() || open().items.empty() ? nullptr : &open().items.back();
    // Behind `png` and the like a backslash is part of a file name, not an escape.
    const bool is_file = before && before->kind == Item::Kind::word && names_file_type(before->text);
    push(is_file ? raw_literal(literal) : unescape(session_, literal, token.where), token.where);
}

Operand ParseState::pop() {
    Operand operand = std::move(operands_.back());
    operands_.pop_back();
    return operand;
}

void ParseState::negate() {
    const Terms terms = negated(numeric(top()));
    const SourceRange where = cover(take_place(), top().where);
    operands_.pop_back();
    push(terms, where);
}

void ParseState::invert() {
    const Terms terms = inverted(numeric(top()));
    const SourceRange where = cover(take_place(), top().where);
    operands_.pop_back();
    push(terms, where);
}

void ParseState::apply(Operator op) {
    const Operand right = pop();
    Operand& left = top();
    const SourceRange where = cover(left.where, right.where);
    const auto* a_text = std::get_if<std::string>(&left.value);
    const auto* b_text = std::get_if<std::string>(&right.value);
    if (a_text && b_text && is_comparison(op)) {
        const double result = compare(op, *a_text, *b_text) ? 1 : 0;
        operands_.pop_back();
        return push(Terms{{result}, 1}, where);
    }
    const Terms a = numeric(left);
    const Terms b = numeric(right);
    int zero_divisions = 0;
    const Terms out = combine(op, a, b, zero_divisions);
    for (; zero_divisions > 0; --zero_divisions) session_.warn(right.where, "Divide by zero.");
    left.value = out;
    left.place = {};
    left.where = where;
}

void ParseState::choose() {
    const Operand otherwise = pop();
    const Operand then = pop();
    const Operand condition = pop();
    const Terms terms = numeric(condition);
    if (terms.count != 1) session_.fail(condition.where, "Conditional must evaluate to a float.");
    const Operand& chosen = std::abs(terms.v[0]) > truth_tolerance ? then : otherwise;
    push(chosen.value, cover(condition.where, otherwise.where));
}

void ParseState::take_component(const Produced& name) {
    Operand& operand = top();
    const Terms terms = numeric(operand);
    const auto keyword = static_cast<Keyword>(name.word);
    double value = 0;
    if (keyword == Keyword::gray) {
        value = 0.297 * terms.v[0] + 0.589 * terms.v[1] + 0.114 * terms.v[2];
    } else {
        const int index = component_index(keyword);
        if (index < 0) {
            session_.fail(name.where,
                          fmt::format("Expected 'x, y, z, u, v, t, red, green, blue, filter, transmit or "
                                      "gray', {} found instead",
                                      found_text(session_, name)));
        }
        const bool plane_only = keyword == Keyword::u || keyword == Keyword::v;
        if (index >= terms.count || (plane_only && index > 1)) {
            throw SceneError(
                name.where, "Bad operands for period operator.",
                fmt::format("the value has {} component{}", terms.count, terms.count == 1 ? "" : "s"));
        }
        value = terms.v[static_cast<size_t>(index)];
    }
    const SourceRange where = cover(operand.where, name.where);
    operands_.pop_back();
    push(Terms{{value}, 1}, where);
}

void ParseState::close_group(SourceRange where) {
    top().place = {};
    top().where = cover(take_place(), where);
}

void ParseState::close_vector(SourceRange where) {
    const List list = lists_.back();
    lists_.pop_back();
    const size_t count = operands_.size() - list.base;
    const SourceRange whole = cover(list.where, where);
    if (count < 2) session_.fail(where, "Expected 'numeric expression', > found instead");
    if (count > 5) {
        // Only blocks take these: the coefficients of matrix, quartic, poly.
        auto many = std::make_shared<Array>();
        for (size_t i = list.base; i < operands_.size(); ++i)
            many->elements.emplace_back(Terms{{to_float(operands_[i])}, 1});
        operands_.resize(list.base);
        return push(ArrayPtr(std::move(many)), whole);
    }
    Terms terms;
    terms.count = static_cast<int>(count);
    for (size_t i = 0; i < count; ++i) terms.v[i] = to_float(operands_[list.base + i]);
    operands_.resize(list.base);
    push(terms, whole);
}

void ParseState::close_tuple(SourceRange where) {
    const List list = lists_.back();
    lists_.pop_back();
    Terms terms;
    terms.count = static_cast<int>(operands_.size() - list.base);
    if (terms.count > 5) session_.fail(where, "Expected ')'");
    for (size_t i = 0; i < static_cast<size_t>(terms.count); ++i)
        terms.v[i] = to_float(operands_[list.base + i]);
    operands_.resize(list.base);
    push(terms, cover(list.where, where));
}

void ParseState::close_call(SourceRange where) {
    const List list = lists_.back();
    lists_.pop_back();
    const SourceRange whole = cover(list.where, where);
    const std::span<const Operand> arguments(operands_.data() + list.base, operands_.size() - list.base);
    Value result;
    try {
        result = call_builtin(session_, static_cast<Keyword>(list.word), arguments, whole);
    } catch (SceneError& error) {
        const std::string_view usage = usage_of(static_cast<Keyword>(list.word));
        const bool misused = error.diagnostic().message.starts_with("Expected");
        if (misused && !usage.empty()) {
            error.diagnostic().notes.push_back({Severity::note, {}, fmt::format("usage: {}", usage), {}});
        }
        throw;
    }
    operands_.resize(list.base);
    push(std::move(result), whole);
}

void ParseState::set_spline_type(const Produced& word) {
    if (lists_.empty()) session_.fail(word.where, "Expected 'numeric expression'");
    lists_.back().spline_type = static_cast<Keyword>(word.word);
}

void ParseState::close_value_call(SourceRange where) {
    const List list = lists_.back();
    lists_.pop_back();
    const Operand callee = operands_[list.base - 1];
    const SourceRange whole = cover(callee.where, where);
    const std::span<const Operand> arguments(operands_.data() + list.base, operands_.size() - list.base);
    Value result = call_value(callee, arguments, list.spline_type, whole);
    operands_.resize(list.base - 1);
    push(std::move(result), whole);
}

bool ParseState::value_is_array() const {
    return !operands_.empty() && std::holds_alternative<ArrayPtr>(operands_.back().value);
}

bool ParseState::value_is_callable() const {
    if (operands_.empty()) return false;
    const Value& value = operands_.back().value;
    return is_function(value) || std::holds_alternative<SplinePtr>(value);
}

bool ParseState::text_stands_alone() const { return !session_.stream.operator_follows(); }

bool ParseState::value_is_texture() const {
    if (operands_.empty()) return false;
    const auto* thing = std::get_if<Thing>(&operands_.back().value);
    return thing && std::holds_alternative<TexturePtr>(*thing);
}

void ParseState::take_subscript(SourceRange where) {
    const Operand subscript = pop();
    Operand& operand = top();
    const ArrayPtr array = std::get<ArrayPtr>(operand.value);
    // Subscripts of one array are collected in `pending`: the element is known when all are there.
    const size_t dimension = operand.pending_dimension;
    const size_t size = array->sizes.at(dimension);
    operand.pending_index = operand.pending_index * size + checked_subscript(subscript, size);
    operand.where = cover(operand.where, where);
    if (++operand.pending_dimension < array->sizes.size()) return;
    operand.place.array = array;
    operand.place.index = operand.pending_index;
    operand.pending_dimension = operand.pending_index = 0;
    Value element = array->elements[operand.place.index];
    if (!is_set(element)) session_.fail(operand.where, "Attempt to access uninitialized array element.");
    operand.value = std::move(element);
}

}  // namespace rb
