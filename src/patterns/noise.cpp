#include "patterns/noise.h"

#include "patterns/noise_tables.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace rb {

namespace {

using Pair = double __attribute__((vector_size(16)));

inline Pair load_pair(const double* from) {
    Pair pair;
    std::memcpy(&pair, from, sizeof pair);
    return pair;
}

/// The eight corners of the lattice cell around a point: where their values start in the value table, and
/// the weighted factors (1/2, x | y, z) that turn four values into the corner's share.
struct Corners {
    const double* values[8];
    Pair half_x[8];
    Pair y_z[8];
};

inline double smooth(double f) { return f * f * (3.0 - 2.0 * f); }

inline void corners_of(const Vec3& p, Corners& out) {
    const int32_t tx = lattice_floor(p.x);
    const int32_t ty = lattice_floor(p.y);
    const int32_t tz = lattice_floor(p.z);
    const double fx = p.x - tx;
    const double fy = p.y - ty;
    const double fz = p.z - tz;
    const uint32_t cx = static_cast<uint32_t>(tx) + 10000u;
    const uint32_t cy = static_cast<uint32_t>(ty) + 10000u;
    const uint32_t cz = static_cast<uint32_t>(tz) + 10000u;
    const double sx = smooth(fx);
    const double sy = smooth(fy);
    const double sz = smooth(fz);

    const uint32_t z[2] = {cz & 4095u, (cz + 1) & 4095u};
    const uint32_t y[2] = {cy & 4095u, (cy + 1) & 4095u};
    const uint32_t x[2] = {hash_table[cx & 4095u], hash_table[(cx + 1) & 4095u]};
    const double wx[2] = {1.0 - sx, sx};
    const double wy[2] = {1.0 - sy, sy};
    const double wz[2] = {1.0 - sz, sz};
    const Pair half_x[2] = {Pair{0.5, fx}, Pair{0.5, fx - 1.0}};
    const double dy[2] = {fy, fy - 1.0};
    const double dz[2] = {fz, fz - 1.0};

#pragma GCC unroll 8
    for (unsigned corner = 0; corner < 8; ++corner) {
        const unsigned ix = corner & 1u;
        const unsigned iy = (corner >> 1) & 1u;
        const unsigned iz = corner >> 2;
        const uint32_t key = hash_bytes[hash_table[x[ix] ^ y[iy]] ^ z[iz]];
        const double w = wx[ix] * wy[iy] * wz[iz];
        out.values[corner] = value_table.data() + key;
        out.half_x[corner] = half_x[ix] * Pair{w, w};
        out.y_z[corner] = Pair{dy[iy], dz[iz]} * Pair{w, w};
    }
}

template <int Offset>
inline double sum_of(const Corners& c) {
    Pair sum{0.0, 0.0};
#pragma GCC unroll 8
    for (unsigned corner = 0; corner < 8; ++corner) {
        sum += load_pair(c.values[corner] + Offset) * c.half_x[corner] +
               load_pair(c.values[corner] + Offset + 2) * c.y_z[corner];
    }
    return sum[0] + sum[1];
}

inline double clamp01(double v) { return std::min(std::max(v, 0.0), 1.0); }

inline double lattice_noise(const Vec3& p) {
    Corners corners;
    corners_of(p, corners);
    return sum_of<0>(corners);
}

inline double gradient_noise(const Vec3& p, const GradientTables& tables) {
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
    double operator()(const Vec3& p) const { return clamp01(lattice_noise(p) + 0.5); }
};
struct RangeCorrected {
    double operator()(const Vec3& p) const { return clamp01((lattice_noise(p) + 1.05242) * 0.48985582); }
};
struct Gradient {
    const GradientTables& tables = gradient_tables();
    double operator()(const Vec3& p) const {
        return clamp01(0.5 * (1.59 * gradient_noise(p, tables) + 0.985));
    }
};

template <class F>
auto with_generator(int generator, F&& use) {
    if (generator == 2) return use(RangeCorrected{});
    if (generator == 3) return use(Gradient{});
    return use(Original{});
}

}  // namespace

double noise(const Vec3& p, int generator) {
    return with_generator(generator, [&](const auto& field) { return field(p); });
}

void noise(std::span<const Vec3> points, int generator, std::span<double> values) {
    with_generator(generator, [&](const auto& field) {
        for (size_t i = 0; i < points.size(); ++i) values[i] = field(points[i]);
    });
}

Vec3 vector_noise(const Vec3& p) {
    Corners corners;
    corners_of(p, corners);
    return {sum_of<0>(corners), sum_of<4>(corners), sum_of<8>(corners)};
}

int octave_count(const TurbulenceWarp& shape) { return std::clamp(shape.octaves, 1, 10); }

double turbulence(const Vec3& p, const TurbulenceWarp& shape, int generator) {
    const int octaves = octave_count(shape);
    const double lambda = shape.lambda;
    const double omega = shape.omega;
    const bool centered = generator > 1;
    return with_generator(generator, [&](const auto& field) {
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

Vec3 vector_turbulence(const Vec3& p, const TurbulenceWarp& shape) {
    const int octaves = octave_count(shape);
    Vec3 value = vector_noise(p);
    double scale = shape.lambda;
    double weight = shape.omega;
    for (int octave = 2; octave <= octaves; ++octave) {
        value += weight * vector_noise(scale * p);
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
