// tiling N (manual 3.4.7.1.29): 24 periodic tilings by polygons and three by Penrose, in the xz plane.
#include "patterns/formula.h"
#include "patterns/penrose.h"
#include "patterns/tile_set.h"

#include <array>

namespace rb {

namespace {

/// Height of the triangle of side 1, and 1/sqrt(2).
constexpr double h = 0.86602540378443864676;
constexpr double root_half = 0.70710678118654752440;
/// Reaches: half a square, and the radius of the circle in a triangle of side 1.
constexpr double half = 0.5;
constexpr double in_triangle = 1.0 / (4.0 * h);

TileSet squares() { return TileSet(1, half, {1, 0}, {0, 1}).add_box(0, {0, 0}, {1, 1}); }

TileSet hexagons() { return TileSet(1, h, {1.5, h}, {0, 2 * h}).add_regular(0, 6, {0.5, h}, 0); }

TileSet triangles() { return TileSet(2, in_triangle, {1, 0}, {0.5, h}).fill_with_triangles(); }

TileSet lozenges() {
    return TileSet(1, h / 2, {1, 0}, {0.5, h}).add(0, {{0, 0}, {1, 0}, {1.5, h}, {0.5, h}});
}

TileSet rhombs() {
    return TileSet(3, h / 2, {1.5, h}, {0, 2 * h})
        .add(0, {{0, 0}, {1, 0}, {1.5, h}, {0.5, h}})
        .add(1, {{0, 0}, {0.5, h}, {0, 2 * h}, {-0.5, h}})
        .add(2, {{1.5, h}, {0.5, h}, {0, 2 * h}, {1, 2 * h}});
}

TileSet rectangles() {
    return TileSet(2, half, {1, 1}, {4, 0}).add_box(1, {0, 0}, {1, 2}).add_box(0, {1, 0}, {3, 1});
}

TileSet octagons_and_squares() {
    constexpr double period = 1.0 + 2.0 * root_half;
    constexpr double c = period / 2.0;
    return TileSet(2, half, {period, 0}, {0, period})
        .add_regular(0, 4, {c, c}, 0)
        .add_regular(1, 8, {0, 0}, 22.5)
        .set_least({1}, 2e-12);
}

TileSet squares_and_triangles() {
    return TileSet(3, in_triangle, {1, 0}, {0.5, 1 + h})
        .add_box(2, {0, 0}, {1, 1})
        .add(0, {{0, 1}, {1, 1}, {0.5, 1 + h}})
        .add(1, {{1, 1}, {1.5, 1 + h}, {0.5, 1 + h}})
        .set_lift({2}, 1e-7);
}

TileSet hexagons_and_triangles() {
    return TileSet(3, in_triangle, {2, 0}, {1, 2 * h})
        .add_regular(2, 6, {0.5, h}, 0)
        .add(0, {{-1, 0}, {0, 0}, {-0.5, h}})
        .add(1, {{-1, 2 * h}, {0, 2 * h}, {-0.5, h}})
        .set_least({2}, 1e-7);
}

TileSet shifted_squares() { return TileSet(1, half, {1, 0}, {0.5, 1}).add_box(0, {0, 0}, {1, 1}); }

/// A square with four rectangles around it.
struct Box {
    int kind;
    Vec2 low;
    Vec2 high;
};
const std::array<Box, 5> whirl{{{0, {1, 1}, {2, 2}},
                                {2, {0, 0}, {1, 2}},
                                {2, {2, 1}, {3, 3}},
                                {1, {1, 0}, {3, 1}},
                                {1, {0, 2}, {2, 3}}}};

TileSet squares_and_rectangles() {
    TileSet set(3, half, {3, 0}, {0, 3});
    for (const Box& box : whirl) set.add_box(box.kind, box.low, box.high);
    return set;
}

TileSet mirrored_squares_and_rectangles() {
    TileSet set(3, half, {6, 0}, {0, 6});
    for (const Box& box : whirl) {
        set.add_box(box.kind, box.low + 3.0, box.high + 3.0)
            .add_mirrored(box.kind, 0, 3)
            .add_mirrored(box.kind, 1, 3)
            .add_mirrored(box.kind, 0, 3);
    }
    return set;
}

/// A square within a square; the classes of the middle and of the trapezoids right, left, below, above.
TileSet squares_within(int kinds, const std::array<int, 5>& kind) {
    constexpr double s = root_half;
    return TileSet(kinds, half * s, {4 * s, 0}, {0, 4 * s})
        .add_box(kind[0], {s, s}, {3 * s, 3 * s})
        .add(kind[1], {{3 * s, s}, {4 * s, 0}, {4 * s, 4 * s}, {3 * s, 3 * s}})
        .add(kind[2], {{s, s}, {0, 0}, {0, 4 * s}, {s, 3 * s}})
        .add(kind[3], {{s, s}, {0, 0}, {4 * s, 0}, {3 * s, s}})
        .add(kind[4], {{s, 3 * s}, {0, 4 * s}, {4 * s, 4 * s}, {3 * s, 3 * s}});
}
TileSet squares_within_3() { return squares_within(3, {0, 2, 2, 1, 1}); }
TileSet squares_within_5() { return squares_within(5, {4, 0, 1, 2, 3}).set_lift({4}, 1e-6); }

TileSet small_and_large_squares() {
    return TileSet(2, half, {2, 1}, {-1, 2})
        .add_box(0, {0, 0}, {1, 1})
        .add_box(1, {1, -1}, {3, 1})
        .set_lift({1}, 2e-8);
}

/// The classes: hexagon, the square below it, that square turned by 60 and -60 degrees, two triangles.
TileSet hexagons_squares_triangles(int kinds, const std::array<int, 6>& kind) {
    const Vec2 centre{h + 0.5, h + 0.5};
    return TileSet(kinds, in_triangle, {1.5 + h, 0.5 + h}, {0, 1 + 2 * h})
        .add_regular(kind[0], 6, centre, 0)
        .add_box(kind[1], {h, -0.5}, {h + 1, 0.5})
        .add_turned(kind[2], centre, 60)
        .add_turned(kind[3], centre, -120)
        .add(kind[4], {{h, -0.5}, {h, 0.5}, {0, 0}})
        .add(kind[5], {{h + 1, -0.5}, {h + 1, 0.5}, {2 * h + 1, 0}});
}
TileSet hexagons_squares_triangles_3() {
    return hexagons_squares_triangles(3, {2, 0, 0, 0, 1, 1}).set_least({2}, 1e-7);
}
TileSet hexagons_squares_triangles_6() {
    return hexagons_squares_triangles(6, {5, 0, 2, 1, 4, 3}).set_least({5}, 1e-6).set_lift({1, 2}, 1e-6);
}

TileSet pairs_of_rectangles() {
    return TileSet(2, half, {2, 2}, {4, 0})
        .add_box(1, {0, 0}, {1, 2})
        .add_box(1, {1, 0}, {2, 2})
        .add_box(0, {2, 0}, {4, 1})
        .add_box(0, {2, 1}, {4, 2});
}

TileSet hexagons_in_triangles(double side) {
    return TileSet(3, in_triangle, {2.5, -side * h}, {2, side * 2 * h})
        .add_regular(2, 6, {1, 2 * h}, 0)
        .fill_with_triangles()
        .set_least({2}, 1e-6);
}
TileSet hexagons_in_triangles_right() { return hexagons_in_triangles(1); }
TileSet hexagons_in_triangles_left() { return hexagons_in_triangles(-1); }

TileSet turned_squares_and_triangles() {
    constexpr double a = 1 + 2 * h;
    return TileSet(6, in_triangle, {a / 2, a / 2}, {a, 0})
        .add(0, {{0, -0.5}, {0, 0.5}, {h, 0}})
        .add(2, {{0, -0.5}, {0, 0.5}, {-h, 0}})
        .add(3, {{h, 0}, {h + 1, 0}, {h + 0.5, h}})
        .add(1, {{h, 0}, {h + 1, 0}, {h + 0.5, -h}})
        .add(4, {{0, 0.5}, {h, 0}, {h + 0.5, h}, {0.5, 0.5 + h}})
        .add(5, {{h + 0.5, h}, {h + 1, 0}, {2 * h + 1, 0.5}, {2 * h + 0.5, h + 0.5}})
        .set_least({4, 5}, 1e-6);
}

TileSet dodecagons_and_triangles() {
    return TileSet(3, in_triangle, {2 + 2 * h, 0}, {1 + h, 1.5 + 2 * h})
        .add_regular(2, 12, {1 + h, 1 + h}, 15)
        .set_reach({{1, 0}, {-1, 0}, {0, -1}}, 1.0 / 3.0)
        .add(1, {{h + 0.5, 0}, {h + 1.5, 0}, {1 + h, -h}})
        .add(0, {{h + 0.5, 2 + 2 * h}, {h + 1.5, 2 + 2 * h}, {1 + h, 2 + 3 * h}})
        .set_lift({2}, 1e-7);
}

/// The classes: dodecagon, hexagons, upright squares, squares leaning to either side.
TileSet dodecagons_and_hexagons(int kinds, const std::array<int, 5>& kind) {
    return TileSet(kinds, half, {3 + 2 * h, 0}, {1.5 + h, 1.5 + 3 * h})
        .add_regular(kind[0], 12, {1.5 + h, 1 + 2 * h}, 15)
        .add_regular(kind[1], 6, {1.5 + h, 0}, 0)
        .add_regular(kind[1], 6, {0, 0.5 + h}, 0)
        .add_box(kind[2], {-0.5, 2 * h + 0.5}, {0.5, 2 * h + 1.5})
        .add(kind[3], {{0.5, 0.5}, {0.5 + h, 0}, {1 + h, h}, {1, 0.5 + h}})
        .add_mirrored(kind[4], 0, 1.5 + h)
        .set_lift({kind[0]}, 1e-6);
}
TileSet dodecagons_and_hexagons_3() { return dodecagons_and_hexagons(3, {2, 0, 1, 1, 1}); }
TileSet dodecagons_and_hexagons_5() { return dodecagons_and_hexagons(5, {4, 0, 1, 2, 3}); }

constexpr std::array tile_sets{squares,
                               hexagons,
                               triangles,
                               lozenges,
                               rhombs,
                               rectangles,
                               octagons_and_squares,
                               squares_and_triangles,
                               hexagons_and_triangles,
                               shifted_squares,
                               squares_and_rectangles,
                               mirrored_squares_and_rectangles,
                               squares_within_3,
                               squares_within_5,
                               small_and_large_squares,
                               hexagons_squares_triangles_3,
                               hexagons_squares_triangles_6,
                               pairs_of_rectangles,
                               hexagons_in_triangles_right,
                               hexagons_in_triangles_left,
                               turned_squares_and_triangles,
                               dodecagons_and_triangles,
                               dodecagons_and_hexagons_3,
                               dodecagons_and_hexagons_5};

class PeriodicTiling final : public Pattern {
public:
    explicit PeriodicTiling(int number)
        : number_(number), tiles_(tile_sets.at(static_cast<size_t>(number - 1))().spread()) {}
    std::string_view keyword() const override { return "tiling"; }
    std::string describe() const override { return fmt::format("tiling {}", number_); }
    void evaluate(const PatternContext&, std::span<const Vec3> points,
                  std::span<double> values) const override {
        for (size_t i = 0; i < points.size(); ++i) values[i] = tiles_.value({points[i].x, points[i].z});
    }

private:
    int number_;
    TileSet tiles_;
};

class PenroseTiling final : public Pattern {
public:
    explicit PenroseTiling(int number) : number_(number) {}
    std::string_view keyword() const override { return "tiling"; }
    std::string describe() const override { return fmt::format("tiling {}", number_); }
    void evaluate(const PatternContext&, std::span<const Vec3> points,
                  std::span<double> values) const override {
        const auto value =
            number_ == 25 ? penrose_pentagons : (number_ == 26 ? penrose_kites : penrose_rhombs);
        for (size_t i = 0; i < points.size(); ++i) values[i] = value(points[i].x, points[i].z);
    }

private:
    int number_;
};

PatternPtr read(BlockReader& in) {
    const SourceRange at = in.where();
    const int number = in.integer();
    if (number < 1 || number > 27) in.fail_at(at, "Tiling number must be between 1 and 27.");
    if (static_cast<size_t>(number) > tile_sets.size()) return std::make_shared<PenroseTiling>(number);
    return std::make_shared<PeriodicTiling>(number);
}

}  // namespace

namespace patterns {
extern const PatternKind tiling;
const PatternKind tiling{.keyword = "tiling", .read = read, .example = "tiling 16"};
}  // namespace patterns

}  // namespace rb
