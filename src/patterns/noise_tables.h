#pragma once
#include "math/shuffle.h"
#include "math/vec.h"

#include <array>
#include <cstdint>

namespace rb {

/// The shuffled numbers 0..4095 that choose values at lattice points. All tables here are part of the
/// language's pictures: every scene depends on them.
inline constexpr const ShuffledHash& hash_table = shuffled_hash;
/// Index of a lattice cell, chained through the hash table; arguments are taken modulo 4096.
inline uint32_t hash3(uint32_t a, uint32_t b, uint32_t c) {
    return hash_table[hash_table[hash_table[a & 4095u] ^ (b & 4095u)] ^ (c & 4095u)];
}

/// For each key a value and a slope of the lattice noise, half of (-1, 1) and in (-1, 1). Further noises use
/// the rows of the keys 4 and 8 higher.
extern const std::array<std::array<double, 4>, 264> value_rows;

/// Where the row of a hash begins: four times its key, the low eight bits of `hash_table`.
extern const std::array<uint16_t, 4096> row_starts;

/// Unit gradients and a permutation for the gradient noise (generator 3).
struct GradientTables {
    static constexpr size_t size = 2048;
    std::array<Vec3, size> gradient{};
    std::array<uint16_t, size> order{};
    /// The gradients once more, for reading four numbers from one before x.
    std::array<double, 3 * size + 1> rows{};
};
const GradientTables& gradient_tables();

/// 32768 uniform random numbers (MT19937, seed 5489), for cells, crackle, facets and black holes.
struct UniformTable {
    std::array<uint32_t, 32768> bits{};
    double operator[](uint32_t i) const { return bits[i & 32767u] * (1.0 / 4294967296.0); }
};
const UniformTable& uniform_table();

}  // namespace rb
