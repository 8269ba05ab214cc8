#include "language/arithmetic.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rb {

namespace {

/// nan counts as equal to everything, as in the reference.
bool equal(double a, double b) { return !(std::abs(a - b) > truth_tolerance); }

double calculate(Operator op, double a, double b, int& zero_divisions) {
    switch (op) {
        case Operator::add:
            return a + b;
        case Operator::subtract:
            return a - b;
        case Operator::multiply:
            return a * b;
        case Operator::divide:
            if (b != 0.0) return a / b;
            ++zero_divisions;
            return std::numeric_limits<double>::infinity();
        case Operator::less:
            return a < b;
        case Operator::less_equal:
            return a < b || equal(a, b);
        case Operator::equal:
            return equal(a, b);
        case Operator::unequal:
            return !equal(a, b);
        case Operator::greater_equal:
            return a > b || equal(a, b);
        case Operator::greater:
            return a > b;
        case Operator::both:
            return std::abs(a) > truth_tolerance && std::abs(b) > truth_tolerance;
        case Operator::either:
            return std::abs(a) > truth_tolerance || std::abs(b) > truth_tolerance;
    }
    return 0;
}

void spread(Terms& terms, int count) {
    if (terms.count != 1) return;
    for (size_t i = 1; i < static_cast<size_t>(count); ++i) terms.v[i] = terms.v[0];
}

}  // namespace

Terms combine(Operator op, Terms a, Terms b, int& zero_divisions) {
    Terms out;
    out.count = std::max(a.count, b.count);
    spread(a, out.count);
    spread(b, out.count);
    for (size_t i = 0; i < static_cast<size_t>(out.count); ++i) {
        out.v[i] = calculate(op, a.v[i], b.v[i], zero_divisions);
    }
    return out;
}

Terms negated(Terms terms) {
    for (double& v : terms.v) v = -v;
    return terms;
}

Terms inverted(Terms terms) {
    for (double& v : terms.v) v = std::abs(v) > truth_tolerance ? 0.0 : 1.0;
    return terms;
}

}  // namespace rb
