#include "render/uv_grid.h"

#include <limits>
#include <random>

#include <gtest/gtest.h>

namespace rb {
namespace {

void expect_same(const UvGrid& grid, const Vec2& uv) {
    const auto quick = grid.find(uv);
    const auto slow = grid.find_slowly(uv);
    ASSERT_EQ(quick.has_value(), slow.has_value());
    if (!quick) return;
    EXPECT_EQ(quick->triangle, slow->triangle);
    EXPECT_EQ(quick->b, slow->b);
    EXPECT_EQ(quick->c, slow->c);
}

TEST(UvGrid, FindsWhatLookingAtEachFinds) {
    std::mt19937 random(2);
    std::uniform_real_distribution<double> place(-0.2, 1.2);
    for (const double size : {0.02, 0.3, 3.0}) {
        std::uniform_real_distribution<double> away(-size, size);
        std::vector<Vec2> uvs;
        std::vector<std::array<uint32_t, 3>> triangles;
        for (uint32_t i = 0; i < 500; ++i) {
            const Vec2 a{place(random), place(random)};
            const Vec2 to_b{away(random), away(random)};
            // Every tenth is a sliver, or no triangle at all.
            const Vec2 to_c = i % 10 ? Vec2{away(random), away(random)} : 0.5 * to_b + away(random) * 1e-16;
            uvs.insert(uvs.end(), {a, a + to_b, a + to_c});
            triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
        }
        uvs[0].x = std::numeric_limits<double>::infinity();
        const UvGrid grid(uvs, triangles);
        for (int i = 0; i < 5000; ++i) expect_same(grid, {place(random), place(random)});
        // Corners and edges.
        for (uint32_t i = 1; i < 500; ++i) {
            expect_same(grid, uvs[3 * i + 1]);
            expect_same(grid, 0.5 * (uvs[3 * i] + uvs[3 * i + 2]));
        }
    }
}

TEST(UvGrid, NothingToFind) {
    const std::vector<Vec2> uvs{{0, 0}};
    EXPECT_FALSE(UvGrid(uvs, {}).find({0.5, 0.5}));
    const std::vector<std::array<uint32_t, 3>> triangles{{0, 0, 0}};
    EXPECT_FALSE(UvGrid(uvs, triangles).find({0, 0}));
}

}  // namespace
}  // namespace rb
