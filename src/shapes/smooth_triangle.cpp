// smooth_triangle { <p1>, <n1>, <p2>, <n2>, <p3>, <n3> }   (manual 3.5.2.5)
#include "shapes/registry.h"
#include "shapes/triangle_shape.h"

namespace rb {

namespace {

ShapePtr read(BlockReader& in) { return read_triangle(in, true); }

}  // namespace

namespace shapes {
extern const ShapeKind smooth_triangle;
const ShapeKind smooth_triangle{
    "smooth_triangle", read,
    "smooth_triangle { <-0.5,-0.4,0>, <-0.5,-0.4,-1>, <0.6,-0.3,0>, <0.6,-0.3,-1>, "
    "<0.1,0.7,0>, <0.1,0.7,-1> }"};
}  // namespace shapes

}  // namespace rb
