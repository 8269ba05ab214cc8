#pragma once
#include "math/vec.h"

#include <array>
#include <cstddef>
#include <utility>

namespace rb {

/// A polynomial of a fixed order in x, y and z along the ray o + t d: nested Horner, unrolled. Coefficients
/// in the order of poly_size().
class PolyAlong {
public:
    PolyAlong(const double* coefficients, const Vec3& o, const Vec3& d) : next_(coefficients), o_(o), d_(d) {}

    /// Coefficients of the powers of t, lowest first.
    template <size_t Order>
    std::array<double, Order + 1> find() {
        return in_xyz<Order>(std::make_index_sequence<Order>());
    }

private:
    template <size_t N>
    using Powers = std::array<double, N + 1>;

    /// Times (a + b t): becomes one of degree N.
    template <size_t N, size_t Count>
    static void multiply(std::array<double, Count>& p, double a, double b) {
        p[N] = p[N - 1] * b;
#pragma GCC unroll 8
        for (size_t i = N - 1; i > 0; --i) p[i] = p[i] * a + p[i - 1] * b;
        p[0] *= a;
    }
    template <size_t Count, size_t More>
    static void add(std::array<double, Count>& p, const std::array<double, More>& q) {
#pragma GCC unroll 8
        for (size_t i = 0; i < More; ++i) p[i] += q[i];
    }

    template <size_t N, size_t... I>
    Powers<N> in_z(std::index_sequence<I...>) {
        Powers<N> p{*next_++};
        ((multiply<I + 1>(p, o_.z, d_.z), p[0] += *next_++), ...);
        return p;
    }
    template <size_t N, size_t... I>
    Powers<N> in_yz(std::index_sequence<I...>) {
        Powers<N> p{*next_++};
        ((multiply<I + 1>(p, o_.y, d_.y), add(p, in_z<I + 1>(std::make_index_sequence<I + 1>()))), ...);
        return p;
    }
    template <size_t N, size_t... I>
    Powers<N> in_xyz(std::index_sequence<I...>) {
        Powers<N> p{*next_++};
        ((multiply<I + 1>(p, o_.x, d_.x), add(p, in_yz<I + 1>(std::make_index_sequence<I + 1>()))), ...);
        return p;
    }

    const double* next_;
    const Vec3& o_;
    const Vec3& d_;
};

}  // namespace rb
