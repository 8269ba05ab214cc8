#include "language/function_builder.h"

#include "language/builtins.h"

#include <algorithm>

#include <fmt/format.h>

namespace rb {

namespace {

uint32_t slot_name(uint32_t word) {
    // x and u share a slot, y and v too.
    if (word == word_of(Keyword::u)) return word_of(Keyword::x);
    if (word == word_of(Keyword::v)) return word_of(Keyword::y);
    return word;
}

struct Arity {
    Keyword word;
    size_t least;
    size_t most;
};
constexpr Arity arities[] = {
    {Keyword::sin, 1, 1},   {Keyword::cos, 1, 1},     {Keyword::tan, 1, 1},     {Keyword::asin, 1, 1},
    {Keyword::acos, 1, 1},  {Keyword::atan, 1, 1},    {Keyword::sinh, 1, 1},    {Keyword::cosh, 1, 1},
    {Keyword::tanh, 1, 1},  {Keyword::asinh, 1, 1},   {Keyword::acosh, 1, 1},   {Keyword::atanh, 1, 1},
    {Keyword::abs, 1, 1},   {Keyword::radians, 1, 1}, {Keyword::degrees, 1, 1}, {Keyword::int_, 1, 1},
    {Keyword::floor, 1, 1}, {Keyword::ceil, 1, 1},    {Keyword::sqrt, 1, 1},    {Keyword::exp, 1, 1},
    {Keyword::ln, 1, 1},    {Keyword::log, 1, 1},     {Keyword::atan2, 2, 2},   {Keyword::mod, 2, 2},
    {Keyword::pow, 2, 2},   {Keyword::div, 2, 2},     {Keyword::min, 2, 55},    {Keyword::max, 2, 55},
    {Keyword::select, 3, 4}};

}  // namespace

void FunctionBuilder::begin(SourceRange where) {
    Open opened;
    opened.where = where;
    opened.words = {word_of(Keyword::x), word_of(Keyword::y), word_of(Keyword::z)};
    open_.push_back(std::move(opened));
}

void FunctionBuilder::add_parameter(const Produced& token) {
    const bool letter = token.kind == Tok::constant;
    const auto keyword = static_cast<Keyword>(token.word);
    if (letter && keyword != Keyword::x && keyword != Keyword::y && keyword != Keyword::z &&
        keyword != Keyword::u && keyword != Keyword::v) {
        session_.fail(token.where, fmt::format("Expected 'parameter identifier', {} found instead",
                                               found_text(session_, token)));
    }
    if (open().words.size() >= 55) session_.fail(token.where, "Too many parameters");
    open().words.push_back(slot_name(token.word));
}

FunctionNode FunctionBuilder::pop() {
    FunctionNode node = std::move(open().nodes.back());
    open().nodes.pop_back();
    return node;
}

void FunctionBuilder::push_number(double value) {
    FunctionNode node;
    node.value = value;
    open().nodes.push_back(std::move(node));
}

bool FunctionBuilder::push_parameter(const Produced& token) {
    const auto& words = open().words;
    // The one listed last wins.
    const auto at = std::find(words.rbegin(), words.rend(), slot_name(token.word));
    if (at == words.rend()) return false;
    FunctionNode node;
    node.kind = FunctionNode::Kind::variable;
    node.index = static_cast<uint32_t>(words.rend() - at - 1);
    open().nodes.push_back(std::move(node));
    return true;
}

void FunctionBuilder::push_operand(const Operand& operand) {
    const Terms* terms = operand.terms();
    if (!terms || terms->count != 1) {
        std::string found = kind_name(operand.value);
        if (terms) found = fmt::format("vector function '{}'", found);
        session_.fail(operand.where, fmt::format("Expected 'operand', {} found instead", found));
    }
    push_number(terms->v[0]);
}

void FunctionBuilder::negate() {
    FunctionNode node;
    node.kind = FunctionNode::Kind::negated;
    node.parts.push_back(pop());
    open().nodes.push_back(std::move(node));
}

void FunctionBuilder::close_group() {
    FunctionNode node;
    node.kind = FunctionNode::Kind::group;
    node.parts.push_back(pop());
    open().nodes.push_back(std::move(node));
}

void FunctionBuilder::chain(char level, char op) {
    FunctionNode right = pop();
    FunctionNode& left = open().nodes.back();
    if (left.kind != FunctionNode::Kind::chain || left.level != level) {
        FunctionNode node;
        node.kind = FunctionNode::Kind::chain;
        node.level = level;
        node.parts.push_back(std::move(left));
        left = std::move(node);
    }
    left.operators.push_back(op);
    left.parts.push_back(std::move(right));
}

void FunctionBuilder::close_call() {
    const Call call = open().calls.back();
    open().calls.pop_back();
    const auto keyword = static_cast<Keyword>(call.word.word);
    const size_t count = open().nodes.size() - call.base;
    const auto* arity = std::find_if(std::begin(arities), std::end(arities),
                                     [&](const Arity& a) { return a.word == keyword; });
    const std::string name(session_.words.spelling(call.word.word));
    if (arity == std::end(arities)) {
        session_.fail(call.word.where,
                      fmt::format("Expected 'operand', {} found instead", found_text(session_, call.word)));
    }
    if (count < arity->least || count > arity->most) {
        session_.fail(call.word.where,
                      fmt::format("'{}' takes {} arguments, {} found", name, arity->least, count));
    }
    FunctionNode node;
    node.kind = FunctionNode::Kind::call;
    node.index = call.word.word;
    for (size_t i = call.base; i < open().nodes.size(); ++i) node.parts.push_back(std::move(open().nodes[i]));
    open().nodes.resize(call.base);
    open().nodes.push_back(std::move(node));
}

void FunctionBuilder::close_value_call() {
    const Call call = open().calls.back();
    open().calls.pop_back();
    FunctionNode node;
    node.kind = FunctionNode::Kind::function;
    node.index = 255;
    if (const auto* spline = std::get_if<SplinePtr>(&call.callee.value)) {
        node.function = *spline;
    } else {
        node.function = std::get<FunctionPtr>(std::get<Thing>(call.callee.value));
    }
    const size_t count = open().nodes.size() - call.base;
    check_argument_count(*node.function, count, call.callee.where);
    for (size_t i = call.base; i < open().nodes.size(); ++i) node.parts.push_back(std::move(open().nodes[i]));
    open().nodes.resize(call.base);
    open().nodes.push_back(std::move(node));
}

void FunctionBuilder::take_component(const Produced& name) {
    FunctionNode& node = open().nodes.back();
    const auto keyword = static_cast<Keyword>(name.word);
    const int index = keyword == Keyword::gray ? 254 : component_index(keyword);
    const bool fits = index == 254 || (index >= 0 && index < node.function->result_count());
    if (!fits) session_.fail(name.where, "Bad operands for period operator.");
    node.index = static_cast<uint32_t>(index);
}

void FunctionBuilder::add_loop_variable(const Produced& token) {
    open().calls.push_back({open().nodes.size(), token, {}});
    if (!open().explicit_parameters && open().parameters == 0) open().parameters = 3;
    open().words.push_back(slot_name(token.word));
    open().variables = std::max(open().variables, open().words.size());
}

void FunctionBuilder::close_loop() {
    const Call call = open().calls.back();
    open().calls.pop_back();
    if (open().nodes.size() - call.base != 3) session_.fail(call.word.where, "Expected 'numeric expression'");
    FunctionNode node;
    node.kind = FunctionNode::Kind::loop;
    node.index = static_cast<uint32_t>(open().words.size() - 1);
    open().words.pop_back();
    // The call below this one knows whether it is sum or prod.
    const Call outer = open().calls.back();
    open().calls.pop_back();
    node.level = outer.word.word == word_of(Keyword::sum) ? '+' : '*';
    node.where = outer.word.where;
    for (size_t i = call.base; i < open().nodes.size(); ++i) node.parts.push_back(std::move(open().nodes[i]));
    open().nodes.resize(call.base);
    open().nodes.push_back(std::move(node));
}

void FunctionBuilder::set_internal(const Operand& number) {
    const double value = to_float(number);
    FunctionPtr function = value >= 0 && value < 1000
                               ? internal_function(static_cast<int>(value), session_.noise_generator)
                               : nullptr;
    if (!function) {
        session_.fail(number.where, fmt::format("Function 'internal({:g})' does not exist.", value));
    }
    open().result = std::move(function);
}

void FunctionBuilder::set_expression() {
    FunctionNode body = pop();
    if (body.kind == FunctionNode::Kind::function && body.index == 255 && body.function->result_count() > 1) {
        session_.fail(open().where, "Expected '.', } found instead");
    }
    if (!fold(body)) session_.fail(open().where, "Division by zero.");
    const auto parameters = static_cast<uint32_t>(open().words.size());
    FunctionCode code = compile(body, parameters, static_cast<uint32_t>(open().variables));
    open().result = std::make_shared<UserFunction>(std::move(code), static_cast<int>(parameters));
}

FunctionPtr FunctionBuilder::finish(SourceRange where) {
    FunctionPtr function = std::move(open().result);
    open_.pop_back();
    if (!function) session_.fail(where, "Expected 'function'");
    return function;
}

}  // namespace rb
