#pragma once
#include "math/bounds.h"

#include <array>
#include <cstdint>
#include <vector>

#include <glm/vec4.hpp>

namespace rb {

/// A ball: centre and, as w, radius.
using Ball = glm::dvec4;

/// One piece of a sweep: centre and radius are the same polynomials of a parameter w in [0, 1].
struct SweepPiece {
    std::array<Ball, 4> power{};    ///< lowest power first
    std::array<Ball, 4> control{};  ///< of the same curve in Bezier form
    bool is_straight = false;       ///< no powers above 1

    /// From the control points of a Bezier curve.
    static SweepPiece bezier(const std::array<Ball, 4>& control);
    static SweepPiece straight(const Ball& a, const Ball& b);

    Ball at(double w) const { return power[0] + w * (power[1] + w * (power[2] + w * power[3])); }
    Bounds box() const;
};

/// A part of a piece.
struct SweepRange {
    uint32_t piece = 0;
    double lo = 0;
    double hi = 1;
};

/// A ball around all balls of a range.
struct SweepBound {
    Vec3 center{0.0};
    double radius = 0;

    static SweepBound around(const SweepPiece& piece, double lo, double hi);
    void include(const SweepBound& other);
};

/// Lengths along a ray, from its origin, with the directions across it.
struct RayFrame {
    RayFrame(const Vec3& from, const Vec3& direction);
    Vec3 origin;
    double length;  ///< of the ray's direction
    Vec3 along, u, v;
};

/// Where balls meet a ray, without gaps: distances with the piece and place of the balls that make the ends.
struct Way {
    double in = 0, out = 0;
    uint32_t in_piece = 0, out_piece = 0;
    double in_w = 0, out_w = 0;
};

/// What a ray asks of the balls of a range.
struct SweepQuestion {
    const RayFrame& frame;
    bool from_surface = false;  ///< no ball is around the ray's origin, and those behind do not count
    double level = 0;           ///< added to the squared radii
};

/// Adds the ways through all runs of balls of a range that the ray meets.
void add_ways(const SweepPiece& piece, const SweepRange& range, const SweepQuestion& question,
              std::vector<Way>& ways);

/// Adds the ways through one ball of each of these runs: quick, to tell if the ray meets any.
void add_balls(const SweepPiece& piece, const SweepRange& range, const SweepQuestion& question,
               std::vector<Way>& ways);

/// The ball of a range that lies deepest around a point.
struct DeepestBall {
    double level = 0;  ///< the point's squared distance from the centre less the squared radius
    double w = 0;
};
DeepestBall deepest(const SweepPiece& piece, const SweepRange& range, const Vec3& p);

}  // namespace rb
