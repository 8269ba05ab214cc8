#pragma once
#include "math/random.h"
#include "math/vec.h"

namespace rb {

inline uint32_t reversed_bits(uint32_t x) {
    x = (x >> 16) | (x << 16);
    x = ((x & 0xff00ff00u) >> 8) | ((x & 0x00ff00ffu) << 8);
    x = ((x & 0xf0f0f0f0u) >> 4) | ((x & 0x0f0f0f0fu) << 4);
    x = ((x & 0xccccccccu) >> 2) | ((x & 0x33333333u) << 2);
    return ((x & 0xaaaaaaaau) >> 1) | ((x & 0x55555555u) << 1);
}

/// Owen's scrambling of a base 2 fraction, given with its bits reversed: each bit is flipped or not by a hash
/// of the bits before it (Laine and Karras 2011, with the constants of Vegdahl 2021).
inline uint32_t owen_scrambled_reversed(uint32_t x, uint32_t seed) {
    x ^= x * 0x3d20adeau;
    x += seed;
    x *= (seed >> 16) | 1u;
    x ^= x * 0x05526c56u;
    x ^= x * 0x53a22864u;
    return x;
}

/// The second dimension of Sobol's sequence, its bits reversed.
inline uint32_t sobol_second_reversed(uint32_t index) {
    // Column k of its matrix is row k of Pascal's triangle modulo 2; a product of such steps.
    uint32_t x = index;
    x ^= (x >> 1) & 0x55555555u;
    x ^= (x >> 2) & 0x33333333u;
    x ^= (x >> 4) & 0x0f0f0f0fu;
    x ^= (x >> 8) & 0x00ff00ffu;
    return x ^ ((x >> 16) & 0x0000ffffu);
}

/// Another order of the indices, in which any 2^k from a multiple of 2^k on stay together. Points of two
/// patterns go together as if they were independent where one of them is taken in another order (Burley
/// 2020).
inline uint32_t shuffled_index(uint32_t index, uint32_t seed) {
    return reversed_bits(owen_scrambled_reversed(reversed_bits(index), seed));
}

/// Point `index` of the two-dimensional Sobol sequence in [0, 1)^2, Owen-scrambled: uniform for each index,
/// and any 2^k points from a multiple of 2^k on spread evenly over the square. Another seed makes an
/// independent pattern.
inline Vec2 scrambled_sobol(uint32_t index, uint64_t seed) {
    const auto fraction = [](uint32_t reversed, uint64_t s) {
        const uint32_t bits = reversed_bits(owen_scrambled_reversed(reversed, static_cast<uint32_t>(s)));
        return static_cast<double>(bits) * 0x1p-32;
    };
    return {fraction(index, seed), fraction(sobol_second_reversed(index), seed >> 32)};
}

}  // namespace rb
