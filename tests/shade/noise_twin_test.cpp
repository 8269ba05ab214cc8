// Noise over batches, several points at a time, against the same sums written plainly for one point: bit for
// bit.
#include "pattern_text.h"
#include "patterns/feature_points.h"
#include "patterns/noise.h"
#include "patterns/noise_tables.h"
#include "patterns/octave_sums.h"
#include "patterns/pattern_field.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <random>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace rb {
namespace {

/// Weights along an axis of the near and the far corners, and the same times the way from them.
struct Axis {
    double plain[2];
    double sloped[2];

    explicit Axis(double f) {
        const double far = f * f * (3.0 - 2.0 * f);
        const double near = 1.0 - far;
        plain[0] = near;
        plain[1] = far;
        sloped[0] = f * near;
        sloped[1] = (f - 1.0) * far;
    }
};

/// Rows (value, slopes) of the corners, z first, then x, then y.
using Rows = std::array<std::array<double, 4>, 8>;

double part(const std::array<Axis, 3>& axes, const Rows& rows, size_t lane) {
    const double* x = lane == 1 ? axes[0].sloped : axes[0].plain;
    const double* y = lane == 2 ? axes[1].sloped : axes[1].plain;
    const double* z = lane == 3 ? axes[2].sloped : axes[2].plain;
    double column[4];
    for (size_t k = 0; k < 4; ++k) column[k] = z[0] * rows[2 * k][lane] + z[1] * rows[2 * k + 1][lane];
    const double below = x[0] * column[0] + x[1] * column[1];
    const double above = x[0] * column[2] + x[1] * column[3];
    return y[0] * below + y[1] * above;
}

double lattice(const Vec3& p, size_t offset) {
    const int32_t cell[3] = {lattice_floor(p.x), lattice_floor(p.y), lattice_floor(p.z)};
    const std::array<Axis, 3> axes{Axis(p.x - cell[0]), Axis(p.y - cell[1]), Axis(p.z - cell[2])};
    const auto corner = [](int32_t c, uint32_t side) { return static_cast<uint32_t>(c) + 10000u + side; };
    Rows rows;
    for (uint32_t k = 0; k < 8; ++k) {
        const uint32_t key =
            hash3(corner(cell[0], (k >> 1) & 1u), corner(cell[1], k >> 2), corner(cell[2], k & 1u)) & 255u;
        rows[k] = value_rows[key + offset];
    }
    return (part(axes, rows, 0) + part(axes, rows, 1)) + (part(axes, rows, 2) + part(axes, rows, 3));
}

double gradients(const Vec3& p) {
    const GradientTables& tables = gradient_tables();
    double whole[3];
    uint32_t cell[3];
    std::array<Axis, 3> axes{Axis(0), Axis(0), Axis(0)};
    for (int axis = 0; axis < 3; ++axis) {
        const double t = p[axis] + 10000000.023157213;
        whole[axis] = std::floor(t);
        cell[axis] =
            static_cast<uint32_t>(std::abs(whole[axis]) < 9e18 ? static_cast<int64_t>(whole[axis]) : 0);
        axes[static_cast<size_t>(axis)] = Axis(t - whole[axis]);
    }
    constexpr uint32_t mask = GradientTables::size - 1;
    Rows rows;
    for (uint32_t k = 0; k < 8; ++k) {
        const uint32_t x = tables.order[(cell[0] + ((k >> 1) & 1u)) & mask];
        const uint32_t y = tables.order[(x + cell[1] + (k >> 2)) & mask];
        const Vec3& g = tables.gradient[(y + cell[2] + (k & 1u)) & mask];
        rows[k] = {0.0, g.x, g.y, g.z};
    }
    return part(axes, rows, 1) + (part(axes, rows, 2) + part(axes, rows, 3));
}

double unit(double v) { return v < 0.0 ? 0.0 : v > 1.0 ? 1.0 : v; }

double twin(const Vec3& p, int generator) {
    if (generator == 3) return unit(0.5 * (1.59 * gradients(p) + 0.985));
    if (generator == 2) return unit((lattice(p, 0) + 1.05242) * 0.48985582);
    return unit(lattice(p, 0) + 0.5);
}
Vec3 vector_twin(const Vec3& p) { return {lattice(p, 0), lattice(p, 4), lattice(p, 8)}; }

double turbulence_twin(const Vec3& p, const TurbulenceWarp& shape, int generator) {
    double sum = 0;
    double scale = 1;
    double weight = 1;
    for (int i = 0; i < octave_count(shape); ++i) {
        double value = twin(scale * p, generator);
        if (generator > 1) value = 2.0 * value - 0.5;
        if (generator > 1 && i == 0) value = unit(value);
        sum = i == 0 ? value : sum + weight * value;
        scale *= static_cast<double>(shape.lambda);
        weight *= static_cast<double>(shape.omega);
    }
    return sum;
}
Vec3 vector_turbulence_twin(const Vec3& p, const TurbulenceWarp& shape) {
    Vec3 sum{0.0};
    double scale = 1;
    double weight = 1;
    for (int i = 0; i < octave_count(shape); ++i) {
        const Vec3 value = weight * vector_twin(scale * p);
        sum = i == 0 ? value : sum + value;
        scale *= static_cast<double>(shape.lambda);
        weight *= static_cast<double>(shape.omega);
    }
    return sum;
}

double granite_twin(const Vec3& p, int generator) {
    double sum = 0;
    for (double scale = 1; scale < 64; scale *= 2) {
        const double n = twin(4.0 * scale * p, generator);
        const double folded = generator > 1 ? std::abs(1.0 - 2.0 * n) : std::abs(0.5 - n);
        sum += (generator > 1 && folded > 0.5 ? 0.5 : folded) / scale;
    }
    return sum;
}
double wrinkles_twin(const Vec3& p, int generator) {
    double sum = 0;
    for (double scale = 1; scale < 1024; scale *= 2) {
        const double n = twin(scale * p, generator);
        sum += (generator > 1 ? unit(2.0 * n - 0.5) : n) / scale;
    }
    return 0.5 * sum;
}

/// The same bits, but any two that are no numbers are the same.
bool same(double a, double b) {
    if (std::isnan(a) || std::isnan(b)) return std::isnan(a) && std::isnan(b);
    return std::memcmp(&a, &b, sizeof a) == 0;
}

/// Random points near and far, whole numbers and just beside them, huge ones, infinities, and what is no
/// number; also runs of points in one cell.
std::vector<Vec3> all_sorts_of_points() {
    std::mt19937 draw(7);
    std::uniform_real_distribution<double> unit_range(-1.0, 1.0);
    std::vector<Vec3> points;
    const auto add = [&](const std::function<double()>& coordinate) {
        points.push_back({coordinate(), coordinate(), coordinate()});
    };
    const double odd[] = {0.0,
                          -0.0,
                          1.0,
                          -1.0,
                          4095.0,
                          -4096.0,
                          1e-11,
                          -1e-11,
                          -1.0 - 1e-11,
                          1e-300,
                          2147483646.5,
                          -2147483648.5,
                          2.0e9,
                          1e10,
                          -1e10,
                          9.1e18,
                          -1e300,
                          std::numeric_limits<double>::max(),
                          std::numeric_limits<double>::infinity(),
                          -std::numeric_limits<double>::infinity(),
                          std::numeric_limits<double>::quiet_NaN()};
    for (int i = 0; i < 20 * RB_TEST_SAMPLES; ++i) {
        for (const double size : {0.2, 3.0, 500.0, 1e6, 3e9, 1e17}) {
            add([&] { return size * unit_range(draw); });
            add([&] { return std::round(size * unit_range(draw)); });
        }
        add([&] { return odd[draw() % std::size(odd)]; });
        add([&] { return draw() % 4 == 0 ? odd[draw() % std::size(odd)] : 5.0 * unit_range(draw); });
        if (i % 10 != 0) continue;
        const Vec3 start{20.0 * unit_range(draw), 20.0 * unit_range(draw), 20.0 * unit_range(draw)};
        for (int k = 0; k < 23; ++k)
            points.push_back(start + 0.01 * static_cast<double>(k) * Vec3{1.0, 0.3, -0.2});
    }
    return points;
}

/// Hands out the points in batches of every size from 1 to 40.
void each_batch(const std::vector<Vec3>& points, const std::function<void(std::span<const Vec3>)>& test) {
    size_t size = 1;
    for (size_t first = 0; first < points.size(); first += size, size = size % 40 + 1) {
        test(std::span(points).subspan(first, std::min(size, points.size() - first)));
        if (testing::Test::HasFailure()) return;
    }
}

void expect_values(std::span<const Vec3> points, std::span<const double> values,
                   const std::function<double(const Vec3&)>& expected) {
    for (size_t i = 0; i < points.size(); ++i) {
        const Vec3& p = points[i];
        EXPECT_TRUE(same(values[i], expected(p)))
            << p.x << ' ' << p.y << ' ' << p.z << ": " << values[i] << ", not " << expected(p);
    }
}

TEST(NoiseTwin, NoiseOfAllGenerators) {
    const std::vector<Vec3> points = all_sorts_of_points();
    for (int g = 1; g <= 3; ++g) {
        for (const double scale : {1.0, 0.37, -3.0}) {
            each_batch(points, [&](std::span<const Vec3> batch) {
                std::vector<double> values(batch.size());
                noise(batch, scale, g, values);
                expect_values(batch, values, [&](const Vec3& p) { return twin(scale * p, g); });
            });
        }
        for (const Vec3& p : points)
            ASSERT_TRUE(same(noise(p, g), twin(p, g))) << p.x << ' ' << p.y << ' ' << p.z;
    }
}

TEST(NoiseTwin, VectorNoiseAndTurbulence) {
    TurbulenceWarp odd;
    odd.octaves = 9;
    odd.lambda = 2.37f;
    odd.omega = 0.61f;
    TurbulenceWarp shrinking;
    shrinking.lambda = 0.3f;
    TurbulenceWarp once;
    once.octaves = 1;
    each_batch(all_sorts_of_points(), [&](std::span<const Vec3> batch) {
        std::vector<Vec3> values(batch.size());
        const auto expect_vectors = [&](const std::function<Vec3(const Vec3&)>& expected) {
            for (size_t i = 0; i < batch.size(); ++i) {
                const Vec3 e = expected(batch[i]);
                for (int axis = 0; axis < 3; ++axis) EXPECT_TRUE(same(values[i][axis], e[axis]));
            }
        };
        vector_noise(batch, 1.7, values);
        expect_vectors([](const Vec3& p) { return vector_twin(1.7 * p); });
        for (size_t i = 0; i < batch.size(); ++i) values[i] = vector_noise(batch[i]);
        expect_vectors(vector_twin);
        for (const TurbulenceWarp& shape : {TurbulenceWarp{}, odd, shrinking, once}) {
            vector_turbulence(batch, shape, values);
            expect_vectors([&](const Vec3& p) { return vector_turbulence_twin(p, shape); });
            for (size_t i = 0; i < batch.size(); ++i) values[i] = vector_turbulence(batch[i], shape);
            expect_vectors([&](const Vec3& p) { return vector_turbulence_twin(p, shape); });
            std::vector<double> sums(batch.size());
            for (int g = 1; g <= 3; ++g) {
                turbulence(batch, shape, g, sums);
                const auto expected = [&](const Vec3& p) { return turbulence_twin(p, shape, g); };
                expect_values(batch, sums, expected);
                for (size_t i = 0; i < batch.size(); ++i) sums[i] = turbulence(batch[i], shape, g);
                expect_values(batch, sums, expected);
            }
        }
    });
}

/// What processors without eight doubles in a register do.
TEST(NoiseTwin, ByFours) {
    TurbulenceWarp shape;
    shape.octaves = 4;
    const Octaves octaves = Octaves::of(shape);
    each_batch(all_sorts_of_points(), [&](std::span<const Vec3> batch) {
        std::vector<double> sums(batch.size());
        for (int g = 1; g <= 3; ++g) {
            with_noise(g, [&](const auto& noise) {
                sum_octaves<Quads>(
                    noise, batch, octaves, [](auto&, int) {}, sums);
            });
            expect_values(batch, sums, [&](const Vec3& p) {
                double sum = 0;
                for (int i = 0; i < octaves.count; ++i) {
                    const double value = octaves.weight[i] * twin(octaves.scale[i] * p, g);
                    sum = i == 0 ? value : sum + value;
                }
                return sum;
            });
        }
        sum_vector_octaves<Quads>(
            batch, octaves, [](auto&) {},
            [&](size_t i, const Vec3& sum) {
                const Vec3 expected = vector_turbulence_twin(batch[i], shape);
                for (int axis = 0; axis < 3; ++axis) EXPECT_TRUE(same(sum[axis], expected[axis]));
            });
    });
}

TEST(NoiseTwin, GraniteAndWrinkles) {
    const WrittenPattern granite = pattern_of("granite");
    const WrittenPattern wrinkles = pattern_of("wrinkles");
    each_batch(all_sorts_of_points(), [&](std::span<const Vec3> batch) {
        std::vector<double> values(batch.size());
        for (int g = 1; g <= 3; ++g) {
            granite.pattern->evaluate({granite.modifiers, g}, batch, values);
            expect_values(batch, values, [&](const Vec3& p) { return granite_twin(p, g); });
            wrinkles.pattern->evaluate({wrinkles.modifiers, g}, batch, values);
            expect_values(batch, values, [&](const Vec3& p) { return wrinkles_twin(p, g); });
        }
    });
}

TEST(NoiseTwin, WrinklesPushNormals) {
    const Normal wrinkles = written_normal("wrinkles 0.3");
    each_batch(all_sorts_of_points(), [&](std::span<const Vec3> batch) {
        std::vector<Vec3> normals(batch.size(), Vec3{0.0, 1.0, 0.0});
        ASSERT_TRUE(wrinkles.pattern->perturb({wrinkles.modifiers, 2}, 0.3f, batch, normals));
        for (size_t i = 0; i < batch.size(); ++i) {
            Vec3 sum{0.0};
            for (double scale = 1; scale < 1024; scale *= 2) {
                sum += 1.0 / scale * glm::abs(vector_twin(scale * batch[i]));
            }
            const Vec3 expected = Vec3{0.0, 1.0, 0.0} + static_cast<double>(0.3f) * sum;
            for (int axis = 0; axis < 3; ++axis) EXPECT_TRUE(same(normals[i][axis], expected[axis]));
        }
    });
}

/// The random points of the cells up to 2 away, by no more than one of the coordinates.
std::vector<Vec3> features_around(const FeatureCell& cell) {
    std::vector<Vec3> features;
    const UniformTable& random = uniform_table();
    for (int k = 0; k < 125; ++k) {
        const std::array<int, 3> away{k / 25 - 2, k / 5 % 5 - 2, k % 5 - 2};
        if (std::ranges::count_if(away, [](int d) { return std::abs(d) == 2; }) > 1) continue;
        std::array<uint32_t, 3> at{static_cast<uint32_t>(cell.x), static_cast<uint32_t>(cell.y),
                                   static_cast<uint32_t>(cell.z)};
        for (size_t i = 0; i < 3; ++i) at[i] += static_cast<uint32_t>(away[i]);
        const uint32_t first = hash3(at[0], at[1], at[2]);
        const auto place = [&](uint32_t axis) {
            return static_cast<int32_t>(at[axis]) + random[first + axis];
        };
        features.emplace_back(place(0), place(1), place(2));
    }
    return features;
}

/// Whatever was asked for before.
TEST(NoiseTwin, FeaturePoints) {
    NearFeatures near;
    std::mt19937 random(5);
    for (int i = 0; i < 3000; ++i) {
        const auto coordinate = [&] { return static_cast<int32_t>(random() % 7) - 3; };
        FeatureCell cell{coordinate(), coordinate(), coordinate()};
        if (i % 50 == 0) cell.y = std::numeric_limits<int32_t>::max();
        if (i % 50 == 1) cell.z = std::numeric_limits<int32_t>::min();
        const FeatureLanes& features = near.around(cell);
        const std::vector<Vec3> expected = features_around(cell);
        ASSERT_EQ(expected.size(), FeatureLanes::count);
        for (size_t k = 0; k < expected.size(); ++k) ASSERT_EQ(features.point(k), expected[k]);
    }
}

/// Crackle of a metric from all features around a point, sorted.
double crackle_twin(const Vec3& p, double metric) {
    std::vector<double> sums;
    for (const Vec3& feature : features_around(FeatureCell::of(p))) {
        const Vec3 d = glm::abs(feature - p);
        const double sum = metric == 2.0
                               ? d.x * d.x + d.y * d.y + d.z * d.z
                               : std::pow(d.x, metric) + std::pow(d.y, metric) + std::pow(d.z, metric);
        constexpr double far = std::numeric_limits<double>::max();
        sums.push_back(sum < far ? sum : far);
    }
    std::sort(sums.begin(), sums.end());
    const auto length = [&](double sum) {
        return metric == 2.0 ? std::sqrt(sum) : std::pow(sum, 1.0 / metric);
    };
    return unit(length(sums[1]) - length(sums[0]));
}

TEST(NoiseTwin, Crackle) {
    for (const double metric : {2.0, 3.0, 0.7, 0.003}) {
        const WrittenPattern crackle = pattern_of(fmt::format("crackle metric {}", metric));
        each_batch(all_sorts_of_points(), [&](std::span<const Vec3> batch) {
            std::vector<double> values(batch.size());
            crackle.pattern->evaluate({crackle.modifiers, 2}, batch, values);
            for (size_t i = 0; i < batch.size(); ++i) {
                const Vec3& p = batch[i];
                if (!std::isfinite(p.x + p.y + p.z)) continue;
                const double twin = crackle_twin(p, metric);
                EXPECT_TRUE(same(values[i], twin)) << metric << " at " << p.x << ' ' << p.y << ' ' << p.z
                                                   << ": " << values[i] << ", not " << twin;
            }
        });
    }
}

}  // namespace
}  // namespace rb
