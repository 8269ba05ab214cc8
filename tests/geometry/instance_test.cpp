// Copies of a compound that is kept once, against the same scenes flattened copy by copy.
#include "compile/compound.h"
#include "compile/geometry_parts.h"
#include "tests/geometry/statement.h"

#include <algorithm>
#include <random>

#include <gtest/gtest.h>

namespace rb {
namespace {

World compiled(const Scene& scene, InstanceMode mode, bool brute_force = false) {
    Diagnostics diagnostics;
    CompileOptions options;
    options.instances = mode;
    options.brute_force = brute_force;
    return compile(scene, options, diagnostics);
}

size_t instances_in(const World& world) { return world.geometry->parts->flat.instances.size(); }

/// A difference, glass, a patch, a shape that does not take scalings into its numbers.
const std::string twig = R"(
#declare Red = texture { pigment { rgb x } }
#declare Twig = union {
  sphere { 0, 0.3 }
  cylinder { 0, y, 0.1 pigment { gradient y } }
  torus { 0.4, 0.05 texture { Red } }
  difference { box { -0.2, 0.2 } sphere { 0.2*y, 0.2 } translate <0.5, 0.2, 0> }
  sphere { <-0.6, 0.3, 0>, 0.2 pigment { rgbt <0.8, 1, 0.8, 0.8> } interior { ior 1.4 } }
  polygon { 4, <0, 1>, <0.3, 1.3>, <-0.3, 1.3>, <0, 1> translate 0.2*z }
  mesh { triangle { <0.1, 1, -0.2>, <0.4, 1.3, -0.1>, <-0.2, 1.3, -0.3> } }
}
)";
/// Nested, mirrored, unevenly scaled, sheared.
const std::string grove = twig + R"(
#declare Tree = union {
  object { Twig } object { Twig rotate z*70 translate <0.8, 0.4, 0> } object { Twig scale <-0.7, 1.2, 0.8> translate -x }
  sphere { <0, -0.6, 0>, 0.2 }
  pigment { bozo }
}
object { Tree translate -3*x }
object { Tree scale <-1, 1.5, 1> }
object { Tree rotate <20, 50, 0> scale 0.6 translate 3*x no_shadow }
object { Tree matrix <1, 0.3, 0, 0, 1, 0.2, 0.1, 0, 1, 0, -3, 0> pigment { rgbt <1, 1, 1, 0.5> } interior { ior 1.2 } }
object { Twig translate 2.5*y pigment { rgb 1 } }
object { Twig translate <2, 2.5, 0> }
)";

class Rays {
public:
    Vec3 point(double size) { return {coordinate(size), coordinate(size), coordinate(size)}; }
    Vec3 direction() {
        for (;;) {
            const Vec3 d = point(1.0);
            if (const double length = glm::length(d); length > 0.1 && length < 1.0) return d / length;
        }
    }

private:
    double coordinate(double size) { return std::uniform_real_distribution(-size, size)(dice_); }
    std::mt19937 dice_{7};
};

std::vector<SurfaceWeight> worn(const World& world, const Hit& hit) {
    std::vector<SurfaceWeight> out;
    world.geometry->surfaces_at(hit, out);
    return out;
}

/// Which texture, where it stands, which interior.
void expect_same_look(const World& a, const Hit& hit_a, const World& b, const Hit& hit_b, const Vec3& p) {
    const auto looks_a = worn(a, hit_a), looks_b = worn(b, hit_b);
    ASSERT_EQ(looks_a.size(), 1u);
    ASSERT_EQ(looks_b.size(), 1u);
    const Surface& x = a.surfaces[looks_a[0].surface];
    const Surface& y = b.surfaces[looks_b[0].surface];
    EXPECT_EQ(x.texture.layers, y.texture.layers);
    EXPECT_LT(glm::length(x.texture.world_from_texture.inverse_point(p) -
                          y.texture.world_from_texture.inverse_point(p)),
              1e-9);
    EXPECT_EQ(a.interiors[x.interior].interior.ior, b.interiors[y.interior].interior.ior);
    EXPECT_EQ(a.geometry->surface_of(hit_a.leaf, hit_a.crossing.member), looks_a[0].surface);
    EXPECT_EQ(a.geometry->leaf(hit_a.leaf).mask & b.geometry->leaf(hit_b.leaf).mask,
              b.geometry->leaf(hit_b.leaf).mask);
}

/// The query of a ray that leaves a hit.
RayQuery leaving(const Hit& hit, const Vec3& direction) {
    RayQuery query;
    query.ray = {hit.point, direction};
    query.origin_leaf = hit.leaf;
    query.origin_part = hit.crossing.part;
    query.origin_member = hit.crossing.member;
    query.origin_error = hit.error;
    return query;
}

/// A ray's hits one behind the other, and those of a ray that leaves each in another direction.
void compare_along(const World& shared, const World& flat, RayQuery query, Rays& rays, double tolerance) {
    RayQuery twin = query;
    for (int depth = 0; depth < 30; ++depth) {
        Hit a, b;
        const bool found = flat.geometry->closest(twin, b);
        ASSERT_EQ(shared.geometry->closest(query, a), found);
        uint32_t blocker = no_leaf;
        ASSERT_EQ(shared.geometry->occluded(query, blocker), found);
        if (!found) return;
        ASSERT_LT(glm::length(a.point - b.point), tolerance);
        ASSERT_LT(glm::length(a.normal - b.normal), 1e3 * tolerance);
        expect_same_look(shared, a, flat, b, b.point);
        for (const uint8_t mask : {uint8_t{blocks_light}, uint8_t{filters_light}}) {
            const Vec3 aside = rays.direction();
            RayQuery from_a = leaving(a, aside), from_b = leaving(b, aside);
            from_a.mask = from_b.mask = mask;
            Hit next_a, next_b;
            const bool again = flat.geometry->closest(from_b, next_b);
            ASSERT_EQ(shared.geometry->closest(from_a, next_a), again);
            if (again) {
                ASSERT_LT(glm::length(next_a.point - next_b.point), 100.0 * tolerance);
            }
        }
        query = leaving(a, query.ray.direction);
        twin = leaving(b, query.ray.direction);
    }
    FAIL() << "the ray does not come away from a surface";
}

void compare(const World& shared, const World& flat, double tolerance) {
    Rays rays;
    int met = 0;
    for (int i = 0; i < 6000 && !testing::Test::HasFailure(); ++i) {
        RayQuery query;
        query.ray.origin = rays.point(5.0);
        query.ray.direction = glm::normalize(rays.point(2.5) - query.ray.origin);
        Hit hit;
        met += shared.geometry->closest(query, hit) ? 1 : 0;
        compare_along(shared, flat, query, rays, tolerance);
    }
    EXPECT_GT(met, 1000);
}

TEST(Instances, HitsAreThoseOfFlattenedCopies) {
    const Scene scene = scene_from(grove);
    const World flat = compiled(scene, InstanceMode::never);
    const World shared = compiled(scene, InstanceMode::always);
    EXPECT_EQ(instances_in(flat), 0u);
    EXPECT_EQ(instances_in(shared), 6u);
    EXPECT_EQ(shared.geometry->leaves().size(), 6u);
    compare(shared, flat, 1e-11);
}

TEST(Instances, NoTreeNoDifference) {
    const Scene scene = scene_from(grove);
    compare(compiled(scene, InstanceMode::always, true), compiled(scene, InstanceMode::never), 1e-11);
}

// Its own numbers are large and their rounding shows in the world.
TEST(Instances, DeclaredFarFromItsOrigin) {
    const Scene scene = scene_from(twig + R"(
#declare Far = object { Twig translate <1e5, 2e5, -1e5> }
#declare Pair = union { object { Far } object { Far translate 0.9*z } }
object { Pair translate <-1e5, -2e5, 1e5> }
object { Pair translate <-1e5, -2e5, 1e5> scale <1, -2, 1> translate 2*x }
)");
    const World shared = compiled(scene, InstanceMode::always);
    ASSERT_EQ(instances_in(shared), 2u);
    compare(shared, compiled(scene, InstanceMode::never), 1e-9);
}

TEST(Instances, InsideIsTheSame) {
    const Scene scene = scene_from(grove);
    const World flat = compiled(scene, InstanceMode::never);
    const World shared = compiled(scene, InstanceMode::always);
    const auto iors = [](const World& world, const Vec3& p) {
        std::vector<double> out;
        for (const uint32_t i : world.geometry->interiors_at(p))
            out.push_back(world.interiors[i].interior.ior);
        std::ranges::sort(out);
        return out;
    };
    const auto inside = [](const World& world, const Vec3& p) {
        const FlatGeometry& all = world.geometry->parts->flat;
        return std::ranges::any_of(all.tops,
                                   [&](const TopSolid& top) { return all.solids.inside(top.node, p); });
    };
    Rays rays;
    int in = 0;
    for (int i = 0; i < 20000; ++i) {
        const Vec3 p = rays.point(3.5);
        const auto wanted = iors(flat, p);
        ASSERT_EQ(iors(shared, p), wanted);
        ASSERT_EQ(inside(shared, p), inside(flat, p));
        in += wanted.empty() ? 0 : 1;
    }
    EXPECT_GT(in, 100);
}

// What copies wear inside one compound says nothing of what they wear inside another.
TEST(Instances, LooksBelongToTheCompoundAround) {
    const Scene scene = scene_from(R"(
#declare Dot = union { sphere { 0, 0.2 } sphere { x, 0.2 pigment { rgb x } } }
#declare A = union { object { Dot } object { Dot translate y } }
#declare B = union { sphere { -y, 0.2 pigment { rgb z } } object { Dot } object { Dot translate y } }
object { A translate -3*x } object { A translate -3*x + 3*y } object { B } object { B translate 3*y }
)");
    const World flat = compiled(scene, InstanceMode::never);
    const World shared = compiled(scene, InstanceMode::always);
    for (const double x : {-3.0, -2.0, 0.0, 1.0}) {
        for (const double y : {-1.0, 0.0, 1.0, 2.0, 3.0, 4.0}) {
            RayQuery query;
            query.ray = {{x, y, -5}, {0, 0, 1}};
            Hit a, b;
            const bool found = flat.geometry->closest(query, b);
            ASSERT_EQ(shared.geometry->closest(query, a), found) << x << ' ' << y;
            if (found) expect_same_look(shared, a, flat, b, b.point);
        }
    }
}

TEST(Instances, WhatIsEmptyIsMetByNoRay) {
    const Scene scene = scene_from(R"(
#declare Nothing = union { intersection { sphere { -2*x, 1 } sphere { 2*x, 1 } } intersection { box { 0, 1 } box { 2, 3 } } }
object { Nothing } object { Nothing rotate 30*z translate x }
)");
    const World shared = compiled(scene, InstanceMode::always);
    ASSERT_EQ(instances_in(shared), 2u);
    EXPECT_EQ(shared.geometry->parts->elements.size(), 0u);
}

TEST(Instances, OnlyWhereMuchIsSaved) {
    EXPECT_EQ(instances_in(compiled(scene_from(grove), InstanceMode::automatic)), 0u);
    const std::string many = "#declare Row = union { #for (I, 1, 1000) sphere { I*x, 0.3 } #end }\n";
    const auto copies = [&](int n) {
        return many + "#for (I, 1, " + std::to_string(n) + ") object { Row translate I*y } #end";
    };
    EXPECT_EQ(instances_in(compiled(scene_from(copies(50)), InstanceMode::automatic)), 0u);
    EXPECT_EQ(instances_in(compiled(scene_from(copies(51)), InstanceMode::automatic)), 51u);
}

TEST(Instances, NotOfWhatCannotBeShared) {
    const auto instances = [](const std::string& children, const std::string& of_copy) {
        const std::string scene = "#declare U = union { sphere { 0, 1 } " + children + " }\n";
        return instances_in(compiled(
            scene_from(scene + "object { U " + of_copy + "} object { U translate x " + of_copy + "}"),
            InstanceMode::always));
    };
    EXPECT_EQ(instances("", ""), 2u);
    EXPECT_EQ(instances("light_source { 0, 1 }", ""), 0u);
    EXPECT_EQ(instances("plane { y, 0 }", ""), 0u);
    EXPECT_EQ(instances("", "clipped_by { plane { x, 0 } }"), 0u);
    EXPECT_EQ(instances("disc { 0, y, 1 }", ""), 0u);
    EXPECT_EQ(instances("triangle { 0, x, 2*y }", ""), 0u);
    EXPECT_EQ(instances("mesh { triangle { 0, x, 2*y } }", ""), 2u);
    EXPECT_EQ(instances("", "inverse "), 0u);
}

}  // namespace
}  // namespace rb
