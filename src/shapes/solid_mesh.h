#pragma once
#include "math/interval.h"
#include "scene/shape.h"

namespace rb {

/// The gradients of a function within some region: none differs from `middle` by more than `spread`.
struct GradientBound {
    Vec3 middle{0.0};
    double spread = 0;

    /// Empty if an interval has no end.
    static std::optional<GradientBound> of(const std::array<Interval, 3>& along_axes);
};

/// A solid that is known by which points belong to it.
class PointSolid {
public:
    virtual bool inside(const Vec3& p) const = 0;

    /// Of a function whose zeros are all of the surface within `region`; empty where there is no such
    /// function, or nothing is known of it.
    virtual std::optional<GradientBound> slopes(const Bounds& region) const = 0;

protected:
    ~PointSolid() = default;
};

/// A closed mesh of the surface within `box`, refined until every facet is proven to lie within `tolerance`
/// of it; empty if no affordable one is. What falls between the points of a first grid, a 32nd of the box
/// apart, may be missing.
std::optional<TriangleMesh> solid_mesh(const PointSolid& solid, const Bounds& box, double tolerance);

}  // namespace rb
