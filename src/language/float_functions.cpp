#include "language/float_functions.h"

#include "math/vec.h"

#include <cmath>

namespace rb {

double whole_part(double value) {
    if (!(std::abs(value) < 2147483648.0)) return -2147483648.0;
    return std::trunc(value) + 0.0;  // an integer has no -0
}

std::optional<double> float_function(Keyword word, double a) {
    switch (word) {
        case Keyword::abs:
            return std::abs(a);
        case Keyword::ceil:
            return std::ceil(a);
        case Keyword::floor:
            return std::floor(a);
        case Keyword::int_:
            return whole_part(a);
        case Keyword::exp:
            return std::exp(a);
        case Keyword::ln:
            return std::log(a);
        case Keyword::log:
            return std::log10(a);
        case Keyword::sqrt:
            return std::sqrt(a);
        case Keyword::sin:
            return std::sin(a);
        case Keyword::cos:
            return std::cos(a);
        case Keyword::tan:
            return std::tan(a);
        case Keyword::asin:
            return std::asin(a);
        case Keyword::acos:
            return std::acos(a);
        case Keyword::atan:
            return std::atan(a);
        case Keyword::sinh:
            return std::sinh(a);
        case Keyword::cosh:
            return std::cosh(a);
        case Keyword::tanh:
            return std::tanh(a);
        case Keyword::asinh:
            return std::asinh(a);
        case Keyword::acosh:
            return std::acosh(a);
        case Keyword::atanh:
            return std::atanh(a);
        case Keyword::degrees:
            return a * 180 / pi;
        case Keyword::radians:
            return a * pi / 180;
        default:
            return std::nullopt;
    }
}

std::optional<double> float_function(Keyword word, double a, double b) {
    switch (word) {
        case Keyword::atan2:
            return std::atan2(a, b);
        case Keyword::mod:
            return std::fmod(a, b);
        case Keyword::pow:
            return std::pow(a, b);
        case Keyword::div:
            return whole_part(a / b);
        default:
            return std::nullopt;
    }
}

}  // namespace rb
