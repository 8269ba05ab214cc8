#include "patterns/noise.h"

#include "base/scratch.h"
#include "patterns/noise_tables.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace rb {

namespace {

// The same source compiled for the baseline and for AVX2, chosen at run time; no contraction, so both give
// the same bits. Sanitizers cannot start with functions that are chosen this early.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__) && \
    !defined(__SANITIZE_THREAD__)
#define RB_FOR_EACH_TARGET __attribute__((target_clones("avx2", "default")))
#else
#define RB_FOR_EACH_TARGET
#endif
#define RB_INLINE inline __attribute__((always_inline))

using Quad = double __attribute__((vector_size(32)));

/// The values of one lattice cell for one noise, arranged by what they are multiplied with: lanes are the
/// corners (0,0), (1,0), (0,1), (1,1) in x and y; `near` and `far` in z.
struct CellSide {
    Quad half;  ///< half of the corner's own value
    Quad x;
    Quad y;
    Quad z;
};
struct CellValues {
    CellSide near;
    CellSide far;
};

/// A lattice cell, kept while successive points lie in it. `Count` independent noises share its hashing.
template <int Count>
struct Cell {
    int32_t x = 0;
    int32_t y = 0;
    int32_t z = 0;
    bool filled = false;
    CellValues values[Count] = {};
};

RB_INLINE void fill_side(const uint8_t (&keys)[4], int offset, CellSide& out) {
    Quad row[4];
#pragma GCC unroll 4
    for (unsigned corner = 0; corner < 4; ++corner) {
        std::memcpy(&row[corner], value_table.data() + keys[corner] + offset, sizeof row[corner]);
    }
    const Quad a = __builtin_shufflevector(row[0], row[1], 0, 4, 2, 6);
    const Quad b = __builtin_shufflevector(row[0], row[1], 1, 5, 3, 7);
    const Quad c = __builtin_shufflevector(row[2], row[3], 0, 4, 2, 6);
    const Quad d = __builtin_shufflevector(row[2], row[3], 1, 5, 3, 7);
    out.half = 0.5 * __builtin_shufflevector(a, c, 0, 1, 4, 5);
    out.x = __builtin_shufflevector(b, d, 0, 1, 4, 5);
    out.y = __builtin_shufflevector(a, c, 2, 3, 6, 7);
    out.z = __builtin_shufflevector(b, d, 2, 3, 6, 7);
}

template <int Count>
RB_INLINE void fill(Cell<Count>& cell, int32_t tx, int32_t ty, int32_t tz) {
    cell.x = tx;
    cell.y = ty;
    cell.z = tz;
    cell.filled = true;
    const uint32_t cx = static_cast<uint32_t>(tx) + 10000u;
    const uint32_t cy = static_cast<uint32_t>(ty) + 10000u;
    const uint32_t cz = static_cast<uint32_t>(tz) + 10000u;
    const uint32_t x[2] = {hash_table[cx & 4095u], hash_table[(cx + 1) & 4095u]};
    const uint32_t y[2] = {cy & 4095u, (cy + 1) & 4095u};
    const uint32_t z[2] = {cz & 4095u, (cz + 1) & 4095u};
    uint8_t near[4];
    uint8_t far[4];
#pragma GCC unroll 4
    for (unsigned corner = 0; corner < 4; ++corner) {
        const uint32_t key = hash_table[x[corner & 1u] ^ y[corner >> 1]];
        near[corner] = hash_bytes[key ^ z[0]];
        far[corner] = hash_bytes[key ^ z[1]];
    }
#pragma GCC unroll 3
    for (int i = 0; i < Count; ++i) {
        fill_side(near, 4 * i, cell.values[i].near);
        fill_side(far, 4 * i, cell.values[i].far);
    }
}

RB_INLINE double smooth(double f) { return f * f * (3.0 - 2.0 * f); }

/// `Count` independent lattice noises at a point.
template <int Count>
RB_INLINE void lattice_noises(double px, double py, double pz, Cell<Count>& cell, double (&out)[Count]) {
    int32_t tx;
    int32_t ty;
    int32_t tz;
    constexpr double limit = 2147483647.0;
    if (std::abs(px) < limit && std::abs(py) < limit && std::abs(pz) < limit) {
        tx = static_cast<int32_t>(px >= 0.0 ? px : px - (1.0 - tiny));
        ty = static_cast<int32_t>(py >= 0.0 ? py : py - (1.0 - tiny));
        tz = static_cast<int32_t>(pz >= 0.0 ? pz : pz - (1.0 - tiny));
    } else {
        tx = lattice_floor(px);
        ty = lattice_floor(py);
        tz = lattice_floor(pz);
    }
    if (!cell.filled || tx != cell.x || ty != cell.y || tz != cell.z) fill(cell, tx, ty, tz);
    const double fx = px - tx;
    const double fy = py - ty;
    const double fz = pz - tz;
    const double sz = smooth(fz);
    const Quad x = fx - Quad{0.0, 1.0, 0.0, 1.0};
    const Quad y = fy - Quad{0.0, 0.0, 1.0, 1.0};
    const Quad weight = (Quad{1.0, 0.0, 1.0, 0.0} + Quad{-1.0, 1.0, -1.0, 1.0} * smooth(fx)) *
                        (Quad{1.0, 1.0, 0.0, 0.0} + Quad{-1.0, -1.0, 1.0, 1.0} * smooth(fy));
#pragma GCC unroll 3
    for (int i = 0; i < Count; ++i) {
        const CellSide& near = cell.values[i].near;
        const CellSide& far = cell.values[i].far;
        const Quad front = near.half + near.x * x + near.y * y + near.z * fz;
        const Quad back = far.half + far.x * x + far.y * y + far.z * (fz - 1.0);
        const Quad sum = weight * (front * (1.0 - sz) + back * sz);
        out[i] = (sum[0] + sum[2]) + (sum[1] + sum[3]);
    }
}

RB_INLINE double clamp01(double v) { return std::min(std::max(v, 0.0), 1.0); }

RB_INLINE double gradient_noise(const Vec3& p, const GradientTables& tables) {
    constexpr uint32_t mask = GradientTables::size - 1;
    uint32_t b[3];
    double r[3];
    double s[3];
    for (int axis = 0; axis < 3; ++axis) {
        const double t = p[axis] + 10000000.023157213;
        const double whole = std::floor(t);
        b[axis] = static_cast<uint32_t>(std::abs(whole) < 9e18 ? static_cast<int64_t>(whole) : 0);
        r[axis] = t - whole;
        s[axis] = smooth(r[axis]);
    }
    double value[8];
    for (unsigned corner = 0; corner < 8; ++corner) {
        const uint32_t dx = corner & 1u;
        const uint32_t dy = (corner >> 1) & 1u;
        const uint32_t dz = corner >> 2;
        const uint32_t kx = tables.order[(b[0] + dx) & mask];
        const uint32_t ky = tables.order[(kx + ((b[1] + dy) & mask)) & mask];
        const Vec3& g = tables.gradient[(ky + ((b[2] + dz) & mask)) & mask];
        value[corner] = (r[0] - dx) * g.x + (r[1] - dy) * g.y + (r[2] - dz) * g.z;
    }
    for (size_t i = 0; i < 4; ++i) value[i] = value[2 * i] + s[0] * (value[2 * i + 1] - value[2 * i]);
    const double near = value[0] + s[1] * (value[1] - value[0]);
    const double far = value[2] + s[1] * (value[3] - value[2]);
    return near + s[2] * (far - near);
}

/// One noise function per generator, so that loops do not ask which one.
struct Original {
    Cell<1> cell;
    RB_INLINE double operator()(double x, double y, double z) {
        double value[1];
        lattice_noises(x, y, z, cell, value);
        return clamp01(value[0] + 0.5);
    }
};
struct RangeCorrected {
    Cell<1> cell;
    RB_INLINE double operator()(double x, double y, double z) {
        double value[1];
        lattice_noises(x, y, z, cell, value);
        return clamp01((value[0] + 1.05242) * 0.48985582);
    }
};
struct Gradient {
    const GradientTables& tables = gradient_tables();
    RB_INLINE double operator()(double x, double y, double z) {
        return clamp01(0.5 * (1.59 * gradient_noise({x, y, z}, tables) + 0.985));
    }
};

template <class Field>
RB_INLINE void sample(Field field, std::span<const Vec3> points, double scale, std::span<double> values) {
    for (size_t i = 0; i < points.size(); ++i) {
        const Vec3& p = points[i];
        values[i] = field(scale * p.x, scale * p.y, scale * p.z);
    }
}

}  // namespace

RB_FOR_EACH_TARGET void noise(std::span<const Vec3> points, double scale, int generator,
                              std::span<double> values) {
    if (generator == 2) {
        sample(RangeCorrected{}, points, scale, values);
    } else if (generator == 3) {
        sample(Gradient{}, points, scale, values);
    } else {
        sample(Original{}, points, scale, values);
    }
}

RB_FOR_EACH_TARGET void vector_noise(std::span<const Vec3> points, double scale, std::span<Vec3> values) {
    Cell<3> cell;
    for (size_t i = 0; i < points.size(); ++i) {
        const Vec3& p = points[i];
        double value[3];
        lattice_noises(scale * p.x, scale * p.y, scale * p.z, cell, value);
        values[i] = {value[0], value[1], value[2]};
    }
}

double noise(const Vec3& p, int generator) {
    double value = 0;
    noise({&p, 1}, 1.0, generator, {&value, 1});
    return value;
}

Vec3 vector_noise(const Vec3& p) {
    Vec3 value{0.0};
    vector_noise({&p, 1}, 1.0, {&value, 1});
    return value;
}

int octave_count(const TurbulenceWarp& shape) { return std::clamp(shape.octaves, 1, 10); }

void turbulence(std::span<const Vec3> points, const TurbulenceWarp& shape, int generator,
                std::span<double> values) {
    Scratch::Scope memory(thread_scratch());
    const auto octave_values = memory.take<double>(points.size());
    const bool centered = generator > 1;
    noise(points, 1.0, generator, values);
    if (centered) {
        for (double& v : values) v = clamp01(2.0 * v - 0.5);
    }
    double scale = shape.lambda;
    double weight = shape.omega;
    for (int octave = 2; octave <= octave_count(shape); ++octave) {
        noise(points, scale, generator, octave_values);
        for (size_t i = 0; i < values.size(); ++i) {
            const double q = centered ? 2.0 * octave_values[i] - 0.5 : octave_values[i];
            values[i] += weight * q;
        }
        scale *= static_cast<double>(shape.lambda);
        weight *= static_cast<double>(shape.omega);
    }
}

void vector_turbulence(std::span<const Vec3> points, const TurbulenceWarp& shape, std::span<Vec3> values) {
    Scratch::Scope memory(thread_scratch());
    const auto octave_values = memory.take<Vec3>(points.size());
    vector_noise(points, 1.0, values);
    double scale = shape.lambda;
    double weight = shape.omega;
    for (int octave = 2; octave <= octave_count(shape); ++octave) {
        vector_noise(points, scale, octave_values);
        for (size_t i = 0; i < values.size(); ++i) values[i] += weight * octave_values[i];
        scale *= static_cast<double>(shape.lambda);
        weight *= static_cast<double>(shape.omega);
    }
}

double turbulence(const Vec3& p, const TurbulenceWarp& shape, int generator) {
    double value = 0;
    turbulence({&p, 1}, shape, generator, {&value, 1});
    return value;
}

Vec3 vector_turbulence(const Vec3& p, const TurbulenceWarp& shape) {
    Vec3 value{0.0};
    vector_turbulence({&p, 1}, shape, {&value, 1});
    return value;
}

std::span<const WaveSource> wave_sources(int count) {
    thread_local std::vector<WaveSource> sources;
    const auto wanted = static_cast<size_t>(std::max(count, 1));
    if (sources.size() < wanted) {
        sources.clear();
        auto state = static_cast<uint32_t>(-560851967);
        for (size_t i = 0; i < wanted; ++i) {
            const double draw = lcg_step(state);
            sources.push_back({glm::normalize(vector_noise({static_cast<double>(i), 0.0, 0.0})),
                               draw * 0.000030518509476 + 0.01});
        }
    }
    return std::span(sources).first(wanted);
}

}  // namespace rb
