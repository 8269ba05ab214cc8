#include "patterns/noise.h"

#include "patterns/noise_lanes.h"

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

RB_FOR_EACH_TARGET void vector_octaves(std::span<const Vec3> points, const Octaves& octaves,
                                       std::span<Vec3> values) {
    sum_vector_octaves(
        points, octaves, [](Quad&) RB_INLINED {},
        [values](size_t i, const Vec3& sum) RB_INLINED { values[i] = sum; });
}

RB_FOR_EACH_TARGET Vec3 vector_octaves(const Vec3& p, const Octaves& octaves) {
    return sum_vector_octaves(p, octaves);
}

}  // namespace

void Lattice::floor_each(const Quad& p, IntQuad& whole) {
    for (int i = 0; i < 4; ++i) whole[i] = lattice_floor(p[i]);
}

void GradientLattice::floor_each(const Quad& t, Quad& whole, IntQuad& cell) {
    for (int i = 0; i < 4; ++i) {
        uint32_t number = 0;
        whole[i] = floor_of(t[i], number);
        cell[i] = static_cast<int32_t>(number);
    }
}

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
RB_FOR_EACH_TARGET void noise(std::span<const Vec3> points, double scale, int generator,
                              std::span<double> values) {
    with_noise(generator, [&](const auto& kind) RB_INLINED {
        sum_octaves(
            kind, points, single_octave(scale), [](Quad&, int) RB_INLINED {}, values);
    });
}

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

RB_FOR_EACH_TARGET void turbulence(std::span<const Vec3> points, const TurbulenceWarp& shape, int generator,
                                   std::span<double> values) {
    with_noise(generator, [&](const auto& kind) RB_INLINED {
        sum_octaves(kind, points, Octaves::of(shape), Centered{kind.centered}, values);
    });
}

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
