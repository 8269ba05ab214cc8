#include "patterns/noise.h"

#include "noise_values.h"
#include "patterns/noise_tables.h"

#include <gtest/gtest.h>

namespace rb {
namespace {

TEST(NoiseTables, HashTableMatchesTheMeasuredEntries) {
    EXPECT_EQ(hash_table[0], 2291);
    EXPECT_EQ(hash_table[100], 1305);
    EXPECT_EQ(hash_table[4095], 3088);
    uint32_t sum = 0;
    for (uint32_t i = 0; i < 4096; ++i) sum += i * hash_table[i];
    EXPECT_EQ(sum, 368744729u);
}

TEST(NoiseTables, GradientTablesMatchTheMeasuredEntries) {
    const GradientTables& t = gradient_tables();
    EXPECT_NEAR(t.gradient[0].x, 0.6044250694, 1e-10);
    EXPECT_NEAR(t.gradient[2047].z, -0.7505079127, 1e-10);
    EXPECT_EQ(t.order[2046], 1710);
    uint32_t sum = 0;
    for (uint32_t i = 0; i < 2048; ++i) sum += i * t.order[i];
    EXPECT_EQ(sum, 2375277354u);
}

TEST(NoiseTables, UniformNumbersAreThoseOfTheTwister) {
    EXPECT_NEAR(uniform_table()[0], 0.814723691903, 1e-12);
    EXPECT_NEAR(uniform_table()[4095], 0.938243110664, 1e-12);
    EXPECT_NEAR(uniform_table()[32767], 0.752209920669, 1e-12);
}

TEST(Noise, MatchesTheMeasuredTable) {
    for (const NoiseRow& row : noise_rows) {
        const Vec3 p{row.p[0], row.p[1], row.p[2]};
        for (int g = 1; g <= 3; ++g) {
            EXPECT_NEAR(noise(p, g), row.value[g - 1], 6e-11)
                << p.x << ' ' << p.y << ' ' << p.z << " gen " << g;
        }
    }
}

TEST(Noise, BatchEqualsScalar) {
    std::vector<Vec3> points;
    for (const NoiseRow& row : noise_rows) points.push_back({row.p[0], row.p[1], row.p[2]});
    std::vector<double> values(points.size());
    for (int g = 1; g <= 3; ++g) {
        noise(points, 1.0, g, values);
        for (size_t i = 0; i < points.size(); ++i) EXPECT_EQ(values[i], noise(points[i], g));
    }
}

TEST(Noise, VectorNoiseAndTurbulenceMatchTheMeasuredTable) {
    for (const VectorNoiseRow& row : vector_noise_rows) {
        const Vec3 p{row.p[0], row.p[1], row.p[2]};
        const Vec3 n = vector_noise(p);
        const Vec3 t = vector_turbulence(p, TurbulenceWarp{});
        for (int axis = 0; axis < 3; ++axis) {
            EXPECT_NEAR(n[axis], row.noise[axis], 6e-11);
            EXPECT_NEAR(t[axis], row.turbulence[axis], 6e-11);
        }
    }
}

TEST(Noise, ScalarTurbulenceMatchesTheMeasuredTable) {
    const Vec3 points[3] = {{0.3, 0.7, -0.4}, {1.25, -2.5, 3.75}, {-3.1, 4.2, -5.3}};
    for (const TurbulenceRow& row : turbulence_rows) {
        TurbulenceWarp shape;
        shape.octaves = row.octaves;
        shape.lambda = row.lambda;
        shape.omega = row.omega;
        for (int i = 0; i < 3; ++i) {
            EXPECT_NEAR(turbulence(points[i], shape, row.generator), row.value[i], 6e-11);
        }
    }
}

TEST(Noise, WaveSourcesMatchTheMeasuredTable) {
    const auto sources = wave_sources(10);
    EXPECT_NEAR(sources[0].frequency, 0.919115878781, 1e-12);
    EXPECT_NEAR(sources[9].frequency, 0.168513138218, 1e-12);
    EXPECT_NEAR(sources[0].center.x, -0.604378213258, 1e-12);
    EXPECT_NEAR(sources[9].center.z, -0.399436076735, 1e-12);
}

TEST(Noise, FarOutsideTheLatticeScalarNoiseStaysInRange) {
    for (const double far : {3e9, -3e9, 1e17, -1e17}) {
        for (int g = 1; g <= 3; ++g) {
            const double v = noise({far, 0.5, -far}, g);
            EXPECT_GE(v, 0.0);
            EXPECT_LE(v, 1.0);
        }
    }
}

}  // namespace
}  // namespace rb
