#pragma once
#include "scene/pattern.h"

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace rb {

/// What the language takes as zero (spec: textures 0).
inline constexpr double tiny = 1e-10;

/// To a 32-bit integer towards zero; out of range it becomes the lowest integer, as in the reference.
inline int32_t truncated(double v) {
    return v > -2147483649.0 && v < 2147483648.0 ? static_cast<int32_t>(v)
                                                 : std::numeric_limits<int32_t>::min();
}
/// floor as a 32-bit integer that takes values just below a whole number for that number.
inline int32_t lattice_floor(double v) { return truncated(v >= 0.0 ? v : v - (1.0 - tiny)); }

// The batch forms multiply the points by `scale` first; neighbouring points in a batch share work.

/// Noise in [0, 1] by generator 1 (original), 2 (range corrected) or 3 (gradient); manual 3.4.1.10.
double noise(const Vec3& p, int generator);
void noise(std::span<const Vec3> points, double scale, int generator, std::span<double> values);

/// Three independent lattice noises, about [-1, 1]; the same for every generator.
Vec3 vector_noise(const Vec3& p);
void vector_noise(std::span<const Vec3> points, double scale, std::span<Vec3> values);

/// Sum of octaves of noise(), not normalised (manual 3.4.7.3.2).
double turbulence(const Vec3& p, const TurbulenceWarp& shape, int generator);
void turbulence(std::span<const Vec3> points, const TurbulenceWarp& shape, int generator,
                std::span<double> values);

/// Sum of octaves of vector_noise().
Vec3 vector_turbulence(const Vec3& p, const TurbulenceWarp& shape);
void vector_turbulence(std::span<const Vec3> points, const TurbulenceWarp& shape, std::span<Vec3> values);

/// Octaves that the language really uses: 1..10.
int octave_count(const TurbulenceWarp& shape);

/// Centre and frequency of one circular wave of `ripples` and `waves`.
struct WaveSource {
    Vec3 center{0.0};
    double frequency = 0;
};
/// The first `count` sources. The view stays valid until the next call in the same thread.
std::span<const WaveSource> wave_sources(int count);

}  // namespace rb
