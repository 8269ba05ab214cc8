// cubic { <20 coefficients> }   (manual 3.5.3.3)
#include "shapes/poly_shape.h"
#include "shapes/registry.h"

namespace rb {

namespace {

ShapePtr read(BlockReader& in) { return read_poly(in, "cubic", 3); }

}  // namespace

namespace shapes {
extern const ShapeKind cubic;
const ShapeKind cubic{"cubic", read, "cubic { <0.3,0,0,1, 0,0.5,0,0,0,0, 0,0,1,0,0,0, 0,1,0,-0.3> }"};
}  // namespace shapes

}  // namespace rb
