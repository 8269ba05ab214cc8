// sphere_sweep { linear_spline|b_spline|cubic_spline N, <C0>, r0, ... [tolerance F] }    (manual 3.5.1.13)
#include "shapes/registry.h"
#include "shapes/sphere_sweep_shape.h"

#include <fmt/format.h>

namespace rb {

namespace {

enum class SweepSpline { linear, cubic, basis };

SweepSpline take_spline(BlockReader& in) {
    if (in.take_word("linear_spline")) return SweepSpline::linear;
    if (in.take_word("cubic_spline")) return SweepSpline::cubic;
    if (in.take_word("b_spline")) return SweepSpline::basis;
    in.fail(fmt::format("Expected 'linear_spline, cubic_spline or b_spline', {} found instead", in.found()));
}

/// The piece between the middle two of four balls (spec: geometry 13.1, 13.5).
SweepPiece piece_of(SweepSpline spline, const Ball* b) {
    if (spline == SweepSpline::cubic)
        return SweepPiece::bezier({b[1], b[1] + (b[2] - b[0]) / 6.0, b[2] - (b[3] - b[1]) / 6.0, b[2]});
    return SweepPiece::bezier({(b[0] + 4.0 * b[1] + b[2]) / 6.0, (2.0 * b[1] + b[2]) / 3.0,
                               (b[1] + 2.0 * b[2]) / 3.0, (b[1] + 4.0 * b[2] + b[3]) / 6.0});
}

ShapePtr read(BlockReader& in) {
    const SweepSpline spline = take_spline(in);
    const bool straight = spline == SweepSpline::linear;
    const SourceRange at = in.where();
    const int count = in.integer();
    const int least = straight ? 2 : 4;
    if (count < least) in.fail_at(at, fmt::format("The sphere sweep needs at least {} spheres.", least));
    std::vector<Ball> balls;
    Bounds extent;
    for (int i = 0; i < count; ++i) {
        const Vec3 center = in.vec3();
        const double radius = in.number();
        balls.emplace_back(center, radius);
        const double reach = spline == SweepSpline::cubic ? 2.0 * radius : radius;
        extent.include(center - reach);
        extent.include(center + reach);
    }
    // The least distance at which the reference takes a crossing; here none is missed.
    if (in.take_word("tolerance")) in.number();
    std::vector<SweepPiece> pieces;
    for (size_t i = 0; i + static_cast<size_t>(straight ? 1 : 3) < balls.size(); ++i) {
        pieces.push_back(straight ? SweepPiece::straight(balls[i], balls[i + 1])
                                  : piece_of(spline, &balls[i]));
    }
    return std::make_shared<SphereSweep>(std::move(pieces), extent);
}

}  // namespace

namespace shapes {
extern const ShapeKind sphere_sweep;
const ShapeKind sphere_sweep{"sphere_sweep", read,
                             "sphere_sweep { cubic_spline 6, <-0.9, -0.5, 0>, 0.1, <-0.6, 0.1, 0.1>, 0.25, "
                             "<0, 0.3, -0.3>, 0.15, <0.5, -0.3, 0.2>, 0.3, <0, -0.5, 0.3>, 0.1, "
                             "<-0.4, -0.2, 0.5>, 0.1 }"};
}  // namespace shapes

}  // namespace rb
