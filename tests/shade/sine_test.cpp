// Sines of many numbers against the same series written plainly for one, bit for bit, and against std::sin().
#include "patterns/sine.h"

#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace rb {
namespace {

double twin(double x) {
    if (!(std::abs(x) < 1e6)) return std::sin(x);
    const double shifted = x * 0.63661977236758134308 + 0x1.8p52;
    const double turns = shifted - 0x1.8p52;
    const double r = x - turns * 0x1.921fb544p+0 - turns * 0x1.0b4611a6p-34 - turns * 0x1.3198a2e037073p-69;
    const double s = r * r;
    const auto quarters = static_cast<int64_t>(turns);
    // From the last term to the first.
    double sum = 0;
    if (quarters & 1) {
        sum = 1.0 / 87178291200 - s * (1.0 / 20922789888000);
        for (const double k : {479001600.0, 3628800.0, 40320.0, 720.0, 24.0}) sum = 1.0 / k - s * sum;
        sum = 1.0 - s * (0.5 - s * sum);
    } else {
        sum = 1.0 / 6227020800 - s * (1.0 / 1307674368000);
        for (const double k : {-39916800.0, 362880.0, -5040.0, 120.0, -6.0}) sum = 1.0 / k + s * sum;
        sum = r + r * s * sum;
    }
    return quarters & 2 ? -sum : sum;
}

std::vector<double> all_sorts_of_numbers() {
    std::mt19937 draw(11);
    std::uniform_real_distribution<double> unit_range(-1.0, 1.0);
    std::vector<double> numbers{0.0,
                                -0.0,
                                1e-300,
                                1e6,
                                -1e6,
                                1e15,
                                1e300,
                                std::numeric_limits<double>::infinity(),
                                std::numeric_limits<double>::quiet_NaN()};
    for (int i = 0; i < 2000; ++i) {
        for (const double size : {1e-9, 0.5, 4.0, 300.0, 1e5, 2e6})
            numbers.push_back(size * unit_range(draw));
        numbers.push_back(std::nextafter(0.7853981633974483 * i, i % 2 ? 1e9 : -1e9));
    }
    return numbers;
}

TEST(Sine, EqualsItsTwinAndIsNearTheTrueOne) {
    const std::vector<double> numbers = all_sorts_of_numbers();
    size_t size = 1;
    for (size_t first = 0; first < numbers.size(); first += size, size = size % 19 + 1) {
        const size_t count = std::min(size, numbers.size() - first);
        std::vector<double> values(numbers.begin() + static_cast<std::ptrdiff_t>(first),
                                   numbers.begin() + static_cast<std::ptrdiff_t>(first + count));
        sines(values);
        for (size_t i = 0; i < count; ++i) {
            const double x = numbers[first + i];
            const double expected = twin(x);
            if (std::isnan(expected)) {
                EXPECT_TRUE(std::isnan(values[i]));
                continue;
            }
            EXPECT_EQ(std::memcmp(&values[i], &expected, sizeof expected), 0) << x;
            EXPECT_NEAR(values[i], std::sin(x), 3e-16) << x;
        }
    }
}

}  // namespace
}  // namespace rb
