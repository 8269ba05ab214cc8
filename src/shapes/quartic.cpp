// quartic { <35 coefficients> }   (manual 3.5.3.3)
#include "shapes/poly_shape.h"
#include "shapes/registry.h"

namespace rb {

namespace {

ShapePtr read(BlockReader& in) { return read_poly(in, "quartic", 4); }

}  // namespace

namespace shapes {
extern const ShapeKind quartic;
const ShapeKind quartic{
    "quartic", read,
    "quartic { <1,0,0,0,0, 0,0,0.5,0,0, 0,0,0,0.4,0, 0,0,0,0,0, 1,0,0,0,0, 0,0.2,0,0,0, 1,0,0,0,-0.2> }"};
}  // namespace shapes

}  // namespace rb
