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

void expect_close(const ObjectPtr& object) {
    const World exact = world_of(object, GeometryMode::exact);
    const World facets = world_of(object, GeometryMode::tessellate);
    std::mt19937 random(2);
    std::uniform_real_distribution<double> unit(-1, 1);
    int hits = 0;
    int missed = 0;
    double off = 0;
    double turned = 0;
    for (int i = 0; i < 200 * RB_TEST_SAMPLES; ++i) {
        RayQuery query;
        query.ray.origin = {0, 0, -5};
        query.ray.direction = glm::normalize(Vec3{0.25 * unit(random), 0.25 * unit(random), 1});
        Hit a, b;
        const bool hit = exact.geometry->closest(query, a);
        if (facets.geometry->closest(query, b) != hit) {
            ++missed;
            continue;
        }
        // Grazing hits move far along the ray.
        if (!hit || std::abs(glm::dot(a.normal, query.ray.direction)) < 0.3) continue;
        ++hits;
        off += std::abs(a.t - b.t);
        turned += 1 - glm::dot(a.normal, b.normal);
    }
    EXPECT_GT(hits, 10 * RB_TEST_SAMPLES);
    EXPECT_LT(off / hits, 0.1 * 5.0 / 240);
    EXPECT_LT(turned / hits, 2e-3);
    EXPECT_LT(missed, 200 * RB_TEST_SAMPLES / 500);
}

TEST(Tessellated, EveryFiniteShapeLooksTheSame) {
    for (const ShapeKind* kind : all_shapes()) {
        const ObjectPtr object = object_from(kind->example);
        const auto shape = std::get<ShapePtr>(object->geometry);
        if (!shape->bounds().is_finite() || shape->is_faceted()) continue;
        SCOPED_TRACE(kind->keyword);
        auto turned = std::make_shared<Object>(*object);
        transform_object(*turned, Transform::rotation_deg({-70, 20, 0}));
        expect_close(turned);
    }
}

/// What rays meet is the true surface, bit for bit but for rounding, where the mesh is met at all.
TEST(Tessellated, RefinedHitsAreTheTrueOnes) {
    for (const ShapeKind* kind : all_shapes()) {
        const ObjectPtr object = object_from(kind->example);
        const auto shape = std::get<ShapePtr>(object->geometry);
        if (!shape->bounds().is_finite() || shape->is_faceted() || shape->is_always_exact()) continue;
        SCOPED_TRACE(kind->keyword);
        auto turned = std::make_shared<Object>(*object);
        transform_object(*turned, Transform::rotation_deg({-70, 20, 0}));
        const World exact = world_of(turned, GeometryMode::exact);
        const World refined = world_of(turned, GeometryMode::refine);
        std::mt19937 random(3);
        std::uniform_real_distribution<double> unit(-1, 1);
        int hits = 0;
        int off = 0;
        for (int i = 0; i < 200 * RB_TEST_SAMPLES; ++i) {
            RayQuery query;
            query.ray.origin = {0, 0, -5};
            query.ray.direction = glm::normalize(Vec3{0.25 * unit(random), 0.25 * unit(random), 1});
            Hit a, b;
            const bool hit = exact.geometry->closest(query, a);
            hits += hit;
            const bool same =
                refined.geometry->closest(query, b) == hit &&
                (!hit || (std::abs(a.t - b.t) < 1e-9 && glm::length(a.normal - b.normal) < 1e-6));
            off += !same;
        }
        EXPECT_GT(hits, 10 * RB_TEST_SAMPLES);
        EXPECT_LT(off, 200 * RB_TEST_SAMPLES / 500);
    }
}

TEST(Tessellated, InsideCompounds) {
    expect_close(object_from(
        "difference{box{-.7,.7} sphere{<0,0,-.5>,.6} cylinder{<0,-2,0>,<0,2,0>,.3} rotate <20,30,0>}"));
}

}  // namespace
}  // namespace rb
