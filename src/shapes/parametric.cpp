// parametric { function { X(u,v) }, function { Y(u,v) }, function { Z(u,v) } <u0,v0>, <u1,v1>
//   [contained_by { ... }] [max_gradient F] [accuracy F] [precompute DEPTH, [x], [y], [z]] } (manual 3.5.2.7)
#include "shapes/parametric_shape.h"
#include "shapes/registry.h"

#include <fmt/format.h>

namespace rb {

namespace {

FunctionPtr take_function(BlockReader& in) {
    const SourceRange at = in.where();
    if (!in.at_thing<FunctionPtr>())
        in.fail(fmt::format("Expected 'function', {} found instead", in.found()));
    auto function = in.thing<FunctionPtr>();
    if (function->parameter_count() > 3 || function->result_count() != 1)
        in.fail_at(at, "A parametric surface needs float functions of two parameters.");
    return function;
}

double positive_or(BlockReader& in, double otherwise, std::string_view what) {
    const SourceRange at = in.where();
    const double number = in.number();
    if (number > 0.0) return number;
    in.diagnostics().warning(at,
                             fmt::format("Parametric '{}' must be positive: {} is taken.", what, otherwise));
    return otherwise;
}

void take_precompute(BlockReader& in) {
    // It only makes the reference faster.
    const SourceRange at = in.where();
    const int depth = in.integer();
    constexpr int deepest = 20;
    if (depth < 1 || depth > deepest) in.fail_at(at, "Precompute: invalid depth.");
    // x, y and z are vectors here as elsewhere.
    while (in.at_number()) in.vec3();
}

ShapePtr read(BlockReader& in) {
    ParametricData data;
    for (FunctionPtr& function : data.functions) function = take_function(in);
    const Vec2 a = in.vec2();
    const Vec2 b = in.vec2();
    data.lo = glm::min(a, b);
    data.hi = glm::max(a, b);
    for (;;) {
        if (in.at_block("contained_by")) {
            data.container = take_container(in);
        } else if (in.take_word("accuracy")) {
            data.accuracy = positive_or(in, data.accuracy, "accuracy");
        } else if (in.take_word("max_gradient")) {
            data.max_gradient = positive_or(in, data.max_gradient, "max_gradient");
        } else if (in.take_word("precompute")) {
            take_precompute(in);
        } else {
            break;
        }
    }
    return std::make_shared<Parametric>(std::move(data));
}

}  // namespace

namespace shapes {
extern const ShapeKind parametric;
const ShapeKind parametric{"parametric", read,
                           "parametric { function { u }, function { 0.3*(u*u + v*v) - 0.3 }, function { v } "
                           "<-0.8, -0.8>, <0.8, 0.8> contained_by { sphere { 0, 1.2 } } accuracy 0.0001 }"};
}  // namespace shapes

}  // namespace rb
