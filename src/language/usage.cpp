// How functions are called, for messages.
#include "language/builtins.h"

#include <utility>

namespace rb {

std::string_view usage_of(Keyword function) {
    constexpr std::pair<Keyword, std::string_view> usages[] = {
        {Keyword::atan2, "atan2(Y, X)"},
        {Keyword::concat, "concat(STRING, ...)"},
        {Keyword::datetime, "datetime(DAYS [, FORMAT])"},
        {Keyword::dimension_size, "dimension_size(ARRAY, DIMENSION)"},
        {Keyword::div, "div(A, B)"},
        {Keyword::inside, "inside(OBJECT, POINT)"},
        {Keyword::max, "max(NUMBER, ...)"},
        {Keyword::min, "min(NUMBER, ...)"},
        {Keyword::mod, "mod(A, B)"},
        {Keyword::pow, "pow(BASE, EXPONENT)"},
        {Keyword::select,
         "select(TEST, IF_NEGATIVE, OTHERWISE) or select(TEST, IF_NEGATIVE, IF_ZERO, IF_POSITIVE)"},
        {Keyword::str, "str(NUMBER, LENGTH, DIGITS)"},
        {Keyword::strcmp, "strcmp(STRING, STRING)"},
        {Keyword::substr, "substr(STRING, FIRST, COUNT)"},
        {Keyword::trace, "trace(OBJECT, ORIGIN, DIRECTION [, NORMAL])"},
        {Keyword::vaxis_rotate, "vaxis_rotate(VECTOR, AXIS, DEGREES)"},
        {Keyword::vcross, "vcross(VECTOR, VECTOR)"},
        {Keyword::vdot, "vdot(VECTOR, VECTOR)"},
        {Keyword::vrotate, "vrotate(VECTOR, DEGREES)"},
        {Keyword::vstr, "vstr(COUNT, VECTOR, SEPARATOR, LENGTH, DIGITS)"},
        {Keyword::vturbulence, "vturbulence(LAMBDA, OMEGA, OCTAVES, VECTOR)"}};
    for (const auto& [word, usage] : usages) {
        if (word == function) return usage;
    }
    return {};
}

}  // namespace rb
