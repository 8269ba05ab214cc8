// The calls of functions, of all the quick expressions.
#include "language/builtins.h"
#include "language/float_functions.h"
#include "language/quick_expression.h"

#include <cmath>

namespace rb {

namespace {

bool is_vector(const Terms& terms) { return terms.count <= 3; }

}  // namespace

bool QuickExpression::call_one(Keyword function, Value& out) {
    const uint32_t begin = out.begin;
    Value argument;
    if (!take(Tok::lparen) || ++depth_ > deepest || !full(argument)) return false;
    const Token& close = tokens_[at_];
    if (!take(Tok::rparen)) return false;
    --depth_;
    out.begin = begin;
    out.end = close.begin + close.size;
    if (function == Keyword::vlength || function == Keyword::vnormalize) {
        const Terms& t = argument.terms;
        const Vec3 v = t.count == 1 ? Vec3{t.v[0]} : Vec3{t.v[0], t.v[1], t.v[2]};
        if (!is_vector(t) || (function == Keyword::vnormalize && glm::dot(v, v) == 0)) return false;
        Operand operand;
        operand.value = t;
        out.terms = std::get<Terms>(call_builtin(session_, function, {&operand, 1}, where()));
        return true;
    }
    double result = 0;
    if (argument.terms.count != 1 || !call_float(function, argument.terms.v[0], result)) return false;
    out.terms = {{result}, 1};
    return true;
}

/// Without the arguments that bring warnings and errors.
bool QuickExpression::call_float(Keyword function, double a, double& result) {
    switch (function) {
        case Keyword::acos:
        case Keyword::asin:
            if (std::abs(a) > 1) return false;
            break;
        case Keyword::ln:
        case Keyword::log:
            if (a <= 0) return false;
            break;
        case Keyword::sqrt:
            if (a < 0) return false;
            break;
        case Keyword::rand:
            return draw(a, result);
        default:
            break;
    }
    const auto value = float_function(function, a);
    if (value) result = *value;
    return value.has_value();
}

bool QuickExpression::draw(double stream, double& result) {
    if (!session_.random.known(stream) || draws_ == drawn_.size()) return false;
    const auto number = static_cast<size_t>(stream);
    drawn_[draws_++] = {number, session_.random.state(number)};
    result = session_.random.next(number);
    return true;
}

bool QuickExpression::call_many(Keyword function, Value& out) {
    const uint32_t begin = out.begin;
    if (!take(Tok::lparen) || ++depth_ > deepest) return false;
    std::array<Terms, 4> arguments;
    size_t count = 0;
    bool floats = true;
    bool vectors = true;
    while (kind() != Tok::rparen) {
        Value value;
        if (count == arguments.size() || !sum(value)) return false;
        floats = floats && value.terms.count == 1;
        vectors = vectors && is_vector(value.terms);
        arguments[count++] = value.terms;
        take(Tok::comma);
    }
    const Token& close = tokens_[at_++];
    --depth_;
    out.begin = begin;
    out.end = close.begin + close.size;
    const double a = arguments[0].v[0];
    const double b = arguments[1].v[0];
    switch (function) {
        case Keyword::atan2:
            if (std::abs(a) <= 1e-10 && std::abs(b) <= 1e-10) return false;
            [[fallthrough]];
        case Keyword::div:
        case Keyword::mod:
        case Keyword::pow:
            if (!floats || count != 2 || (function == Keyword::pow && a == 0 && b == 0)) return false;
            out.terms = {{float_function(function, a, b).value_or(0)}, 1};
            return true;
        case Keyword::min:
        case Keyword::max:
            if (!floats || count == 0) return false;
            break;
        case Keyword::vdot:
        case Keyword::vcross:
        case Keyword::vrotate:
            if (!vectors || count != 2) return false;
            break;
        case Keyword::vaxis_rotate:
            if (!vectors || count != 3 || arguments[2].count != 1) return false;
            break;
        default:
            return false;
    }
    std::array<Operand, 4> operands;
    for (size_t i = 0; i < count; ++i) operands[i].value = arguments[i];
    out.terms = std::get<Terms>(call_builtin(session_, function, {operands.data(), count}, where()));
    return true;
}

}  // namespace rb
