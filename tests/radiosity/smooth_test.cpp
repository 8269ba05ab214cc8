// Records with the chance of their gathers evened out.
#include "radiosity/smooth.h"

#include "math/random.h"

#include <cmath>

#include <gtest/gtest.h>

namespace rb {
namespace {

constexpr int side = 40;
constexpr double spacing = 0.05;
constexpr double bound = 0.1;
constexpr double noise = 0.1;

/// On a square floor, with light and its slope along x as given, and chance added.
template <class Light, class Slope>
std::vector<IrradianceRecord> floor_of(Light light, Slope slope, double chance) {
    std::vector<IrradianceRecord> records;
    for (int i = 0; i < side * side; ++i) {
        IrradianceRecord record;
        record.point = {spacing * (i % side), 0.0, spacing * (i / side)};
        record.normal = {0.0, 1.0, 0.0};
        // Uniform, with the deviation that was asked for.
        const double error =
            chance * std::sqrt(12.0) * (unit_random(mixed(7, static_cast<uint64_t>(i))) - 0.5);
        record.mean = Rgb(static_cast<float>(light(record.point.x) + error));
        record.translation.add({1.0, 0.0, 0.0}, Rgb(static_cast<float>(slope(record.point.x))));
        record.radius = record.wide_radius = 1.0;
        record.variance = noise * noise;
        records.push_back(record);
    }
    return records;
}

template <class Light>
double rms_error(const std::vector<IrradianceRecord>& records, Light light) {
    double sum = 0;
    for (const IrradianceRecord& record : records)
        sum += std::pow(static_cast<double>(record.mean.x) - light(record.point.x), 2);
    return std::sqrt(sum / static_cast<double>(records.size()));
}

TEST(Smooth, EvensOutChance) {
    const auto light = [](double) { return 1.0; };
    const auto records = floor_of(
        light, [](double) { return 0.0; }, noise);
    EXPECT_NEAR(rms_error(records, light), noise, 0.1 * noise);
    EXPECT_LT(rms_error(smoothed(records, bound, 1), light), 0.3 * noise);
}

/// To the second order, up to the borders, where all others lie on one side.
TEST(Smooth, LeavesCurvesAsTheyAre) {
    const auto light = [](double x) { return 2.0 - 0.5 * x * x; };
    const auto records = floor_of(
        light, [](double x) { return -x; }, 0.0);
    EXPECT_LT(rms_error(smoothed(records, bound, 1), light), 1e-6);
}

/// A step of ten deviations is no chance.
TEST(Smooth, KeepsEdges) {
    const auto light = [](double x) { return x < 1.0 ? 1.0 : 2.0; };
    const auto records = floor_of(
        light, [](double) { return 0.0; }, 0.0);
    EXPECT_LT(rms_error(smoothed(records, bound, 1), light), 1e-6);
}

/// What faces elsewhere, or lies on a step above, has other light, however alike.
TEST(Smooth, OtherSurfacesAreLeftAlone) {
    const auto zero = [](double) { return 0.0; };
    auto records = floor_of([](double) { return 1.0; }, zero, 0.0);
    for (size_t i = 0; i < records.size(); i += 2) {
        records[i].mean = Rgb(1.1f);
        if (i % 4 == 0) {
            records[i].normal = {0.0, -1.0, 0.0};
        } else {
            records[i].point.y = spacing;
        }
    }
    const auto after = smoothed(records, bound, 1);
    for (size_t i = 0; i < records.size(); ++i) EXPECT_NEAR(after[i].mean.x, records[i].mean.x, 1e-6f) << i;
}

TEST(Smooth, ThreadsAndPlacesThatAreTheSame) {
    auto records = floor_of([](double) { return 1.0; }, [](double) { return 0.0; }, noise);
    for (size_t i = 0; i < records.size(); i += 3) records[i].point = records[0].point;
    const auto one = smoothed(records, bound, 1);
    const auto three = smoothed(records, bound, 3);
    for (size_t i = 0; i < records.size(); ++i) EXPECT_EQ(one[i].mean, three[i].mean) << i;
    EXPECT_TRUE(smoothed({}, bound, 1).empty());
}

}  // namespace
}  // namespace rb
