// poly { N, <coefficients> }   (manual 3.5.3.3)
#include "shapes/poly_shape.h"
#include "shapes/registry.h"

namespace rb {

namespace {

ShapePtr read(BlockReader& in) {
    const SourceRange at = in.where();
    const int order = in.integer();
    if (order < 2 || order > 35) in.fail_at(at, "Order of poly is out of range.");
    return read_poly(in, "poly", order);
}

}  // namespace

namespace shapes {
extern const ShapeKind poly;
const ShapeKind poly{"poly", read, "poly { 2, <1,0.1,0.2,0.1,1.5,0,0,2,0,-0.3> }"};
}  // namespace shapes

}  // namespace rb
