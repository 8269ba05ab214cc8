#include "shapes/marched_mesh.h"
#include "shapes/mesh_refinement.h"
#include "shapes/sphere_sweep_shape.h"

#include <algorithm>
#include <cmath>

namespace rb {

namespace {

double squared(const Vec3& v) { return glm::dot(v, v); }

}  // namespace

/// Vertices on the surface, each moved out and in by the tolerance. All of a face is near the surface if all
/// of it moved out lies outside and all of it moved in lies inside.
///
/// Less |p|^2, the power of a point p, the least |p - c|^2 - r^2 of all balls, is the least of affine
/// functions, hence concave: on a triangle it is at least what its corners say, less the square of the
/// triangle's enclosing radius. And a ball that holds the corners holds the triangle.
class SphereSweep::Facets {
public:
    Facets(const SphereSweep& sweep, double within, double cell)
        : sweep_(sweep), within_(within), step_(step_share * within), reach_(3.0 * cell) {}

    /// Takes a mesh around the sweep, whose vertices are near the surface.
    std::vector<MeshFace> start_with(const TriangleMesh& mesh) {
        const std::vector<Vec3> outward = ways_out(mesh);
        for (size_t i = 0; i < outward.size(); ++i)
            add(onto_balls(Vec3(mesh.vertices[i])), glm::normalize(outward[i]));
        return mesh.faces;
    }

    Vec3 point(uint32_t i) const { return vertices_[i].point; }

    uint32_t between(uint32_t a, uint32_t b, const Vec3& way_out) {
        const Vec3 outward = glm::normalize(way_out);
        const Vec3 middle = 0.5 * (point(a) + point(b));
        const double length = glm::length(point(b) - point(a));
        Vec3 p = onto_balls(middle);
        // In a groove the nearest ball may be where the edge began.
        constexpr double apart = 0.25;
        if (std::min(glm::length(p - point(a)), glm::length(p - point(b))) < apart * length)
            p = onto_surface(middle, outward, length);
        add(p, outward);
        return static_cast<uint32_t>(vertices_.size() - 1);
    }

    bool is_near(const MeshFace& face) const {
        const std::array<const Vertex*, 3> v{&vertices_[face[0]], &vertices_[face[1]], &vertices_[face[2]]};
        // Every point of a triangle is as near to a corner.
        if (enclosing_radius(v[0]->point, v[1]->point, v[2]->point) <= within_ - step_)
            return std::ranges::all_of(v, [](const Vertex* k) { return k->is_at_surface; });
        const double radius = enclosing_radius(v[0]->out, v[1]->out, v[2]->out);
        const auto is_outside = [&](const Vertex* k) { return k->power_out > radius * radius; };
        const auto holds_all = [&](const Vertex* ball) {
            return std::ranges::all_of(v, [&](const Vertex* k) {
                return squared(k->in - Vec3{ball->ball}) < ball->ball.w * ball->ball.w;
            });
        };
        return std::ranges::all_of(v, is_outside) && std::ranges::any_of(v, holds_all);
    }

private:
    static constexpr double step_share = 0.8;

    struct Vertex {
        Vec3 point;
        bool is_at_surface;  ///< within a step
        Vec3 out;            ///< moved out
        Vec3 in;             ///< moved in
        double power_out;    ///< at most the power of `out`
        Ball ball;           ///< around `in`, as deep as can be
    };

    void add(const Vec3& p, const Vec3& outward) {
        const Vec3 in = p - step_ * outward;
        const Vec3 out = away_from_balls(p, outward);
        const Ball outside = sweep_.deepest_ball(out, reach_);
        const double power = squared(out - Vec3{outside}) - outside.w * outside.w;
        const Ball ball = sweep_.deepest_ball(p, reach_);
        const bool is_in_ball = glm::length(p - Vec3{ball}) <= std::abs(ball.w) + step_;
        vertices_.push_back({p, is_in_ball && power > 0.0, out, in, std::min(power, reach_ * reach_),
                             sweep_.deepest_ball(in, reach_)});
    }

    /// In a groove the way out of one side may lead into the other: then it has to turn.
    Vec3 away_from_balls(const Vec3& p, Vec3 outward) const {
        Vec3 best = p + step_ * outward;
        double most = -std::numeric_limits<double>::infinity();
        constexpr int most_turns = 16;
        for (double weight = 1.0; weight > 1.0 / most_turns; weight *= 0.75) {
            const Vec3 out = p + step_ * outward;
            const Ball ball = sweep_.deepest_ball(out, reach_);
            const Vec3 from_center = out - Vec3{ball};
            const double distance = glm::length(from_center);
            const double room = distance - std::abs(ball.w);
            if (room > most) best = out;
            most = std::max(most, room);
            if (!(room < 0.5 * step_)) break;
            outward = glm::normalize(outward + weight / distance * from_center);
        }
        return best;
    }

    /// From ball to deepest ball.
    Vec3 onto_balls(Vec3 p) const {
        constexpr int most_steps = 12;
        constexpr double enough = 0.01;
        for (int i = 0; i < most_steps; ++i) {
            const Ball ball = sweep_.deepest_ball(p, reach_);
            const Vec3 from_center = p - Vec3{ball};
            const double distance = glm::length(from_center);
            if (!(distance > 0.0)) break;
            const double way = std::abs(ball.w) - distance;
            p += (way / distance) * from_center;
            if (std::abs(way) < enough * within_) break;
        }
        return p;
    }

    /// Up or down the way out, to the nearest crossing.
    Vec3 onto_surface(const Vec3& p, const Vec3& outward, double reach) const {
        Crossings all;
        sweep_.crossings(ShapeRay{{p - reach * outward, outward}, 0.0, 2.0 * reach}, all);
        double nearest = 2.0 * reach;
        for (size_t i = 0; i < all.size(); ++i) {
            if (std::abs(all[i].t - reach) < std::abs(nearest - reach)) nearest = all[i].t;
        }
        return p + (nearest < 2.0 * reach ? nearest - reach : 0.0) * outward;
    }

    const SphereSweep& sweep_;
    double within_;
    double step_;   ///< how far vertices are moved
    double reach_;  ///< how far balls may be that are looked at
    std::vector<Vertex> vertices_;
};

/// A ball of radius 0 far away if no ball comes within `reach` of the point.
Ball SphereSweep::deepest_ball(const Vec3& p, double reach) const {
    double level = std::numeric_limits<double>::infinity();
    Ball best{std::numeric_limits<double>::infinity(), 0.0, 0.0, 0.0};
    each_range(
        [&](const SweepBound& bound) {
            const double within = bound.radius + reach;
            return squared(bound.center - p) <= within * within;
        },
        [&](const SweepRange& range) {
            const DeepestBall found = deepest(pieces_[range.piece], range, p);
            if (found.level >= level) return;
            level = found.level;
            best = pieces_[range.piece].at(found.w);
        });
    return best;
}

std::optional<TriangleMesh> SphereSweep::tessellate(double tolerance) const {
    const Vec3 size = bounds_.size();
    constexpr double coarsest = 1.0 / 24.0;
    double cell = coarsest * std::max({size.x, size.y, size.z});
    for (const SweepPiece& piece : pieces_) {
        double thickest = 0.0;
        for (const Ball& ball : piece.control) thickest = std::max(thickest, std::abs(ball.w));
        cell = std::min(cell, thickest);
    }
    constexpr double most_cubes = 4e6;
    if (!(size.x * size.y * size.z < most_cubes * cell * cell * cell)) return std::nullopt;
    const auto power = [&](const Vec3& p) {
        const Ball ball = deepest_ball(p, 0.0);
        return squared(p - Vec3{ball}) - ball.w * ball.w;
    };
    Facets facets(*this, tolerance - float_rounding(bounds_), cell);
    MeshRefinement refinement(facets, facets.start_with(marched_mesh(power, bounds_, cell)));
    // A vertex takes a search for the deepest ball at several places.
    constexpr size_t most_faces = 40'000;
    if (!refinement.run(most_faces)) return std::nullopt;
    TriangleMesh mesh = refinement.take_mesh();
    mesh.error = tolerance;
    return mesh;
}

}  // namespace rb
