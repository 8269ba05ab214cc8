#pragma once
#include "scene/shape.h"

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
    double largest_radius() const;
    Bounds box() const;
};

/// The union of all balls along a curve. The part of a crossing is the piece, at.x the place w on it.
///
/// A ball meets a ray from a - sqrt(D) to a + sqrt(D), where a is the centre's place along the ray and D the
/// squared radius less the centre's squared distance from the ray. Within each range of w where D >= 0 these
/// ways overlap; their union runs from the least a - sqrt(D) to the largest a + sqrt(D), both at ends of the
/// range or where D'^2 = 4 a'^2 D. So a ray always leaves what it enters, and nothing inside is seen.
class SphereSweep final : public Shape {
public:
    /// `extent` is what min_extent and max_extent say.
    SphereSweep(std::vector<SweepPiece> pieces, const Bounds& extent);

    std::string_view keyword() const override { return "sphere_sweep"; }
    bool is_always_exact() const override { return true; }
    Bounds bounds() const override { return bounds_; }
    Bounds language_extent() const override { return extent_; }
    bool inside(const Vec3& p) const override;
    void crossings(const ShapeRay& ray, Crossings& out) const override;
    Vec3 normal(const Vec3& p, const Crossing& at) const override;
    ShapePtr transformed(const Transform& map) const override;
    std::optional<TriangleMesh> tessellate(double) const override { return std::nullopt; }
    std::string describe() const override;

private:
    struct Start;
    std::optional<Start> start_of(const ShapeRay& ray) const;

    std::vector<SweepPiece> pieces_;
    Bounds bounds_;
    Bounds extent_;
};

}  // namespace rb
