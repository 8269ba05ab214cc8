#pragma once
#include "math/vec.h"

#include <span>
#include <vector>

namespace rb {

/// A convex polygon of a tiling, in the xz plane (y of the vertices stands for z).
struct Tile {
    struct Edge {
        Vec2 inward{0.0};  ///< unit
        double offset = 0;
        double reach = 1;  ///< how far from the edge the value has fallen to that of the middle
        double distance(const Vec2& p) const { return glm::dot(inward, p) - offset; }
    };

    int kind = 0;        ///< the tile's class: tiles of one class look the same
    double least = 0.0;  ///< what the share never falls below
    double lift = 0.0;   ///< what is added to it
    std::vector<Vec2> vertices;
    std::vector<Edge> edges;
};

/// A periodic tiling by polygons of one or several classes.
class TileSet {
public:
    /// `reach` is that of all edges that are not given another one.
    TileSet(int kinds, double reach, const Vec2& period_1, const Vec2& period_2);

    /// Adds a tile by its corners in order, turning either way.
    TileSet& add(int kind, std::span<const Vec2> corners);
    TileSet& add(int kind, std::initializer_list<Vec2> corners) {
        return add(kind, std::span<const Vec2>{corners.begin(), corners.size()});
    }
    TileSet& add_box(int kind, const Vec2& low, const Vec2& high);
    /// A regular polygon of side 1 whose first corner is seen from the centre at `first_corner` degrees.
    TileSet& add_regular(int kind, int sides, const Vec2& centre, double first_corner);
    /// Adds the triangles of side 1 that fill the plane (with the corner 0 and a side along x) where no tile
    /// is yet: class 0 those that point to +z, class 1 the others.
    TileSet& fill_with_triangles();
    /// A copy of the tile added last, turned about a point by degrees from x to z.
    TileSet& add_turned(int kind, const Vec2& centre, double degrees);
    /// A copy of the tile added last, mirrored at a line x = `at` (axis 0) or z = `at` (axis 1).
    TileSet& add_mirrored(int kind, int axis, double at);
    /// Sets the reach of those edges of the tile added last whose outward direction is given.
    TileSet& set_reach(std::initializer_list<Vec2> outward, double reach);
    /// The reference keeps some classes a little above the values of the class before: `Tile::least` and
    /// `Tile::lift` of the tiles that are there.
    TileSet& set_least(std::initializer_list<int> kinds, double share);
    TileSet& set_lift(std::initializer_list<int> kinds, double share);

    /// To be called when all tiles are there: lays out all copies that reach into the cell of the periods.
    TileSet& spread();

    /// (class + e) / classes, where e is 1 on the edges and falls to 0 within their reach.
    double value(const Vec2& p) const;

private:
    /// In multiples of the periods.
    Vec2 in_periods(const Vec2& p) const;
    bool covers(const Vec2& p) const;

    int kinds_;
    double reach_;
    Vec2 period_1_;
    Vec2 period_2_;
    std::vector<Tile> tiles_;   ///< one of each
    std::vector<Tile> spread_;  ///< with all copies
};

}  // namespace rb
