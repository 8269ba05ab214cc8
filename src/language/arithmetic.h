#pragma once
#include "block/block.h"

namespace rb {

enum class Operator {
    add,
    subtract,
    multiply,
    divide,
    less,
    less_equal,
    equal,
    unequal,
    greater_equal,
    greater,
    both,
    either
};

/// What is nearer to 0 than this is false, and equal to 0 (spec: language 7).
inline constexpr double truth_tolerance = 1e-10;

/// `a op b` term by term; a float spreads over the other's terms. Divisions by zero give infinity and are
/// counted.
Terms combine(Operator op, Terms a, Terms b, int& zero_divisions);
Terms negated(Terms terms);
/// 1 where a term is 0, else 0.
Terms inverted(Terms terms);

}  // namespace rb
