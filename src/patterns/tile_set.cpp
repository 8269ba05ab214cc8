#include "patterns/tile_set.h"

#include "patterns/formula.h"

#include <algorithm>

namespace rb {

namespace {

double cross(const Vec2& a, const Vec2& b) { return a.x * b.y - a.y * b.x; }

double area(std::span<const Vec2> corners) {
    double twice = 0.0;
    for (size_t i = 0; i < corners.size(); ++i) twice += cross(corners[i], corners[(i + 1) % corners.size()]);
    return twice / 2.0;
}

Tile tile_of(int kind, std::span<const Vec2> corners, double reach) {
    Tile tile;
    tile.kind = kind;
    tile.vertices.assign(corners.begin(), corners.end());
    if (area(corners) < 0.0) std::ranges::reverse(tile.vertices);
    for (size_t i = 0; i < tile.vertices.size(); ++i) {
        const Vec2& from = tile.vertices[i];
        const Vec2 along = glm::normalize(tile.vertices[(i + 1) % tile.vertices.size()] - from);
        const Vec2 inward{-along.y, along.x};
        tile.edges.push_back({inward, glm::dot(inward, from), reach});
    }
    return tile;
}

double depth(const Tile& tile, const Vec2& p) {
    double nearest = 1e300;
    for (const Tile::Edge& edge : tile.edges) nearest = std::min(nearest, edge.distance(p));
    return nearest;
}

}  // namespace

TileSet::TileSet(int kinds, double reach, const Vec2& period_1, const Vec2& period_2)
    : kinds_(kinds), reach_(reach), period_1_(period_1), period_2_(period_2) {}

TileSet& TileSet::add(int kind, std::span<const Vec2> corners) {
    tiles_.push_back(tile_of(kind, corners, reach_));
    return *this;
}

TileSet& TileSet::add_box(int kind, const Vec2& low, const Vec2& high) {
    return add(kind, {low, {high.x, low.y}, high, {low.x, high.y}});
}

TileSet& TileSet::add_regular(int kind, int sides, const Vec2& centre, double first_corner) {
    const double radius = 0.5 / std::sin(pi / sides);
    std::vector<Vec2> corners;
    for (int i = 0; i < sides; ++i) {
        const double angle = first_corner * pi / 180.0 + 2.0 * pi * i / sides;
        corners.push_back(centre + radius * Vec2{std::cos(angle), std::sin(angle)});
    }
    return add(kind, corners);
}

TileSet& TileSet::add_turned(int kind, const Vec2& centre, double degrees) {
    const double angle = degrees * pi / 180.0;
    std::vector<Vec2> corners = tiles_.back().vertices;
    for (Vec2& corner : corners) {
        const Vec2 d = corner - centre;
        corner = centre + Vec2{d.x * std::cos(angle) - d.y * std::sin(angle),
                               d.y * std::cos(angle) + d.x * std::sin(angle)};
    }
    return add(kind, corners);
}

TileSet& TileSet::add_mirrored(int kind, int axis, double at) {
    std::vector<Vec2> corners = tiles_.back().vertices;
    for (Vec2& corner : corners) corner[axis] = 2.0 * at - corner[axis];
    return add(kind, corners);
}

TileSet& TileSet::set_reach(std::initializer_list<Vec2> outward, double reach) {
    for (Tile::Edge& edge : tiles_.back().edges) {
        for (const Vec2& direction : outward) {
            if (glm::dot(edge.inward, direction) < -0.999) edge.reach = reach;
        }
    }
    return *this;
}

TileSet& TileSet::set_least(std::initializer_list<int> kinds, double share) {
    for (Tile& tile : tiles_) {
        if (std::ranges::find(kinds, tile.kind) != kinds.end()) tile.least = share;
    }
    return *this;
}

TileSet& TileSet::set_lift(std::initializer_list<int> kinds, double share) {
    for (Tile& tile : tiles_) {
        if (std::ranges::find(kinds, tile.kind) != kinds.end()) tile.lift = share;
    }
    return *this;
}

Vec2 TileSet::in_periods(const Vec2& p) const {
    const double whole = cross(period_1_, period_2_);
    return {cross(p, period_2_) / whole, cross(period_1_, p) / whole};
}

TileSet& TileSet::spread() {
    constexpr int far = 6;
    for (const Tile& tile : tiles_) {
        Vec2 low{1e300};
        Vec2 high{-1e300};
        for (const Vec2& corner : tile.vertices) {
            low = glm::min(low, in_periods(corner));
            high = glm::max(high, in_periods(corner));
        }
        for (int i = -far; i <= far; ++i) {
            for (int j = -far; j <= far; ++j) {
                constexpr double slack = 1e-6;
                const bool reaches_in = high.x + i >= -slack && low.x + i <= 1.0 + slack &&
                                        high.y + j >= -slack && low.y + j <= 1.0 + slack;
                if (!reaches_in) continue;
                Tile copy = tile;
                const Vec2 by = static_cast<double>(i) * period_1_ + static_cast<double>(j) * period_2_;
                for (Vec2& corner : copy.vertices) corner += by;
                for (Tile::Edge& edge : copy.edges) edge.offset += glm::dot(edge.inward, by);
                spread_.push_back(std::move(copy));
            }
        }
    }
    return *this;
}

bool TileSet::covers(const Vec2& p) const {
    constexpr int far = 4;
    for (int i = -far; i <= far; ++i) {
        for (int j = -far; j <= far; ++j) {
            const Vec2 at = p + static_cast<double>(i) * period_1_ + static_cast<double>(j) * period_2_;
            if (std::ranges::any_of(tiles_, [&](const Tile& tile) { return depth(tile, at) > 0.0; }))
                return true;
        }
    }
    return false;
}

TileSet& TileSet::fill_with_triangles() {
    const Vec2 right{1.0, 0.0};
    const Vec2 up{0.5, std::sqrt(0.75)};
    // The periods hold at most seven of the triangles' own cells, and these are all different to them.
    constexpr int count = 3;
    for (int i = 0; i < count; ++i) {
        for (int j = 0; j < count; ++j) {
            const Vec2 corner = static_cast<double>(i) * right + static_cast<double>(j) * up;
            for (const int kind : {0, 1}) {
                const std::array<Vec2, 3> corners{kind == 0 ? corner : corner + right,
                                                  kind == 0 ? corner + right : corner + right + up,
                                                  corner + up};
                if (!covers((corners[0] + corners[1] + corners[2]) / 3.0)) add(kind, corners);
            }
        }
    }
    return *this;
}

double TileSet::value(const Vec2& p) const {
    const Vec2 cell = in_periods(p);
    const Vec2 at = p - quick_floor(cell.x) * period_1_ - quick_floor(cell.y) * period_2_;
    // The tile in which the point lies deepest is the one that holds it, on edges and with rounding, too.
    const Tile* holds = &spread_.front();
    double deepest = -1e300;
    for (const Tile& tile : spread_) {
        double nearest = 1e300;
        for (const Tile::Edge& edge : tile.edges) {
            nearest = std::min(nearest, edge.distance(at));
            if (nearest <= deepest) break;
        }
        if (nearest > deepest) {
            deepest = nearest;
            holds = &tile;
        }
        if (deepest > 0.0) break;
    }
    double share = holds->least;
    for (const Tile::Edge& edge : holds->edges) share = std::max(share, 1.0 - edge.distance(at) / edge.reach);
    return (holds->kind + std::min(share, 1.0) + holds->lift) / kinds_;
}

}  // namespace rb
