#include "grammar/token.h"
#include "language/function_code.h"
#include "language/words.h"

#include <algorithm>
#include <cmath>

namespace rb {

namespace {

using Kind = FunctionNode::Kind;

double apply(char op, double a, double b) {
    switch (op) {
        case '+':
            return a + b;
        case '-':
            return a - b;
        case '*':
            return a * b;
        case '/':
            return a / b;
        case '<':
            return a < b;
        case 'l':
            return a <= b;
        case '=':
            return a == b;
        case '!':
            return a != b;
        case 'g':
            return a >= b;
        case '>':
            return a > b;
        case '&':
            return a != 0 && b != 0;
        default:
            return a != 0 || b != 0;
    }
}

bool has_variable(const FunctionNode& node) {
    if (node.kind == Kind::variable || node.kind == Kind::function) return true;
    for (const FunctionNode& part : node.parts) {
        if (has_variable(part)) return true;
    }
    return false;
}

void make_constant(FunctionNode& node, double value) {
    node = FunctionNode{};
    node.value = value;
}

bool fold_chain(FunctionNode& node) {
    std::vector<FunctionNode> parts;
    std::vector<char> operators;
    for (size_t i = 0; i < node.parts.size(); ++i) {
        FunctionNode part = std::move(node.parts[i]);
        char op = i == 0 ? '\0' : node.operators[i - 1];
        if (op == '-' && part.kind == Kind::constant) {
            op = '+';
            part.value = -part.value;
        }
        if (!fold(part)) return false;
        if (i == 0) {
            parts.push_back(std::move(part));
            continue;
        }
        bool folds = parts.back().kind == Kind::constant && part.kind == Kind::constant;
        if (folds && (op == '*' || op == '/')) {
            for (const FunctionNode& before : parts) folds = folds && !has_variable(before);
        }
        if (folds) {
            // What stands before the last constant is ignored: this is the defect.
            parts.back().value = apply(op, parts.back().value, part.value);
            continue;
        }
        if (op == '/' && part.kind == Kind::constant) {
            if (part.value == 0) return false;
            op = '*';
            part.value = 1 / part.value;
        }
        operators.push_back(op);
        parts.push_back(std::move(part));
    }
    if (parts.size() == 1) {
        FunctionNode only = std::move(parts.front());
        node = std::move(only);
        return true;
    }
    node.parts = std::move(parts);
    node.operators = std::move(operators);
    return true;
}

}  // namespace

namespace {

/// A part that is not folded may still not divide by the constant 0.
bool divides_by_zero(const FunctionNode& node) {
    for (size_t i = 0; i < node.operators.size(); ++i) {
        const FunctionNode& divisor = node.parts[i + 1];
        if (node.operators[i] == '/' && divisor.kind == Kind::constant && divisor.value == 0) return true;
    }
    return std::any_of(node.parts.begin(), node.parts.end(), divides_by_zero);
}

}  // namespace

bool fold(FunctionNode& node) {
    switch (node.kind) {
        case Kind::constant:
        case Kind::variable:
            return true;
        case Kind::negated:
            if (!fold(node.parts[0])) return false;
            if (node.parts[0].kind == Kind::constant) make_constant(node, -node.parts[0].value);
            return true;
        case Kind::chain:
            return fold_chain(node);
        case Kind::group:
            return fold(node.parts[0]);
        case Kind::call:
        case Kind::function:
        case Kind::loop: {
            // Of a call only the first argument is folded, of pow both, of sum and prod nothing.
            const bool is_pow = node.kind == Kind::call && node.index == word_of(Keyword::pow);
            const size_t folded = node.kind == Kind::loop ? 0 : is_pow ? 2 : 1;
            for (size_t i = 0; i < node.parts.size(); ++i) {
                if (i < folded ? !fold(node.parts[i]) : divides_by_zero(node.parts[i])) return false;
            }
            return true;
        }
    }
    return true;
}

}  // namespace rb
