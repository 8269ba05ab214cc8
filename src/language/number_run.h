#pragma once
#include <cstddef>
#include <string_view>
#include <vector>

namespace rb {

inline bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// A list of vectors of plain numbers with the same number of terms, found by looking at bytes only.
struct NumberRun {
    size_t size = 0;   ///< bytes from the first `<` to the last `>`
    size_t count = 0;  ///< vectors
    int terms = 0;
    size_t looked = 0;  ///< bytes that were looked at
};

/// The longest run at the start of `text`. A vector that is followed by an operator is not part of it, since
/// it may be part of an expression.
NumberRun find_number_run(std::string_view text);

/// Appends all numbers of a run found by find_number_run.
void parse_number_run(std::string_view run, std::vector<double>& out);

/// The value of a number as the lexer found it (C strtod: too large is infinity, `1e` is 1).
double parse_number(std::string_view text);

}  // namespace rb
