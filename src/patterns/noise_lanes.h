#pragma once
#include "patterns/noise_cell.h"

#include <algorithm>
#include <array>
#include <span>

namespace rb {

// The cells of all generators at several points, and how what is mixed becomes noise. Everything here is made
// to be built into functions of RB_FOR_EACH_WIDTH.

/// Coordinates up to here are placed together; others, and what is no number, one at a time.
inline constexpr double lane_limit = 2.0e9;

/// True if all points times `scale` are within +-lane_limit.
template <class Lanes>
RB_INLINE bool within_lanes(const LanePoint<Lanes>& p, double scale) {
    typename Lanes::Numbers x;
    typename Lanes::Numbers y;
    typename Lanes::Numbers z;
    set_magnitude(p.x, x);
    set_magnitude(p.y, y);
    set_magnitude(p.z, z);
    const typename Lanes::Numbers sum = x + y + z;
    double total = 0;
    for (size_t i = 0; i < Lanes::count; ++i) total += sum[i];
    return total * scale < lane_limit;
}

/// Generators 1 and 2 and vector noise (manual 3.4.1.10): a lattice whose cells lie between whole numbers.
struct Lattice {
    static constexpr double shift = 0.0;  ///< from coordinates to places among the cells
    /// Of the cell that begins at a whole number.
    static uint32_t number(double whole) {
        return (static_cast<uint32_t>(static_cast<int32_t>(whole)) + 10000u) & 4095u;
    }
    template <class Lanes>
    static RB_INLINE void place_axis(const typename Lanes::Numbers& p, bool in_lanes,
                                     typename Lanes::Integers& cell, AxisWeights<Lanes>& weights) {
        using Numbers = typename Lanes::Numbers;
        typename Lanes::Integers whole;
        if (in_lanes) {
            const Numbers below = p - (1.0 - tiny);
            whole = __builtin_convertvector(p >= 0.0 ? p : below, typename Lanes::Integers);
        } else {
            whole = typename Lanes::Integers{};
            for (size_t i = 0; i < Lanes::count; ++i) whole[i] = lattice_floor(p[i]);
        }
        const Numbers f = p - __builtin_convertvector(whole, Numbers);
        set_weights(f, weights);
        cell = ((whole & 4095) + 10000 % 4096) & 4095;
    }
    template <int Lane>
    static RB_INLINE void place_axis(double p, uint32_t& cell, Quad (&weights)[2]) {
        const int32_t whole = lattice_floor(p);
        set_weights<Lane>(p - whole, weights);
        cell = (static_cast<uint32_t>(whole) + 10000u) & 4095u;
    }
    /// Of the cell's corners.
    RB_INLINE void operator()(uint32_t x, uint32_t y, uint32_t z, CornerRows& rows) const {
        const uint32_t first = hash_table[x];
        const uint32_t second = hash_table[(x + 1) & 4095u];
        const uint32_t above = (y + 1) & 4095u;
        const uint32_t behind = (z + 1) & 4095u;
        const uint32_t column[4] = {hash_table[first ^ y], hash_table[second ^ y], hash_table[first ^ above],
                                    hash_table[second ^ above]};
        const double* values = value_rows.front().data();
#pragma GCC unroll 4
        for (size_t k = 0; k < 4; ++k) {
            rows[2 * k] = values + row_starts[column[k] ^ z];
            rows[2 * k + 1] = values + row_starts[column[k] ^ behind];
        }
    }
};

/// Generator 3: gradients at whole numbers that a large offset moves.
struct GradientLattice {
    static constexpr double shift = 10000000.023157213;
    const GradientTables& tables = gradient_tables();

    static RB_INLINE double floor_of(double t, uint32_t& cell) {
        const double whole = std::floor(t);
        const int64_t number = std::abs(whole) < 9e18 ? static_cast<int64_t>(whole) : 0;
        cell = static_cast<uint32_t>(number) & mask;
        return whole;
    }
    static uint32_t number(double whole) {
        uint32_t cell = 0;
        floor_of(whole, cell);
        return cell;
    }
    template <int Lane>
    static RB_INLINE void place_axis(double p, uint32_t& cell, Quad (&weights)[2]) {
        const double t = p + shift;
        set_weights<Lane>(t - floor_of(t, cell), weights);
    }

    template <class Lanes>
    static RB_INLINE void place_axis(const typename Lanes::Numbers& p, bool in_lanes,
                                     typename Lanes::Integers& cell, AxisWeights<Lanes>& weights) {
        using Numbers = typename Lanes::Numbers;
        using Integers = typename Lanes::Integers;
        const Numbers t = p + shift;
        Numbers whole;
        if (in_lanes) {
            const Integers near = __builtin_convertvector(t, Integers);
            const Integers below = near - 1;
            const Numbers truncated = __builtin_convertvector(near, Numbers);
            const Numbers lower = __builtin_convertvector(below, Numbers);
            whole = truncated > t ? lower : truncated;
            cell = __builtin_convertvector(whole, Integers) & static_cast<int32_t>(mask);
        } else {
            whole = Numbers{};
            cell = Integers{};
            for (size_t i = 0; i < Lanes::count; ++i) {
                uint32_t number = 0;
                whole[i] = floor_of(t[i], number);
                cell[i] = static_cast<int32_t>(number);
            }
        }
        const Numbers f = t - whole;
        set_weights(f, weights);
    }
    RB_INLINE void operator()(uint32_t x, uint32_t y, uint32_t z, CornerRows& rows) const {
        const uint32_t first = tables.order[x];
        const uint32_t second = tables.order[(x + 1) & mask];
        const uint32_t column[4] = {tables.order[(first + y) & mask], tables.order[(second + y) & mask],
                                    tables.order[(first + y + 1) & mask],
                                    tables.order[(second + y + 1) & mask]};
#pragma GCC unroll 4
        for (size_t k = 0; k < 4; ++k) {
            rows[2 * k] = tables.rows.data() + size_t{3} * ((column[k] + z) & mask);
            rows[2 * k + 1] = tables.rows.data() + size_t{3} * ((column[k] + z + 1) & mask);
        }
    }

private:
    static constexpr uint32_t mask = GradientTables::size - 1;
};

/// Several points times `scale` in their cells.
template <class Cells, class Lanes>
RB_INLINE void place(const Cells&, const LanePoint<Lanes>& p, double scale, bool in_lanes,
                     LanePlace<Lanes>& out) {
    const typename Lanes::Numbers x = scale * p.x;
    const typename Lanes::Numbers y = scale * p.y;
    const typename Lanes::Numbers z = scale * p.z;
    Cells::template place_axis<Lanes>(x, in_lanes, out.x, out.along[0]);
    Cells::template place_axis<Lanes>(y, in_lanes, out.y, out.along[1]);
    Cells::template place_axis<Lanes>(z, in_lanes, out.z, out.along[2]);
}

/// One point times `scale` in its cell.
template <class Cells>
RB_INLINE void place(const Cells&, const Vec3& p, double scale, PointPlace& out) {
    Cells::template place_axis<1>(scale * p.x, out.x, out.weights.x);
    Cells::template place_axis<2>(scale * p.y, out.y, out.weights.y);
    Cells::template place_axis<3>(scale * p.z, out.z, out.weights.z);
}

// One kind of noise for each generator, so that loops do not ask which one. `into_range` takes what was mixed
// (one number or several) to [0, 1], by a slope of `range_slope` where it does not clamp.

struct OriginalNoise {
    static constexpr bool centered = false;
    static constexpr bool has_value = true;
    static constexpr double range_slope = 1.0;
    Lattice cells;
    template <class T>
    static RB_INLINE void into_range(T& value) {
        value = value + 0.5;
        clamp_unit(value);
    }
};
struct RangeCorrectedNoise {
    static constexpr bool centered = true;  ///< around one half; sums of octaves move it to zero
    static constexpr bool has_value = true;
    static constexpr double range_slope = 0.48985582;
    Lattice cells;
    template <class T>
    static RB_INLINE void into_range(T& value) {
        value = (value + 1.05242) * range_slope;
        clamp_unit(value);
    }
};
struct GradientNoise {
    static constexpr bool centered = true;
    static constexpr bool has_value = false;
    static constexpr double range_slope = 0.5 * 1.59;
    GradientLattice cells;
    template <class T>
    static RB_INLINE void into_range(T& value) {
        value = 0.5 * (1.59 * value + 0.985);
        clamp_unit(value);
    }
};

/// Calls `use` with the noise of a generator.
template <class Use>
RB_INLINE void with_noise(int generator, const Use& use) {
    if (generator == 2) {
        use(RangeCorrectedNoise{});
    } else if (generator == 3) {
        use(GradientNoise{});
    } else {
        use(OriginalNoise{});
    }
}

}  // namespace rb
