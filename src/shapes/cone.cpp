// cone { <base>, base_radius, <cap>, cap_radius [open] }   (manual 3.5.1.4)
#include "shapes/frustum.h"
#include "shapes/registry.h"

#include <algorithm>

namespace rb {

namespace {

ShapePtr read(BlockReader& in) {
    const SourceRange at = in.where();
    Vec3 base = in.vec3();
    double base_radius = in.number();
    Vec3 cap = in.vec3();
    double cap_radius = in.number();
    const bool open = in.take_word("open");
    if (base == cap) in.fail_at(at, "Degenerate cone/cylinder.");
    if (base_radius < cap_radius) {
        std::swap(base, cap);
        std::swap(base_radius, cap_radius);
    }
    const double largest = std::max(std::abs(base_radius), std::abs(cap_radius));
    if (!(largest > 0.0)) in.fail_at(at, "Degenerate cone/cylinder: its radii are 0.");
    // Local radius 1 at the larger end; the radius runs linearly from base (z = 0) to cap (z = 1).
    const Frustum::Profile profile{0.0, 1.0, base_radius / largest, (cap_radius - base_radius) / largest};
    return std::make_shared<Frustum>("cone", axial_frame(base, cap - base, largest), profile, open);
}

}  // namespace

namespace shapes {
extern const ShapeKind cone;
const ShapeKind cone{"cone", read, "cone { <-0.4, -0.5, 0>, 0.7, <0.3, 0.6, 0.2>, 0.2 }"};
}  // namespace shapes

}  // namespace rb
