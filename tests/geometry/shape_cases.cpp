#include "shape_cases.h"

#include "statement.h"

#include <algorithm>
#include <array>

namespace rb {

namespace {

/// Beside the registry's examples, without modifiers; about as large as the unit cube around the origin.
constexpr std::array<std::string_view, 27> further{
    "cone { <0,-0.5,0>, 0.5, <0,0.5,0>, 0 }",
    "cone { <-0.3,-0.5,0>, 0.1, <0.2,0.5,0.1>, 0.4 }",
    "cylinder { <-0.4,-0.3,0.2>, <0.5,0.4,-0.1>, 0.05 }",
    "torus { 0.4, 0.02 }",
    "torus { 0.3, 0.3 }",
    "prism { linear_spline -0.4, 0.4, 5, <-0.5,-0.5>, <0.5,-0.5>, <0.5,0.5>, <0,0>, <-0.5,-0.5> }",
    "prism { conic_sweep linear_spline 0.2, 0.6, 5, <-0.8,-0.8>, <0.8,-0.8>, <0.8,0.8>, <-0.8,0.8>, "
    "<-0.8,-0.8> }",
    "prism { bezier_spline -0.3, 0.3, 8, <-0.5,0>, <-0.5,0.6>, <0.5,0.6>, <0.5,0>, <0.5,0>, <0.5,-0.6>, "
    "<-0.5,-0.6>, <-0.5,0> }",
    "lathe { linear_spline 6, <0,-0.5>, <0.5,-0.4>, <0.2,0>, <0.5,0>, <0.3,0.5>, <0,0.5> }",
    "lathe { bezier_spline 8, <0,-0.5>, <0.6,-0.5>, <0.6,0>, <0.3,0>, <0.3,0>, <0,0>, <0.4,0.5>, <0,0.5> }",
    "lathe { quadratic_spline 6, <-0.1,-0.5>, <0,-0.5>, <0.5,-0.2>, <0.3,0.2>, <0.4,0.4>, <0,0.5> }",
    "sor { 5, <0,-0.8>, <0,-0.5>, <0.5,0>, <0,0.5>, <0,0.8> }",
    "superellipsoid { <0.1, 0.1> }",
    "superellipsoid { <1.7, 0.5> }",
    "superellipsoid { <0.6, 2.7> }",
    "superellipsoid { <3, 0.8> }",
    "superellipsoid { <2.5, 3> }",
    "sphere_sweep { linear_spline 3, <-0.5, -0.3, 0>, 0.2, <0.5, -0.3, 0.1>, 0.15, <0, 0.5, 0>, 0 }",
    "sphere_sweep { b_spline 5, <-0.8, -0.6, 0>, 0.1, <-0.4, 0.5, 0>, 0.2, <0.2, -0.5, 0.3>, 0.1, "
    "<0.5, 0.5, 0>, 0.3, <0.6, 0.8, 0>, 0.1 }",
    "blob { threshold 0.6 cylinder { <-0.4,0,0>, <0.4,0.1,0>, 0.4, 1 } sphere { <0,0.3,0>, 0.4, 1 } "
    "sphere { <0.1,-0.1,-0.3>, 0.3, -1 } }",
    "ovus { 0.3, 0.2 }",
    "quadric { <4, 4, 4>, <0, 0, 0>, <0, 0, 0>, -1 }",
    "quartic { <1, 0, 0, 0, 2, 0, 0, 2, 0, -0.34, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 2, 0, 0.3, 0, 0, 0, "
    "0, 1, "
    "0, -0.34, 0, 0.0225> }",
    "parametric { function { 0.5*sin(u)*cos(v) }, function { 0.5*sin(u)*sin(v) }, function { 0.4*cos(u) } "
    "<0, 0>, <pi, 2*pi> contained_by { box { -0.8, 0.8 } } }",
    "text { internal 2 \"8g\" 0.3, 0 }",
    "isosurface { function { x*x*x*x + y*y*y*y + z*z*z*z - 0.06 } contained_by { box { -0.5, 0.5 } } "
    "max_gradient 4 all_intersections }",
    "blob { threshold 0.4 sphere { <0.5,-0.5,0>, 0.3, 1 } sphere { <0.4,-0.4,0.3>, 0.3, 1 } "
    "sphere { <0.1,-0.3,0.5>, 0.3, 1 } sphere { <-0.2,-0.2,0.4>, 0.3, 1 } "
    "cylinder { <-0.4,-0.1,0.2>, <-0.4,0.1,-0.2>, 0.25, 1 } sphere { <-0.2,0.2,-0.4>, 0.3, 1 } "
    "sphere { <0.1,0.3,-0.5>, 0.3, 1 } sphere { <0.4,0.4,-0.3>, 0.3, 1 } sphere { <0.5,0.5,0>, 0.3, 1 } "
    "sphere { <0,0,0>, 0.2, 1 } sphere { <0.1,0,0>, 0.2, -0.5 } sphere { <0,0.1,0.1>, 0.2, 1 } "
    "cylinder { <0,-0.5,0>, <0,0.5,0>, 0.15, 0.7 } sphere { <-0.5,-0.5,-0.5>, 0.2, 2 } }",
};

}  // namespace

ShapePtr shape_from(std::string_view statement) {
    return std::get<ShapePtr>(object_from(statement)->geometry);
}

const std::vector<ShapeCase>& shape_cases() {
    static const std::vector<ShapeCase> cases = [] {
        std::vector<ShapeCase> all;
        for (const ShapeKind* kind : all_shapes())
            all.push_back({std::string(kind->keyword), kind->example, kind});
        for (const std::string_view statement : further) {
            const ShapeKind* kind = find_shape(statement.substr(0, statement.find(' ')));
            const auto alike = std::ranges::count(all, kind, &ShapeCase::kind);
            all.push_back({std::string(kind->keyword) + "_" + std::to_string(alike + 1), statement, kind});
        }
        return all;
    }();
    return cases;
}

bool bounds_a_body(const Shape& shape) {
    return !shape.is_patch() && shape.solid_bounds().is_finite() == shape.bounds().is_finite();
}

bool has_outward_normals(const Shape& shape) { return shape.normal_rule() != NormalRule::by_point_order; }

ObjectPtr placed(std::string_view statement, const Transform& map) {
    auto object = std::make_shared<Object>(*object_from(statement));
    transform_object(*object, map);
    return object;
}

World world_of(const std::vector<ObjectPtr>& objects, const CompileOptions& options) {
    Scene scene;
    scene.objects = objects;
    scene.default_texture = plain_texture();
    Diagnostics diagnostics;
    return compile(scene, options, diagnostics);
}

}  // namespace rb
