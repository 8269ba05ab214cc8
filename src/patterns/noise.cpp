#include "patterns/noise.h"

#include "patterns/octave_sums.h"

#include <algorithm>
#include <cmath>

namespace rb {

namespace {

/// What turbulence sums: noise about zero for the generators 2 and 3.
struct Centered {
    bool centered;
    template <class T>
    RB_INLINE void operator()(T& value, int octave) const {
        if (!centered) return;
        value = 2.0 * value - 0.5;
        if (octave == 0) clamp_unit(value);
    }
};

Octaves single_octave(double scale) {
    Octaves octaves;
    octaves.scale[0] = scale;
    return octaves;
}

template <class Lanes>
RB_INLINE void vector_octaves_in(std::span<const Vec3> points, const Octaves& octaves,
                                 std::span<Vec3> values) {
    sum_vector_octaves<Lanes>(
        points, octaves, [](auto&) RB_INLINED {},
        [values](size_t i, const Vec3& sum) RB_INLINED { values[i] = sum; });
}
RB_FOR_EACH_WIDTH(vector_octaves,
                  (std::span<const Vec3> points, const Octaves& octaves, std::span<Vec3> values),
                  (points, octaves, values))

RB_FOR_EACH_TARGET Vec3 vector_octaves(const Vec3& p, const Octaves& octaves) {
    return sum_vector_octaves(p, octaves);
}

}  // namespace

Octaves Octaves::of(const TurbulenceWarp& shape) {
    Octaves octaves;
    octaves.count = octave_count(shape);
    for (size_t i = 1; i < static_cast<size_t>(octaves.count); ++i) {
        octaves.scale[i] = i == 1 ? shape.lambda : octaves.scale[i - 1] * static_cast<double>(shape.lambda);
        octaves.weight[i] = i == 1 ? shape.omega : octaves.weight[i - 1] * static_cast<double>(shape.omega);
    }
    return octaves;
}

Octaves Octaves::doubling(int count, double scale) {
    Octaves octaves;
    octaves.count = count;
    octaves.scale[0] = scale;
    for (size_t i = 1; i < static_cast<size_t>(count); ++i) {
        octaves.scale[i] = 2.0 * octaves.scale[i - 1];
        octaves.weight[i] = 0.5 * octaves.weight[i - 1];
    }
    return octaves;
}

template <class Lanes>
RB_INLINE void noise_in(std::span<const Vec3> points, double scale, int generator, std::span<double> values) {
    with_noise(generator, [&](const auto& kind) RB_INLINED {
        sum_octaves<Lanes>(
            kind, points, single_octave(scale), [](auto&, int) RB_INLINED {}, values);
    });
}
RB_FOR_EACH_WIDTH(noise,
                  (std::span<const Vec3> points, double scale, int generator, std::span<double> values),
                  (points, scale, generator, values))

void vector_noise(std::span<const Vec3> points, double scale, std::span<Vec3> values) {
    vector_octaves(points, single_octave(scale), values);
}

RB_FOR_EACH_TARGET double noise(const Vec3& p, int generator) {
    double value = 0;
    with_noise(generator, [&](const auto& kind) RB_INLINED {
        value = sum_octaves(kind, p, Octaves{}, [](double&, int) RB_INLINED {});
    });
    return value;
}

Vec3 vector_noise(const Vec3& p) { return vector_octaves(p, Octaves{}); }

int octave_count(const TurbulenceWarp& shape) { return std::clamp(shape.octaves, 1, 10); }

template <class Lanes>
RB_INLINE void turbulence_in(std::span<const Vec3> points, const TurbulenceWarp& shape, int generator,
                             std::span<double> values) {
    with_noise(generator, [&](const auto& kind) RB_INLINED {
        sum_octaves<Lanes>(kind, points, Octaves::of(shape), Centered{kind.centered}, values);
    });
}
RB_FOR_EACH_WIDTH(turbulence,
                  (std::span<const Vec3> points, const TurbulenceWarp& shape, int generator,
                   std::span<double> values),
                  (points, shape, generator, values))

void vector_turbulence(std::span<const Vec3> points, const TurbulenceWarp& shape, std::span<Vec3> values) {
    vector_octaves(points, Octaves::of(shape), values);
}

RB_FOR_EACH_TARGET double turbulence(const Vec3& p, const TurbulenceWarp& shape, int generator) {
    double value = 0;
    with_noise(generator, [&](const auto& kind) RB_INLINED {
        value = sum_octaves(kind, p, Octaves::of(shape), Centered{kind.centered});
    });
    return value;
}

Vec3 vector_turbulence(const Vec3& p, const TurbulenceWarp& shape) {
    return vector_octaves(p, Octaves::of(shape));
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
