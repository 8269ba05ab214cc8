#include "patterns/noise.h"

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
using QuadMask = int64_t __attribute__((vector_size(32)));
using Quad32 = int32_t __attribute__((vector_size(16)));

constexpr Quad corner_offsets[8] = {{0, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 1, 1, 0},
                                    {0, 0, 0, 1}, {0, 1, 0, 1}, {0, 0, 1, 1}, {0, 1, 1, 1}};

RB_INLINE double smooth(double f) { return f * f * (3.0 - 2.0 * f); }

/// Whole parts by lattice_floor and the rests; element 0 is not used.
RB_INLINE void split(const Vec3& p, Quad32& whole, Quad& rest) {
    const Quad v{0.0, p.x, p.y, p.z};
    constexpr double limit = 2147483647.0;
    if (std::abs(p.x) < limit && std::abs(p.y) < limit && std::abs(p.z) < limit) {
        const Quad almost_one = {1.0 - tiny, 1.0 - tiny, 1.0 - tiny, 1.0 - tiny};
        const QuadMask negative = v < Quad{};
        const Quad down = v - reinterpret_cast<Quad>(reinterpret_cast<QuadMask>(almost_one) & negative);
        whole = __builtin_convertvector(down, Quad32);
    } else {
        whole = Quad32{0, lattice_floor(p.x), lattice_floor(p.y), lattice_floor(p.z)};
    }
    rest = v - __builtin_convertvector(whole, Quad);
}

/// `Count` independent noises at once: each of the eight corners of the cell around the point shares its
/// place in the value table and its weighted factors (1/2, x, y, z) among them.
template <int Count>
RB_INLINE void lattice_noises(const Vec3& p, double (&out)[Count]) {
    Quad32 whole;
    Quad f;
    split(p, whole, f);
    const uint32_t cx = static_cast<uint32_t>(whole[1]) + 10000u;
    const uint32_t cy = static_cast<uint32_t>(whole[2]) + 10000u;
    const uint32_t cz = static_cast<uint32_t>(whole[3]) + 10000u;
    const Quad s = f * f * (Quad{3.0, 3.0, 3.0, 3.0} - (f + f));
    const double sx = s[1];
    const double sy = s[2];
    const double sz = s[3];
    const uint32_t z[2] = {cz & 4095u, (cz + 1) & 4095u};
    const uint32_t y[2] = {cy & 4095u, (cy + 1) & 4095u};
    const uint32_t x[2] = {hash_table[cx & 4095u], hash_table[(cx + 1) & 4095u]};
    const Quad xy = Quad{1.0 - sx, sx, 1.0 - sx, sx} * Quad{1.0 - sy, 1.0 - sy, sy, sy};
    const Quad near = xy * Quad{1.0 - sz, 1.0 - sz, 1.0 - sz, 1.0 - sz};
    const Quad far = xy * Quad{sz, sz, sz, sz};
    const Quad place{0.5, f[1], f[2], f[3]};

    Quad even[Count] = {};
    Quad odd[Count] = {};
#pragma GCC unroll 8
    for (unsigned corner = 0; corner < 8; ++corner) {
        const uint32_t key = hash_bytes[hash_table[x[corner & 1u] ^ y[(corner >> 1) & 1u]] ^ z[corner >> 2]];
        const double w = corner < 4 ? near[corner] : far[corner - 4];
        const Quad factors = (place - corner_offsets[corner]) * Quad{w, w, w, w};
        Quad* sums = corner & 1u ? odd : even;
#pragma GCC unroll 3
        for (int i = 0; i < Count; ++i) {
            Quad values;
            std::memcpy(&values, value_table.data() + key + 4 * i, sizeof values);
            sums[i] += values * factors;
        }
    }
#pragma GCC unroll 3
    for (int i = 0; i < Count; ++i) {
        const Quad sum = even[i] + odd[i];
        out[i] = (sum[0] + sum[2]) + (sum[1] + sum[3]);
    }
}

RB_INLINE double clamp01(double v) { return std::min(std::max(v, 0.0), 1.0); }

RB_INLINE double lattice_noise(const Vec3& p) {
    double value[1];
    lattice_noises(p, value);
    return value[0];
}

RB_INLINE Vec3 vector_noise_here(const Vec3& p) {
    double value[3];
    lattice_noises(p, value);
    return {value[0], value[1], value[2]};
}

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
    for (unsigned i = 0; i < 4; ++i) value[i] = value[2 * i] + s[0] * (value[2 * i + 1] - value[2 * i]);
    const double near = value[0] + s[1] * (value[1] - value[0]);
    const double far = value[2] + s[1] * (value[3] - value[2]);
    return near + s[2] * (far - near);
}

/// One noise function per generator, so that loops over octaves do not ask which one.
struct Original {
    RB_INLINE double operator()(const Vec3& p) const { return clamp01(lattice_noise(p) + 0.5); }
};
struct RangeCorrected {
    RB_INLINE double operator()(const Vec3& p) const {
        return clamp01((lattice_noise(p) + 1.05242) * 0.48985582);
    }
};
struct Gradient {
    const GradientTables& tables = gradient_tables();
    RB_INLINE double operator()(const Vec3& p) const {
        return clamp01(0.5 * (1.59 * gradient_noise(p, tables) + 0.985));
    }
};

template <class F>
RB_INLINE auto with_generator(int generator, F&& use) {
    if (generator == 2) return use(RangeCorrected{});
    if (generator == 3) return use(Gradient{});
    return use(Original{});
}

}  // namespace

RB_FOR_EACH_TARGET double noise(const Vec3& p, int generator) {
    return with_generator(
        generator, [&](const auto& field) __attribute__((always_inline)) { return field(p); });
}

RB_FOR_EACH_TARGET void noise(std::span<const Vec3> points, int generator, std::span<double> values) {
    with_generator(
        generator, [&](const auto& field) __attribute__((always_inline)) {
            for (size_t i = 0; i < points.size(); ++i) values[i] = field(points[i]);
        });
}

RB_FOR_EACH_TARGET Vec3 vector_noise(const Vec3& p) { return vector_noise_here(p); }

int octave_count(const TurbulenceWarp& shape) { return std::clamp(shape.octaves, 1, 10); }

RB_FOR_EACH_TARGET double turbulence(const Vec3& p, const TurbulenceWarp& shape, int generator) {
    const int octaves = octave_count(shape);
    const double lambda = shape.lambda;
    const double omega = shape.omega;
    const bool centered = generator > 1;
    return with_generator(
        generator, [&](const auto& field) __attribute__((always_inline)) {
            double value = field(p);
            if (centered) value = clamp01(2.0 * value - 0.5);
            double scale = lambda;
            double weight = omega;
            for (int octave = 2; octave <= octaves; ++octave) {
                double q = field(scale * p);
                if (centered) q = 2.0 * q - 0.5;
                value += weight * q;
                scale *= lambda;
                weight *= omega;
            }
            return value;
        });
}

RB_FOR_EACH_TARGET Vec3 vector_turbulence(const Vec3& p, const TurbulenceWarp& shape) {
    const int octaves = octave_count(shape);
    Vec3 value = vector_noise_here(p);
    double scale = shape.lambda;
    double weight = shape.omega;
    for (int octave = 2; octave <= octaves; ++octave) {
        value += weight * vector_noise_here(scale * p);
        scale *= static_cast<double>(shape.lambda);
        weight *= static_cast<double>(shape.omega);
    }
    return value;
}

std::span<const WaveSource> wave_sources(int count) {
    thread_local std::vector<WaveSource> sources;
    const auto wanted = static_cast<size_t>(std::max(count, 1));
    if (sources.size() < wanted) {
        sources.clear();
        auto state = static_cast<uint32_t>(-560851967);
        for (size_t i = 0; i < wanted; ++i) {
            state = state * 1812433253u + 12345u;
            const double draw = (state >> 16) & 0x7FFFu;
            sources.push_back({glm::normalize(vector_noise({static_cast<double>(i), 0.0, 0.0})),
                               draw * 0.000030518509476 + 0.01});
        }
    }
    return std::span(sources).first(wanted);
}

}  // namespace rb
