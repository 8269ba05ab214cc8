#pragma once
#include "math/vec.h"

#include <array>
#include <complex>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec4.hpp>

namespace rb {

using Quaternion = glm::dvec4;

enum class JuliaAlgebra { quaternion, hypercomplex };
enum class JuliaFunction {
    sqr,
    cube,
    exp,
    ln,
    reciprocal,
    sin,
    asin,
    sinh,
    asinh,
    cos,
    acos,
    cosh,
    acosh,
    tan,
    atan,
    tanh,
    atanh,
    pwr
};

/// q -> f(q) + c, repeated (spec: geometry 16.3). What escapes in none of the first `steps` tests belongs to
/// the solid; it escapes where |q|^2 > escape before the function is applied.
struct JuliaRule {
    Quaternion c{0.0};
    JuliaAlgebra algebra = JuliaAlgebra::quaternion;
    JuliaFunction function = JuliaFunction::sqr;
    std::complex<double> exponent{0.0};  ///< of pwr
    size_t steps = 20;

    /// True if JuliaFormula::reach knows bounds: squares and cubes.
    bool has_reach() const { return function == JuliaFunction::sqr || function == JuliaFunction::cube; }
};

/// What a rule makes of points.
class JuliaFormula : public JuliaRule {
public:
    explicit JuliaFormula(const JuliaRule& rule);

    /// Radius of the ball around the origin that holds the solid.
    double radius() const { return radius_; }
    /// Limit of the squared length; above the squared radius.
    double escape() const { return escape_; }
    /// f(q) + c. Hypercomplex `cube` is a square, as in the reference.
    Quaternion next(const Quaternion& q) const;
    /// The number of the first test in which q escapes; `steps` if in none.
    size_t escape_step(Quaternion q) const;
    bool stays(const Quaternion& q) const { return escape_step(q) == steps; }
    /// The same of several places at once, for squares and cubes.
    static constexpr int places_at_once = 8;
    struct Orbits {
        uint32_t staying = 0;                        ///< bit k tells of place number k
        std::array<double, places_at_once> largest;  ///< squared length, as far as the orbit was followed
    };
    Orbits orbits_of(std::span<const Quaternion, places_at_once> places) const;
    /// What test number `step` compares with 0: above, q has escaped.
    double excess(Quaternion q, size_t step) const;

    struct Reach {
        bool stays = false;
        double distance = 0;  ///< all points within are proven to do the same
    };
    /// What happens at q, and in how large a 4D neighbourhood; 0 where that is below `least`. Lengths grow by
    /// |f(q + d) - f(q)| <= 2 |q| |d| + |d|^2 (cube: 3 |q|^2 |d| + 3 |q| |d|^2 + |d|^3) a step; in the
    /// hypercomplex algebra both complex parts do so for themselves.
    Reach reach(const Quaternion& q, double least) const;

    /// The surface normal that the language defines, at a point of the solid's surface: along the first three
    /// axes.
    Vec3 normal(const Quaternion& q) const;

private:
    Quaternion function_value(const Quaternion& q) const;
    Vec3 quaternion_normal(const Quaternion& q) const;
    Vec3 hypercomplex_normal(const Quaternion& q) const;

    double radius_;
    double escape_;
};

}  // namespace rb
