#pragma once
#include "patterns/noise_lanes.h"

namespace rb {

// Sums of octaves of noise, over batches and at single points.

/// Octaves of a sum: what multiplies the points and what the noise, for each.
struct Octaves {
    int count = 1;
    std::array<double, 10> scale{1.0};
    std::array<double, 10> weight{1.0};

    static Octaves of(const TurbulenceWarp& shape);
    /// Points times 1, 2, 4, ... from `scale` on, noise times 1, 1/2, 1/4, ...
    static Octaves doubling(int count, double scale);

    /// No scale is larger.
    double scale_bound() const {
        double sum = 0;
        for (int i = 0; i < count; ++i) sum += std::abs(scale[i]);
        return sum;
    }
};

/// The sum over the octaves of weight * fold(noise(scale * p)), point by point: the twin of what follows.
template <class Noise, class Fold>
RB_INLINE double sum_octaves(const Noise& noise, const Vec3& p, const Octaves& octaves, const Fold& fold) {
    double sum = 0;
    for (int i = 0; i < octaves.count; ++i) {
        PointPlace at;
        place(noise.cells, p, octaves.scale[i], at);
        CornerRows rows;
        noise.cells(at.x, at.y, at.z, rows);
        double value = mix<Noise::has_value>(at, rows, 0);
        noise.into_range(value);
        fold(value, i);
        value *= octaves.weight[i];
        sum = i == 0 ? value : sum + value;
    }
    return sum;
}

/// The same of vector noise, not folded.
RB_INLINE Vec3 sum_vector_octaves(const Vec3& p, const Octaves& octaves) {
    const Lattice cells;
    Vec3 sum{0.0};
    for (int i = 0; i < octaves.count; ++i) {
        PointPlace at;
        place(cells, p, octaves.scale[i], at);
        CornerRows rows;
        cells(at.x, at.y, at.z, rows);
        const Vec3 value = octaves.weight[i] *
                           Vec3{mix<true>(at, rows, 0), mix<true>(at, rows, 16), mix<true>(at, rows, 32)};
        sum = i == 0 ? value : sum + value;
    }
    return sum;
}

/// Up to 16 points, lane by lane; the last of them repeated where there are too few.
template <class Lanes>
struct PointBlock {
    static constexpr size_t most = 16 / Lanes::count;
    size_t count;
    LanePoint<Lanes> points[most];
    bool in_lanes[most];

    /// `scale_bound`: the points are multiplied with nothing larger.
    RB_INLINE PointBlock(std::span<const Vec3> from, double scale_bound)
        : count((from.size() + Lanes::count - 1) / Lanes::count) {
        for (size_t k = 0; k < count; ++k) {
            const size_t first = Lanes::count * k;
            if (first + Lanes::count <= from.size()) {
                load(&from[first], points[k]);
            } else {
                Vec3 last[Lanes::count];
                for (size_t i = 0; i < Lanes::count; ++i)
                    last[i] = from[std::min(first + i, from.size() - 1)];
                load(last, points[k]);
            }
            in_lanes[k] = within_lanes(points[k], scale_bound);
        }
    }
};

// The places of a whole block are found before the first noise is mixed: what comes after the other waits for
// memory less.

/// The octaves of one point, side by side as points of a block are: all lanes have work.
template <class Lanes>
struct OctavesOfOne {
    static constexpr size_t most = PointBlock<Lanes>::most;
    size_t blocks;
    LanePlace<Lanes> at[most];

    template <class Cells>
    RB_INLINE OctavesOfOne(const Cells& cells, const Vec3& p, const Octaves& octaves) {
        const auto count = static_cast<size_t>(octaves.count);
        Vec3 scaled[std::tuple_size_v<decltype(octaves.scale)>];
        for (size_t i = 0; i < count; ++i) scaled[i] = p * octaves.scale[i];
        const PointBlock<Lanes> block(std::span<const Vec3>(scaled, count), 1.0);
        blocks = block.count;
        for (size_t k = 0; k < blocks; ++k) place(cells, block.points[k], 1.0, block.in_lanes[k], at[k]);
    }
};

/// sum_octaves() of a single point.
template <class Lanes, class Noise, class Fold>
RB_INLINE double sum_octaves_of_one(const Noise& noise, const Vec3& p, const Octaves& octaves,
                                    const Fold& fold) {
    const OctavesOfOne<Lanes> octave(noise.cells, p, octaves);
    typename Lanes::Numbers noises[OctavesOfOne<Lanes>::most][1];
    for (size_t k = 0; k < octave.blocks; ++k) {
        mix<1, Noise::has_value>(octave.at[k], noise.cells, 0, noises[k]);
        noise.into_range(noises[k][0]);
    }
    double sum = 0;
    for (size_t i = 0; i < static_cast<size_t>(octaves.count); ++i) {
        double value = noises[i / Lanes::count][0][i % Lanes::count];
        fold(value, static_cast<int>(i));
        value *= octaves.weight[i];
        sum = i == 0 ? value : sum + value;
    }
    return sum;
}

/// sum_vector_octaves() of a single point.
template <class Lanes, class Fold>
RB_INLINE Vec3 sum_vector_octaves_of_one(const Vec3& p, const Octaves& octaves, const Fold& fold) {
    const Lattice cells;
    const OctavesOfOne<Lanes> octave(cells, p, octaves);
    typename Lanes::Numbers noises[OctavesOfOne<Lanes>::most][3];
    for (size_t k = 0; k < octave.blocks; ++k) mix<3, true>(octave.at[k], cells, 16, noises[k]);
    Vec3 sum{0.0};
    for (size_t i = 0; i < static_cast<size_t>(octaves.count); ++i) {
        Vec3 value;
        for (int axis = 0; axis < 3; ++axis) {
            double v = noises[i / Lanes::count][axis][i % Lanes::count];
            fold(v);
            value[axis] = v * octaves.weight[i];
        }
        sum = i == 0 ? value : sum + value;
    }
    return sum;
}

/// values[i] = the sum over the octaves of weight * fold(noise(scale * point)). `fold` changes the noise
/// values of several points in place and is told the number of the octave.
template <class Lanes, class Noise, class Fold>
RB_INLINE void sum_octaves(const Noise& noise, std::span<const Vec3> points, const Octaves& octaves,
                           const Fold& fold, std::span<double> values) {
    using Points = PointBlock<Lanes>;
    if (points.size() == 1) {
        values[0] = octaves.count == 1 ? sum_octaves(noise, points[0], octaves, fold)
                                       : sum_octaves_of_one<Lanes>(noise, points[0], octaves, fold);
        return;
    }
    const double bound = octaves.scale_bound();
    for (size_t first = 0; first < points.size(); first += 16) {
        const Points block(points.subspan(first, std::min(points.size() - first, size_t{16})), bound);
        LanePlace<Lanes> at[Points::most];
        typename Lanes::Numbers sum[Points::most];
        for (int i = 0; i < octaves.count; ++i) {
            for (size_t k = 0; k < block.count; ++k) {
                place(noise.cells, block.points[k], octaves.scale[i], block.in_lanes[k], at[k]);
            }
            for (size_t k = 0; k < block.count; ++k) {
                typename Lanes::Numbers value[1];
                mix<1, Noise::has_value>(at[k], noise.cells, 0, value);
                noise.into_range(value[0]);
                fold(value[0], i);
                value[0] *= octaves.weight[i];
                if (i == 0) {
                    sum[k] = value[0];
                } else {
                    sum[k] += value[0];
                }
            }
        }
        for (size_t i = first; i < std::min(first + 16, points.size()); ++i)
            values[i] = sum[(i - first) / Lanes::count][i % Lanes::count];
    }
}

/// The same sum of vector noise, handed to `take` point by point: its index, then the sum.
template <class Lanes, class Fold, class Take>
RB_INLINE void sum_vector_octaves(std::span<const Vec3> points, const Octaves& octaves, const Fold& fold,
                                  const Take& take) {
    using Points = PointBlock<Lanes>;
    using Numbers = typename Lanes::Numbers;
    if (points.size() == 1) {
        take(0, sum_vector_octaves_of_one<Lanes>(points[0], octaves, fold));
        return;
    }
    const double bound = octaves.scale_bound();
    const Lattice cells;
    for (size_t first = 0; first < points.size(); first += 16) {
        const Points block(points.subspan(first, std::min(points.size() - first, size_t{16})), bound);
        LanePlace<Lanes> at[Points::most];
        LanePoint<Lanes> sum[Points::most];
        for (int i = 0; i < octaves.count; ++i) {
            for (size_t k = 0; k < block.count; ++k) {
                place(cells, block.points[k], octaves.scale[i], block.in_lanes[k], at[k]);
            }
            for (size_t k = 0; k < block.count; ++k) {
                Numbers value[3];
                mix<3, true>(at[k], cells, 16, value);
                for (Numbers& v : value) {
                    fold(v);
                    v *= octaves.weight[i];
                }
                if (i == 0) {
                    sum[k] = {value[0], value[1], value[2]};
                } else {
                    sum[k] = {sum[k].x + value[0], sum[k].y + value[1], sum[k].z + value[2]};
                }
            }
        }
        for (size_t i = first; i < std::min(first + 16, points.size()); ++i) {
            const LanePoint<Lanes>& lanes = sum[(i - first) / Lanes::count];
            constexpr size_t n = Lanes::count;
            take(i, Vec3{lanes.x[i % n], lanes.y[i % n], lanes.z[i % n]});
        }
    }
}

}  // namespace rb
