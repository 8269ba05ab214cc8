// polynomial { N, xyz(i, j, k): F, ... }   (manual 3.5.3.3): the terms of a poly that are not zero
#include "shapes/poly_shape.h"
#include "shapes/registry.h"

#include <cmath>

namespace rb {

namespace {

ShapePtr read(BlockReader& in) {
    const SourceRange at = in.where();
    const int order = in.integer();
    if (order < 2 || order > 35) in.fail_at(at, "Order of poly is out of range.");
    std::vector<double> coefficients(poly_size(order), 0.0);
    while (in.take_word("xyz")) {
        const SourceRange term_at = in.where();
        const Vec3 powers = in.vec3();
        const auto i = static_cast<int>(powers.x);
        const auto j = static_cast<int>(powers.y);
        const auto k = static_cast<int>(powers.z);
        const bool fits =
            powers.x >= 0.0 && powers.y >= 0.0 && powers.z >= 0.0 && powers.x + powers.y + powers.z <= order;
        if (!fits) in.fail_at(term_at, "Coefficient of polynom is out of range.");
        coefficients[poly_index(order, i, j, k)] = in.number();
    }
    return std::make_shared<PolyShape>("polynomial", order, std::move(coefficients));
}

}  // namespace

namespace shapes {
extern const ShapeKind polynomial;
const ShapeKind polynomial{"polynomial", read,
                           "polynomial { 4, xyz(4,0,0):1, xyz(0,2,0):1.5, xyz(0,0,2):1, xyz(0,0,0):-0.3 }"};
}  // namespace shapes

}  // namespace rb
