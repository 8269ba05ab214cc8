// `--geometry tessellate` against the exact shapes.
#include "compile/geometry.h"
#include "shapes/registry.h"
#include "tests/geometry/statement.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace rb {
namespace {

World world_of(const ObjectPtr& object, GeometryMode mode) {
    Scene scene;
    scene.objects = {object};
    scene.default_texture = plain_texture();
    scene.camera.location = {0, 0, -5};
    Diagnostics diagnostics;
    CompileOptions options;
    options.geometry = mode;
    options.image_width = 320;
    options.image_height = 240;
    return compile(scene, options, diagnostics);
}

constexpr int ray_count = 200 * RB_TEST_SAMPLES;

/// Sends rays from the camera at both worlds: body(query, exact hit or null, other hit or null).
template <class Body>
void for_rays(const World& exact, const World& other, Body&& body) {
    std::mt19937 random(2);
    std::uniform_real_distribution<double> unit(-1, 1);
    for (int i = 0; i < ray_count; ++i) {
        RayQuery query;
        query.ray.origin = {0, 0, -5};
        query.ray.direction = glm::normalize(Vec3{0.25 * unit(random), 0.25 * unit(random), 1});
        Hit a, b;
        const bool hits = exact.geometry->closest(query, a);
        body(query, hits ? &a : nullptr, other.geometry->closest(query, b) ? &b : nullptr);
    }
}

/// Every finite shape that is not made of facets anyway, turned.
template <class Body>
void for_curved_shapes(Body&& body) {
    for (const ShapeKind* kind : all_shapes()) {
        const ObjectPtr object = object_from(kind->example);
        const auto shape = std::get<ShapePtr>(object->geometry);
        if (!shape->bounds().is_finite() || shape->is_faceted()) continue;
        SCOPED_TRACE(kind->keyword);
        auto turned = std::make_shared<Object>(*object);
        transform_object(*turned, Transform::rotation_deg({-70, 20, 0}));
        body(turned);
    }
}

void expect_close(const ObjectPtr& object) {
    int hits = 0;
    int missed = 0;
    double off = 0;
    double turned = 0;
    for_rays(world_of(object, GeometryMode::exact), world_of(object, GeometryMode::tessellate),
             [&](const RayQuery& query, const Hit* a, const Hit* b) {
                 missed += (a == nullptr) != (b == nullptr);
                 // Grazing hits move far along the ray.
                 if (!a || !b || std::abs(glm::dot(a->normal, query.ray.direction)) < 0.3) return;
                 ++hits;
                 off += std::abs(a->t - b->t);
                 turned += 1 - glm::dot(a->normal, b->normal);
             });
    EXPECT_GT(hits, ray_count / 20);
    EXPECT_LT(off / hits, 0.1 * 5.0 / 240);
    EXPECT_LT(turned / hits, 2e-3);
    EXPECT_LT(missed, ray_count / 500);
}

TEST(Tessellated, EveryFiniteShapeLooksTheSame) { for_curved_shapes(expect_close); }

/// What rays meet is the true surface, bit for bit but for rounding, where the mesh is met at all.
TEST(Tessellated, RefinedHitsAreTheTrueOnes) {
    for_curved_shapes([](const ObjectPtr& object) {
        int hits = 0;
        int off = 0;
        for_rays(world_of(object, GeometryMode::exact), world_of(object, GeometryMode::refine),
                 [&](const RayQuery&, const Hit* a, const Hit* b) {
                     hits += a != nullptr;
                     const bool same =
                         a && b ? std::abs(a->t - b->t) < 1e-9 && glm::length(a->normal - b->normal) < 1e-6
                                : a == b;
                     off += !same;
                 });
        EXPECT_GT(hits, ray_count / 20);
        EXPECT_LT(off, ray_count / 500);
    });
}

TEST(Tessellated, InsideCompounds) {
    expect_close(object_from(
        "difference{box{-.7,.7} sphere{<0,0,-.5>,.6} cylinder{<0,-2,0>,<0,2,0>,.3} rotate <20,30,0>}"));
}

}  // namespace
}  // namespace rb
