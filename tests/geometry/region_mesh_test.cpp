#include "shapes/region_mesh.h"

#include <cmath>

#include <gtest/gtest.h>

namespace rb {
namespace {

double area_of(const RegionMesh& mesh) {
    double area = 0;
    for (const auto& t : mesh.triangles) {
        const Vec2 a = mesh.points[t[1]] - mesh.points[t[0]];
        const Vec2 b = mesh.points[t[2]] - mesh.points[t[0]];
        area += 0.5 * std::abs(a.x * b.y - a.y * b.x);
    }
    return area;
}

// Edges that cross end up a bit on the wrong side of each other where they do; no part may get lost for that.
TEST(RegionMesh, AStarHasFiveTipsHoweverItIsTurned) {
    const std::vector<Vec2> star{{0, 1}, {0.59, -0.81}, {-0.95, 0.31}, {0.95, 0.31}, {-0.59, -0.81}};
    const double area = area_of(triangulate({star}));
    EXPECT_NEAR(area, 0.776545, 1e-6);
    for (int k = 0; k < 1000; ++k) {
        const double turn = 0.00628 * k;
        std::vector<Vec2> turned;
        for (const Vec2& p : star) {
            turned.emplace_back(p.x * std::cos(turn) - p.y * std::sin(turn),
                                p.x * std::sin(turn) + p.y * std::cos(turn));
        }
        EXPECT_NEAR(area_of(triangulate({turned})), area, 1e-5) << turn;
    }
}

}  // namespace
}  // namespace rb
