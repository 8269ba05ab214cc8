// cylinder { <base>, <cap>, radius [open] }   (manual 3.5.1.5)
#include "shapes/frustum.h"
#include "shapes/registry.h"

namespace rb {

namespace {

ShapePtr read(BlockReader& in) {
    const SourceRange at = in.where();
    const Vec3 base = in.vec3();
    const Vec3 cap = in.vec3();
    const double radius = std::abs(in.number());
    if (base == cap) in.fail_at(at, "Degenerate cylinder.");
    const bool open = in.take_word("open");
    if (!(radius > 0.0)) in.fail_at(at, "Degenerate cylinder: its radius is 0.");
    return std::make_shared<Frustum>("cylinder", axial_frame(base, cap - base, radius), Frustum::Profile{},
                                     open);
}

}  // namespace

namespace shapes {
extern const ShapeKind cylinder;
const ShapeKind cylinder{"cylinder", read, "cylinder { <-0.5, -0.3, 0.1>, <0.6, 0.4, -0.2>, 0.45 }"};
}  // namespace shapes

}  // namespace rb
