#pragma once
#include <array>
#include <cstddef>

namespace rb {

/// Bernstein coefficients over [0, 1] of the polynomial with power coefficients `c`, highest first. Their
/// hull holds the polynomial's values, and its roots number no more than their sign changes.
template <size_t Count>
std::array<double, Count> bernstein_over_unit(const std::array<double, Count>& c) {
    constexpr size_t degree = Count - 1;
    static constexpr auto shares = [] {
        std::array<double, Count> inverse{};
        double choose = 1.0;
        for (size_t k = 0; k <= degree; ++k) {
            inverse[k] = 1.0 / choose;
            choose = choose * static_cast<double>(degree - k) / static_cast<double>(k + 1);
        }
        return inverse;
    }();
    std::array<double, Count> b;
#pragma GCC unroll 16
    for (size_t k = 0; k <= degree; ++k) b[k] = c[degree - k] * shares[k];
#pragma GCC unroll 16
    for (size_t k = 1; k <= degree; ++k) {
#pragma GCC unroll 16
        for (size_t i = degree; i >= k; --i) b[i] += b[i - 1];
    }
    return b;
}

template <size_t Count>
struct BernsteinHalves {
    std::array<double, Count> left;
    std::array<double, Count> right;
};

/// Coefficients over both halves of the interval (de Casteljau).
template <size_t Count>
BernsteinHalves<Count> halve(const std::array<double, Count>& b) {
    // `right` ends as the second half; its first entries on the way are the first half.
    BernsteinHalves<Count> cut;
    cut.right = b;
    cut.left[0] = b[0];
    for (size_t k = 1; k < Count; ++k) {
        for (size_t i = 0; i + k < Count; ++i) cut.right[i] = 0.5 * (cut.right[i] + cut.right[i + 1]);
        cut.left[k] = cut.right[0];
    }
    return cut;
}

}  // namespace rb
