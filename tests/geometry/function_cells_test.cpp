#include "shapes/function_cells.h"

#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace rb {
namespace {

/// A wavy ball with a kink, in numbers, intervals and slopes.
template <class T>
T field(const T& x, const T& y, const T& z) {
    using std::abs;
    using std::sin;
    return square(x) + square(y) + 0.5 * abs(z) - 0.8 + 0.1 * sin(7.0 * x) * sin(5.0 * z);
}

const Bounds box{Vec3{-1.0, -1.2, -0.9}, Vec3{1.1, 1.0, 1.3}};

Interval over(const Bounds& b) {
    return field(Interval{b.lo.x, b.hi.x}, Interval{b.lo.y, b.hi.y}, Interval{b.lo.z, b.hi.z});
}

IntervalSlope along(const std::array<IntervalSlope, 3>& p) { return field(p[0], p[1], p[2]); }

class FunctionCellsTest : public ::testing::Test {
protected:
    double number(double lo, double hi) { return std::uniform_real_distribution<double>(lo, hi)(random_); }
    Vec3 place() {
        return {number(box.lo.x, box.hi.x), number(box.lo.y, box.hi.y), number(box.lo.z, box.hi.z)};
    }
    /// From the way in to the way out, along an axis now and then.
    Ray ray(double& enter, double& leave) {
        Ray r{place(), place() - place()};
        if (number(0, 1) < 0.2) r.direction.x = 0.0;
        if (number(0, 1) < 0.2) r.direction.z = 0.0;
        enter = -1e9;
        leave = 1e9;
        for (int i = 0; i < 3; ++i) {
            if (r.direction[i] == 0.0) continue;
            const double a = (box.lo[i] - r.origin[i]) / r.direction[i];
            const double b = (box.hi[i] - r.origin[i]) / r.direction[i];
            enter = std::max(enter, std::min(a, b));
            leave = std::min(leave, std::max(a, b));
        }
        return r;
    }

    const FunctionCells cells_{box, over};
    std::mt19937_64 random_{7};
};

TEST_F(FunctionCellsTest, PiecesFollowOneAnotherAndHaveTheirSigns) {
    size_t clear = 0;
    for (int i = 0; i < 3000; ++i) {
        double enter = 0;
        double leave = 0;
        const Ray r = ray(enter, leave);
        double reached = enter;
        const bool whole = cells_.walk(r, enter, leave, [&](double from, double to, CellSign sign, size_t) {
            EXPECT_EQ(from, reached);
            EXPECT_GE(to, from);
            reached = to;
            for (int k = 0; k <= 8 && sign != CellSign::unclear; ++k) {
                const Vec3 p = r.at(from + (to - from) * k / 8.0);
                EXPECT_EQ(field(p.x, p.y, p.z) < 0.0, sign == CellSign::below);
                ++clear;
            }
            return true;
        });
        EXPECT_TRUE(whole);
        EXPECT_EQ(reached, leave);
    }
    EXPECT_GT(clear, 10000u);
}

TEST_F(FunctionCellsTest, SlopesHoldAllQuotientsOfAPiece) {
    size_t steep = 0;
    for (int i = 0; i < 3000; ++i) {
        double enter = 0;
        double leave = 0;
        const Ray r = ray(enter, leave);
        const auto value = [&](double t) {
            const Vec3 p = r.at(t);
            return field(p.x, p.y, p.z);
        };
        cells_.walk(r, enter, leave, [&](double from, double to, CellSign sign, size_t cell) {
            if (sign != CellSign::unclear || to - from < 1e-3) return true;
            const Interval slope = cells_.content(cell, r.direction, along).slope;
            for (int k = 0; k < 8; ++k) {
                const double a = number(from, to);
                const double b = number(from, to);
                if (std::abs(b - a) < 1e-4) continue;
                const double quotient = (value(b) - value(a)) / (b - a);
                EXPECT_GE(quotient, slope.lo - 1e-10);
                EXPECT_LE(quotient, slope.hi + 1e-10);
            }
            steep += slope.lo > 0.0 || slope.hi < 0.0;
            return true;
        });
    }
    EXPECT_GT(steep, 1000u);
}

TEST_F(FunctionCellsTest, HullHoldsTheSolid) {
    const Bounds hull = cells_.hull(false, true);
    for (int i = 0; i < 20000; ++i) {
        const Vec3 p = place();
        EXPECT_TRUE(field(p.x, p.y, p.z) > 0.0 || hull.contains(p));
    }
    EXPECT_LT(hull.half_area(), 0.95 * box.half_area());
}

TEST_F(FunctionCellsTest, StopsWhenToldTo) {
    int pieces = 0;
    const Ray r{Vec3{-1.0, 0.0, 0.1}, Vec3{1.0, 0.0, 0.0}};
    EXPECT_FALSE(cells_.walk(r, 0.0, 2.1, [&](double, double, CellSign, size_t) { return ++pieces < 2; }));
    EXPECT_EQ(pieces, 2);
}

}  // namespace
}  // namespace rb
