#include "shapes/mesh_refinement.h"
#include "shapes/parametric_shape.h"

#include <algorithm>
#include <cmath>

namespace rb {

namespace {

/// How much farther from the mean slope the slope may be anywhere.
double spread(const Interval& slope, double mean) {
    return slope.maybe_nan ? std::numeric_limits<double>::infinity()
                           : std::max(slope.hi - mean, mean - slope.lo);
}

}  // namespace

/// A grid of points of the surface; cells are cut into two triangles.
struct Parametric::Grid {
    const ParametricData* data;
    uint32_t columns, rows;
    std::vector<Vec3> points;

    Grid(const ParametricData& of, uint32_t along_u, uint32_t along_v)
        : data(&of), columns(along_u), rows(along_v) {
        points.reserve(size_t{columns + 1} * (rows + 1));
        for (uint32_t k = 0; k <= rows; ++k) {
            for (uint32_t i = 0; i <= columns; ++i) points.push_back(data->at(place(i, k)));
        }
    }
    Vec2 place(uint32_t i, uint32_t k) const {
        return data->lo +
               Vec2{static_cast<double>(i) / columns, static_cast<double>(k) / rows} * (data->hi - data->lo);
    }
    uint32_t index(uint32_t i, uint32_t k) const { return k * (columns + 1) + i; }

    /// How far a cell's triangles may be from the surface because its slopes along u and along v differ. A
    /// triangle's point is as far from its corner along both as slopes take it, and so is the surface's.
    Vec2 error(uint32_t i, uint32_t k) const {
        const Vec2 lo = place(i, k);
        const Vec2 hi = place(i + 1, k + 1);
        const Vec2 size = hi - lo;
        Vec3 along_u{0.0};
        Vec3 along_v{0.0};
        for (int axis = 0; axis < 3; ++axis) {
            const Function& f = *data->functions[static_cast<size_t>(axis)];
            const auto at = [&](uint32_t column, uint32_t row) { return points[index(column, row)][axis]; };
            const auto slope = [&](double by_u, double by_v) {
                const std::array<IntervalSlope, 3> uv{IntervalSlope{Interval{lo.x, hi.x}, by_u},
                                                      IntervalSlope{Interval{lo.y, hi.y}, by_v}, 0.0};
                return f.bound_slope({uv.data(), static_cast<size_t>(f.parameter_count())}, 0).slope;
            };
            const Interval by_u = slope(size.x, 0.0);
            const Interval by_v = slope(0.0, size.y);
            along_u[axis] = std::max(spread(by_u, at(i + 1, k) - at(i, k)),
                                     spread(by_u, at(i + 1, k + 1) - at(i, k + 1)));
            along_v[axis] = std::max(spread(by_v, at(i, k + 1) - at(i, k)),
                                     spread(by_v, at(i + 1, k + 1) - at(i + 1, k)));
        }
        return {glm::length(along_u), glm::length(along_v)};
    }

    /// The largest errors of all cells; only so far as to know that they are too large.
    Vec2 error(double within) const {
        Vec2 most{0.0};
        for (uint32_t k = 0; k < rows; ++k) {
            for (uint32_t i = 0; i < columns; ++i) {
                most = glm::max(most, error(i, k));
                if (!(std::max(most.x, most.y) <= within)) return most;
            }
        }
        return most;
    }
};

std::optional<TriangleMesh> Parametric::tessellate(double tolerance) const {
    const double within = tolerance - float_rounding(bounds_);
    constexpr uint32_t coarsest = 16;
    Grid grid(data_, coarsest, coarsest);
    const auto is_held = [&](const Vec3& p) { return data_.container.holds(p, tolerance); };
    if (!std::ranges::all_of(grid.points, is_held)) return std::nullopt;
    for (;;) {
        const Vec2 error = grid.error(within);
        if (!std::isfinite(error.x + error.y)) return std::nullopt;
        if (std::max(error.x, error.y) <= within) break;
        if (size_t{4} * grid.columns * grid.rows > most_mesh_faces) return std::nullopt;
        const bool along_u = error.x > error.y;
        grid = Grid(data_, along_u ? 2 * grid.columns : grid.columns, along_u ? grid.rows : 2 * grid.rows);
    }
    if (!std::ranges::all_of(grid.points, is_held)) return std::nullopt;
    TriangleMesh mesh;
    mesh.error = tolerance;
    for (const Vec3& p : grid.points) mesh.vertices.emplace_back(p);
    const auto add = [&](uint32_t a, uint32_t b, uint32_t c) {
        const auto corner = [&](uint32_t k) { return Vec3(mesh.vertices[k]); };
        // At a pole one side is a point.
        if (glm::cross(corner(b) - corner(a), corner(c) - corner(a)) != Vec3{0.0})
            mesh.faces.push_back({a, b, c});
    };
    for (uint32_t k = 0; k < grid.rows; ++k) {
        for (uint32_t i = 0; i < grid.columns; ++i) {
            add(grid.index(i, k), grid.index(i + 1, k), grid.index(i, k + 1));
            add(grid.index(i + 1, k + 1), grid.index(i, k + 1), grid.index(i + 1, k));
        }
    }
    return mesh;
}

}  // namespace rb
