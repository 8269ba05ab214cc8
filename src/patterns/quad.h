#pragma once
#include "math/vec.h"
#include "math/wide.h"

#include <cstdint>
#include <cstring>

namespace rb {

// Four or eight numbers at once, as GNU vectors. A function with RB_FOR_EACH_TARGET is compiled for the
// baseline and for AVX2, with all RB_INLINE functions that it calls, and chosen at run time; without
// contraction both give the same bits. Sanitizers cannot start with functions that are chosen this early.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__) && \
    !defined(__SANITIZE_THREAD__)
#define RB_FOR_EACH_TARGET __attribute__((target_clones("avx2", "default")))
#else
#define RB_FOR_EACH_TARGET
#endif
// NOLINTBEGIN(bugprone-macro-parentheses): name is that of a function, parameters and arguments bring theirs.
/// Defines the function `name` by a template `name_in`<Lanes>: by eights where the processor can, else by
/// fours.
#define RB_FOR_EACH_WIDTH(name, parameters, arguments)                                        \
    RB_FOR_EACH_TARGET static void name##_by_fours parameters { name##_in<Quads> arguments; } \
    RB_WIDE static void name##_by_eights parameters { name##_in<Octs> arguments; }            \
    void name parameters { has_wide() ? name##_by_eights arguments : name##_by_fours arguments; }
// NOLINTEND(bugprone-macro-parentheses)
#define RB_INLINE inline RB_INLINED
#define RB_INLINED __attribute__((always_inline))  // of lambdas

using Quad = double __attribute__((vector_size(32)));
using IntQuad = int32_t __attribute__((vector_size(16)));
using Oct = double __attribute__((vector_size(64)));
using IntOct = int32_t __attribute__((vector_size(32)));

/// How many numbers one instruction works on: four on any processor, eight in functions with RB_WIDE.
struct Quads {
    using Numbers = Quad;
    using Integers = IntQuad;
    using Bits = int64_t __attribute__((vector_size(32)));
    static constexpr size_t count = 4;
};
struct Octs {
    using Numbers = Oct;
    using Integers = IntOct;
    using Bits = int64_t __attribute__((vector_size(64)));
    static constexpr size_t count = 8;
};

/// As many points, coordinate by coordinate.
template <class Lanes>
struct LanePoint {
    typename Lanes::Numbers x;
    typename Lanes::Numbers y;
    typename Lanes::Numbers z;
};
using QuadPoint = LanePoint<Quads>;
using OctPoint = LanePoint<Octs>;

template <class Numbers>
RB_INLINE void load(const double* from, Numbers& out) {
    std::memcpy(&out, from, sizeof out);
}
template <class Numbers>
RB_INLINE void store(const Numbers& from, double* out) {
    std::memcpy(out, &from, sizeof from);
}

/// The four points from `from` on.
RB_INLINE void load(const Vec3* from, QuadPoint& out) {
    Quad a;
    Quad b;
    Quad c;
    load(&from->x, a);
    load(&from->x + 4, b);
    load(&from->x + 8, c);
    out.x = __builtin_shufflevector(__builtin_shufflevector(a, b, 0, 3, 6, 6), c, 0, 1, 2, 5);
    out.y = __builtin_shufflevector(__builtin_shufflevector(a, b, 1, 4, 7, 7), c, 0, 1, 2, 6);
    out.z = __builtin_shufflevector(__builtin_shufflevector(a, b, 2, 5, 5, 5), c, 0, 1, 4, 7);
}

/// The eight points from `from` on.
RB_INLINE void load(const Vec3* from, OctPoint& out) {
    Oct a;
    Oct b;
    Oct c;
    load(&from->x, a);
    load(&from->x + 8, b);
    load(&from->x + 16, c);
    out.x = __builtin_shufflevector(__builtin_shufflevector(a, b, 0, 3, 6, 9, 12, 15, 15, 15), c, 0, 1, 2, 3,
                                    4, 5, 10, 13);
    out.y = __builtin_shufflevector(__builtin_shufflevector(a, b, 1, 4, 7, 10, 13, 13, 13, 13), c, 0, 1, 2, 3,
                                    4, 8, 11, 14);
    out.z = __builtin_shufflevector(__builtin_shufflevector(a, b, 2, 5, 8, 11, 14, 14, 14, 14), c, 0, 1, 2, 3,
                                    4, 9, 12, 15);
}

/// Rows become columns.
RB_INLINE void transpose(Quad (&rows)[4]) {
    const Quad a = __builtin_shufflevector(rows[0], rows[1], 0, 4, 2, 6);
    const Quad b = __builtin_shufflevector(rows[0], rows[1], 1, 5, 3, 7);
    const Quad c = __builtin_shufflevector(rows[2], rows[3], 0, 4, 2, 6);
    const Quad d = __builtin_shufflevector(rows[2], rows[3], 1, 5, 3, 7);
    rows[0] = __builtin_shufflevector(a, c, 0, 1, 4, 5);
    rows[1] = __builtin_shufflevector(b, d, 0, 1, 4, 5);
    rows[2] = __builtin_shufflevector(a, c, 2, 3, 6, 7);
    rows[3] = __builtin_shufflevector(b, d, 2, 3, 6, 7);
}

template <class Numbers>
RB_INLINE void set_magnitude(const Numbers& v, Numbers& out) {
    int64_t __attribute__((vector_size(sizeof(Numbers)))) bits;
    std::memcpy(&bits, &v, sizeof bits);
    bits &= INT64_MAX;
    std::memcpy(&out, &bits, sizeof out);
}

/// Keeps one number or several within [0, 1]; what is no number stays so.
template <class T>
RB_INLINE void clamp_unit(T& v) {
    v = v < 0.0 ? T{} : v;
    v = v > 1.0 ? T{} + 1.0 : v;
}

}  // namespace rb
