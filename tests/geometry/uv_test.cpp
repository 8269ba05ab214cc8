// Surface coordinates measured with the reference program.
#include "compile/geometry.h"
#include "tests/geometry/statement.h"

#include <gtest/gtest.h>

namespace rb {
namespace {

Vec2 uv_at(std::string_view text, const Vec3& origin, const Vec3& direction) {
    Scene scene;
    scene.objects = {object_from(text)};
    scene.default_texture = plain_texture();
    Diagnostics diagnostics;
    const World world = compile(scene, {}, diagnostics);
    RayQuery query;
    query.ray = {origin, direction};
    Hit hit;
    EXPECT_TRUE(world.geometry->closest(query, hit)) << text;
    return hit.leaf == no_leaf ? Vec2{-1} : world.geometry->uv(hit);
}

struct Case {
    const char* text;
    Vec3 origin;
    Vec3 direction;
    Vec2 uv;
};

TEST(Uv, MeasuredValues) {
    const Case cases[] = {
        {"sphere{0,1}", {.3, .4, -5}, {0, 0, 1}, {.803, .631}},
        {"sphere{0,1 rotate <0,90,0>}", {.3, .4, -5}, {0, 0, 1}, {.053, .631}},
        {"sphere{0,1 scale <1,2,1>}", {.3, .8, -5}, {0, 0, 1}, {.803, .631}},
        {"box{0,1}", {-5, .25, .2}, {1, 0, 0}, {.050, .417}},
        {"box{0,1}", {5, .25, .2}, {-1, 0, 0}, {.700, .417}},
        {"box{0,1}", {.2, .25, -5}, {0, 0, 1}, {.950, .417}},
        {"box{0,1}", {.2, .25, 5}, {0, 0, -1}, {.300, .417}},
        {"box{0,1}", {.2, -5, .3}, {0, 1, 0}, {.300, .100}},
        {"box{0,1}", {.2, 5, .3}, {0, -1, 0}, {.300, .900}},
        {"torus{2,.5}", {2, 5, .1}, {0, -1, 0}, {.492, .749}},
        {"torus{2,.5}", {.3, .2, -5}, {0, 0, 1}, {.731, .566}},
        {"mesh2{vertex_vectors{4,<0,0,0>,<1,0,0>,<1,1,0>,<0,1,0>} uv_vectors{4,<0,0>,<2,0>,<2,3>,<0,3>} "
         "face_indices{2,<0,1,2>,<0,2,3>}}",
         {.6, .2, -5},
         {0, 0, 1},
         {1.2, .6}},
        {"bicubic_patch{type 1 u_steps 3 v_steps 3 uv_vectors <0,0>,<2,0>,<2,3>,<0,3> "
         "<0,0,0>,<1,0,0>,<2,0,0>,<3,0,0>,<0,1,0>,<1,1,0>,<2,1,0>,<3,1,0>,"
         "<0,2,0>,<1,2,0>,<2,2,0>,<3,2,0>,<0,3,0>,<1,3,0>,<2,3,0>,<3,3,0>}",
         {.9, 2.1, -5},
         {0, 0, 1},
         {.6, 2.1}},
        {"lathe{linear_spline 3,<1,0>,<.5,1>,<0,1.5>}", {.2, .5, -5}, {0, 0, 1}, {.793, .250}},
        {"sor{5,<.5,-1>,<1,0>,<.5,1>,<.8,2>,<.5,3>}", {.2, .5, -5}, {0, 0, 1}, {.790, .250}},
        {"sor{5,<.5,-1>,<1,0>,<.5,1>,<.8,2>,<.5,3>}", {.2, 5, .1}, {0, -1, 0}, {.074, 1.720}},
        {"sor{5,<.5,-1>,<1,0>,<.5,1>,<.8,2>,<.5,3>}", {.2, -5, .1}, {0, 1, 0}, {.074, -.776}},
        {"cylinder{<0,0,0>,<0,2,0>,1 translate <.5,0,0>}", {.3, .5, -5}, {0, 0, 1}, {.3, .5}},
        {"plane{z,0 rotate <90,0,0>}", {.3, 5, .2}, {0, -1, 0}, {.3, 0}},
        {"ovus{1,.6}", {.3, .4, -5}, {0, 0, 1}, {.800, .533}},
    };
    for (const Case& c : cases) {
        const Vec2 uv = uv_at(c.text, c.origin, c.direction);
        EXPECT_NEAR(uv.x, c.uv.x, 6e-4) << c.text;
        EXPECT_NEAR(uv.y, c.uv.y, 6e-4) << c.text;
    }
}

}  // namespace
}  // namespace rb
