#pragma once
#include "patterns/noise.h"
#include "patterns/noise_tables.h"
#include "patterns/quad.h"

#include <cmath>

namespace rb {

// Noise at several points. Each corner of the cell around a point has a row (c, x, y, z): a value and a
// slope. With (u, v, w) the way from the corner to the point and s its weight, the noise is the sum over the
// corners of s (c + x u + y v + z w). The weight is a product over the axes, so the corners are mixed axis by
// axis (z, x, y), a whole row at a time; each axis brings its part of the way into the lane of its slope.

/// The same pointer, but what it points to must be read from memory there: a number is spread over lanes for
/// nothing on its way from memory, and dearly from a lane of a register, where the compiler likes to keep it.
template <class T>
RB_INLINE const T* from_memory(const T* p) {
    asm("" : "+r"(p) : : "memory");
    return p;
}

/// Weights of the near and the far corners along one axis, for the value and the other slopes, and for the
/// slope along it: times the way from those corners.
template <class Lanes>
struct AxisWeights {
    alignas(64) double plain[2][Lanes::count];  ///< [near, far][point]
    alignas(64) double sloped[2][Lanes::count];
};

/// Where several points lie: the cell in each axis, modulo the size of the tables, and the weights of its
/// corners.
template <class Lanes>
struct LanePlace {
    typename Lanes::Integers x;
    typename Lanes::Integers y;
    typename Lanes::Integers z;
    AxisWeights<Lanes> along[3];
};
using QuadPlace = LanePlace<Quads>;
using OctPlace = LanePlace<Octs>;

/// `f`: the way from the near corner.
template <class Lanes, class Numbers>
RB_INLINE void set_weights(const Numbers& f, AxisWeights<Lanes>& out) {
    const Numbers far = f * f * (3.0 - 2.0 * f);
    const Numbers near = 1.0 - far;
    store(near, out.plain[0]);
    store(far, out.plain[1]);
    store(f * near, out.sloped[0]);
    store((f - 1.0) * far, out.sloped[1]);
}

/// The rows of a cell's corners: bit 0 of the index is z, bit 1 x, bit 2 y.
using CornerRows = const double* [8];

/// All weights of one point, near and far along each axis.
struct PointWeights {
    Quad x[2];
    Quad y[2];
    Quad z[2];
};

// GCC 12 takes the parts of vectors that it writes one after the other for parts that are read before.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif
/// `plain`, with `sloped` in lane `Lane`.
template <int Lane>
RB_INLINE void join(double plain, double sloped, Quad& out) {
    const Quad most = {plain, plain, plain, plain};
    const Quad slope = {sloped, sloped, sloped, sloped};
    out = __builtin_shufflevector(most, slope, 0, Lane == 1 ? 5 : 1, Lane == 2 ? 6 : 2, Lane == 3 ? 7 : 3);
}
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic pop
#endif

RB_INLINE void weights_of(const QuadPlace& place, int point, PointWeights& out) {
    const auto at = [point](const double(&weights)[4]) RB_INLINED { return weights[point]; };
    for (int side = 0; side < 2; ++side) {
        join<1>(at(place.along[0].plain[side]), at(place.along[0].sloped[side]), out.x[side]);
        join<2>(at(place.along[1].plain[side]), at(place.along[1].sloped[side]), out.y[side]);
        join<3>(at(place.along[2].plain[side]), at(place.along[2].sloped[side]), out.z[side]);
    }
}

/// Mixes the rows at one point. `offset`: where in the rows.
RB_INLINE void mix_rows(const PointWeights& weight, const CornerRows& rows, std::ptrdiff_t offset,
                        Quad& out) {
    Quad row[8];
#pragma GCC unroll 8
    for (int corner = 0; corner < 8; ++corner) load(rows[corner] + offset, row[corner]);
    Quad column[4];
#pragma GCC unroll 4
    for (size_t k = 0; k < 4; ++k) column[k] = weight.z[0] * row[2 * k] + weight.z[1] * row[2 * k + 1];
    const Quad below = weight.x[0] * column[0] + weight.x[1] * column[1];
    const Quad above = weight.x[0] * column[2] + weight.x[1] * column[3];
    out = weight.y[0] * below + weight.y[1] * above;
}

/// Where one point lies.
struct PointPlace {
    uint32_t x;
    uint32_t y;
    uint32_t z;
    PointWeights weights;
};

/// `f`: the way from the near corner.
template <int Lane>
RB_INLINE void set_weights(double f, Quad (&out)[2]) {
    const double far = f * f * (3.0 - 2.0 * f);
    const double near = 1.0 - far;
    join<Lane>(near, f * near, out[0]);
    join<Lane>(far, (f - 1.0) * far, out[1]);
}

/// `HasValue` false: rows without a value.
template <bool HasValue>
RB_INLINE double mix(const PointPlace& place, const CornerRows& rows, int offset) {
    Quad parts;
    mix_rows(place.weights, rows, offset, parts);
    const double first = HasValue ? parts[0] + parts[1] : parts[1];
    return first + (parts[2] + parts[3]);
}

RB_INLINE bool in_one_cell(const QuadPlace& place) {
    const IntQuad differ = (place.x ^ place.x[0]) | (place.y ^ place.y[0]) | (place.z ^ place.z[0]);
    uint64_t bits[2];
    std::memcpy(bits, &differ, sizeof bits);
    return (bits[0] | bits[1]) == 0;
}

template <class Lanes, class Rows>
RB_INLINE void find_rows(const LanePlace<Lanes>& place, int point, const Rows& rows_of, CornerRows& rows) {
    rows_of(static_cast<uint32_t>(place.x[point]), static_cast<uint32_t>(place.y[point]),
            static_cast<uint32_t>(place.z[point]), rows);
}

/// `Count` noises in the same cells; the rows of the next one are `stride` further on. `rows_of` finds the
/// rows of a cell; with `HasValue` false they are slopes only.
template <int Count, bool HasValue, class Rows>
RB_INLINE void mix(const QuadPlace& place, const Rows& rows_of, std::ptrdiff_t stride, Quad (&out)[Count]) {
    CornerRows rows;
    Quad parts[Count][4];
    const auto mix_point = [&](int point) RB_INLINED {
        PointWeights weights;
        weights_of(*from_memory(&place), point, weights);
#pragma GCC unroll 3
        for (int i = 0; i < Count; ++i) mix_rows(weights, rows, stride * i, parts[i][point]);
    };
    if (in_one_cell(place)) {
        find_rows(place, 0, rows_of, rows);
#pragma GCC unroll 4
        for (int point = 0; point < 4; ++point) mix_point(point);
    } else {
#pragma GCC unroll 4
        for (int point = 0; point < 4; ++point) {
            find_rows(place, point, rows_of, rows);
            mix_point(point);
        }
    }
#pragma GCC unroll 3
    for (int i = 0; i < Count; ++i) {
        transpose(parts[i]);
        const Quad first = HasValue ? parts[i][0] + parts[i][1] : parts[i][1];
        out[i] = first + (parts[i][2] + parts[i][3]);
    }
}

// Of eight points two are mixed at a time, whose rows lie side by side in one register.

/// Weights along an axis, whose slope is in lane `Lane`, of the points 2 * Pair and 2 * Pair + 1.
template <int Pair, int Lane>
RB_INLINE void weights_of_pair(const AxisWeights<Octs>& from, Oct (&out)[2]) {
    constexpr int a = 2 * Pair;
    constexpr int b = a + 1;
    for (int side = 0; side < 2; ++side) {
        Oct plain;
        Oct sloped;
        load(from.plain[side], plain);
        load(from.sloped[side], sloped);
        out[side] = __builtin_shufflevector(plain, sloped, a, Lane == 1 ? a + 8 : a, Lane == 2 ? a + 8 : a,
                                            Lane == 3 ? a + 8 : a, b, Lane == 1 ? b + 8 : b,
                                            Lane == 2 ? b + 8 : b, Lane == 3 ? b + 8 : b);
    }
}

/// The mixed rows of two points.
template <int Pair, int Count, class Rows>
RB_INLINE void mix_pair(const OctPlace& place, const Rows& rows_of, std::ptrdiff_t stride,
                        Oct (&parts)[Count][4]) {
    CornerRows rows[2];
    find_rows(*from_memory(&place), 2 * Pair, rows_of, rows[0]);
    find_rows(*from_memory(&place), 2 * Pair + 1, rows_of, rows[1]);
    Oct x[2];
    Oct y[2];
    Oct z[2];
    weights_of_pair<Pair, 1>(place.along[0], x);
    weights_of_pair<Pair, 2>(place.along[1], y);
    weights_of_pair<Pair, 3>(place.along[2], z);
#pragma GCC unroll 3
    for (int i = 0; i < Count; ++i) {
        Oct row[8];
#pragma GCC unroll 8
        for (int corner = 0; corner < 8; ++corner) {
            Quad first;
            Quad second;
            load(rows[0][corner] + stride * i, first);
            load(rows[1][corner] + stride * i, second);
            row[corner] = __builtin_shufflevector(first, second, 0, 1, 2, 3, 4, 5, 6, 7);
        }
        Oct column[4];
#pragma GCC unroll 4
        for (size_t k = 0; k < 4; ++k) column[k] = z[0] * row[2 * k] + z[1] * row[2 * k + 1];
        const Oct below = x[0] * column[0] + x[1] * column[1];
        const Oct above = x[0] * column[2] + x[1] * column[3];
        parts[i][Pair] = y[0] * below + y[1] * above;
    }
}

/// The sums of lanes 2 i and 2 i + 1; of the first two lanes of each row only the second counts if there is
/// no value.
template <bool HasValue>
RB_INLINE void sum_neighbours(const Oct& a, const Oct& b, Oct& out) {
    const Oct even = __builtin_shufflevector(a, b, 0, 8, 2, 10, 4, 12, 6, 14);
    const Oct odd = __builtin_shufflevector(a, b, 1, 9, 3, 11, 5, 13, 7, 15);
    out = even + odd;
    if (!HasValue) out = __builtin_shufflevector(out, odd, 8, 9, 2, 3, 12, 13, 6, 7);
}

/// The same at eight points.
template <int Count, bool HasValue, class Rows>
RB_INLINE void mix(const OctPlace& place, const Rows& rows_of, std::ptrdiff_t stride, Oct (&out)[Count]) {
    Oct parts[Count][4];
    mix_pair<0>(place, rows_of, stride, parts);
    mix_pair<1>(place, rows_of, stride, parts);
    mix_pair<2>(place, rows_of, stride, parts);
    mix_pair<3>(place, rows_of, stride, parts);
#pragma GCC unroll 3
    for (int i = 0; i < Count; ++i) {
        Oct a;
        Oct b;
        sum_neighbours<HasValue>(parts[i][0], parts[i][1], a);
        sum_neighbours<HasValue>(parts[i][2], parts[i][3], b);
        out[i] = __builtin_shufflevector(a, b, 0, 4, 1, 5, 8, 12, 9, 13) +
                 __builtin_shufflevector(a, b, 2, 6, 3, 7, 10, 14, 11, 15);
    }
}

}  // namespace rb
