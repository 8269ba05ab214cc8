// triangle { <p1>, <p2>, <p3> }   (manual 3.5.2.5)
#include "shapes/registry.h"
#include "shapes/triangle_shape.h"

namespace rb {

namespace {

ShapePtr read(BlockReader& in) { return read_triangle(in, false); }

}  // namespace

namespace shapes {
extern const ShapeKind triangle;
const ShapeKind triangle{"triangle", read, "triangle { <-0.5,-0.4,0.1>, <0.6,-0.3,-0.2>, <0.1,0.7,0.3> }"};
}  // namespace shapes

}  // namespace rb
