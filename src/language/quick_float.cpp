// The sums that need no more than floats, of all the quick expressions.
#include "language/builtins.h"
#include "language/quick_expression.h"

namespace rb {

/// The most common sums: numbers, names of numbers, components of named vectors and arithmetic on them. Where
/// anything else is met, the whole sum is read again as one of any kind.
bool QuickExpression::float_sum(double& out) {
    if (!float_term(out)) return false;
    while (true) {
        double right = 0;
        switch (kind()) {
            case Tok::plus:
                ++at_;
                if (!float_term(right)) return false;
                out += right;
                break;
            case Tok::minus:
                ++at_;
                if (!float_term(right)) return false;
                out -= right;
                break;
            default:
                return true;
        }
    }
}

bool QuickExpression::float_term(double& out) {
    if (!float_factor(out)) return false;
    while (true) {
        double right = 0;
        switch (kind()) {
            case Tok::star:
                ++at_;
                if (!float_factor(right)) return false;
                out *= right;
                break;
            case Tok::slash:
                ++at_;
                if (!float_factor(right) || right == 0.0) return false;
                out /= right;
                break;
            case Tok::dot:
            case Tok::lbracket:
                return false;
            default:
                return true;
        }
    }
}

bool QuickExpression::float_factor(double& out) {
    const bool minus = take(Tok::minus);
    const Token& token = tokens_[at_];
    if (kind() == Tok::number) {
        out = file_.numbers[token.aux];
    } else if (kind() == Tok::word && !Words::is_keyword(token.aux)) {
        const Place* place = session_.symbols.look(token.aux);
        if (!place || !place->slot->deprecated.empty()) return false;
        const auto* terms = std::get_if<Terms>(&place->value());
        if (!terms || !float_component(*terms, out)) return false;
        name_ = place;
        array_ = nullptr;
        name_begin_ = at_;
        name_end_ = at_ + 1;
    } else {
        return false;
    }
    ++at_;
    if (minus) out = -out;
    return true;
}

/// A float, or `.x` of a vector; in the second case the current token is then the `x`.
bool QuickExpression::float_component(const Terms& terms, double& out) {
    if (terms.count == 1) {
        out = terms.v[0];
        return true;
    }
    if (at_ + 2 >= end_ || tokens_[at_ + 1].kind != Tok::dot || tokens_[at_ + 2].kind != Tok::word)
        return false;
    const uint32_t word = tokens_[at_ + 2].aux;
    if (word != word_of(Keyword::x) && word != word_of(Keyword::y) && word != word_of(Keyword::z))
        return false;
    const auto index = static_cast<size_t>(component_index(static_cast<Keyword>(word)));
    if (index >= static_cast<size_t>(terms.count)) return false;
    out = terms.v[index];
    at_ += 2;
    return true;
}

}  // namespace rb
