#pragma once
#include "scene/shape.h"

#include <functional>

namespace rb {

/// The closed mesh of the zeros within `box` of a function that is positive outside, by marching tetrahedra
/// on a grid of cubes with sides of `cell`. Nothing is known of its error.
TriangleMesh marched_mesh(const std::function<double(const Vec3&)>& value, const Bounds& box, double cell);

/// A function whose zeros are a surface; it grows outward.
class ImplicitFunction {
public:
    virtual double value(const Vec3& p) const = 0;
    virtual Vec3 gradient(const Vec3& p) const = 0;
    /// How fast the gradient may change anywhere in the box (a Lipschitz constant).
    virtual double bend(const Bounds& box) const = 0;

protected:
    ~ImplicitFunction() = default;
};

/// The closed mesh of the zeros within `box`, by marching tetrahedra on a grid that is refined until every
/// facet is proven to lie within `tolerance` of the surface; empty if no affordable grid does.
std::optional<TriangleMesh> implicit_mesh(const ImplicitFunction& f, const Bounds& box, double tolerance);

}  // namespace rb
