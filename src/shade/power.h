#pragma once
#include <cmath>
#include <cstdint>

namespace rb {

/// x^exponent for an exponent that is known long before x. Whole exponents, which finishes mostly have, are
/// multiplied out.
class Power {
public:
    explicit Power(double exponent) : exponent_(exponent) {
        if (exponent >= 1.0 && exponent <= 1024.0 && exponent == std::floor(exponent)) {
            whole_ = static_cast<uint32_t>(exponent);
        }
    }

    double of(double x) const {
        if (whole_ == 1) return x;
        if (whole_ == 0) return std::pow(x, exponent_);
        double result = whole_ & 1u ? x : 1.0;
        for (uint32_t rest = whole_ >> 1; rest != 0; rest >>= 1) {
            x *= x;
            if (rest & 1u) result *= x;
        }
        return result;
    }

private:
    double exponent_;
    uint32_t whole_ = 0;  ///< 0: it is not a whole number
};

}  // namespace rb
