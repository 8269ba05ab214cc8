// What CSG children receive from their parents (language rules, measured), and textures that meshes bring
// along.
#include "block/reader.h"
#include "compile/geometry.h"
#include "shapes/registry.h"
#include "tests/geometry/statement.h"

#include <gtest/gtest.h>

namespace rb {
namespace {

TexturePtr coloured(const Color& color) {
    auto pigment = std::make_shared<Pigment>();
    pigment->source = color;
    Texture layer;
    layer.pigment = std::move(pigment);
    layer.finish = std::make_shared<Finish>();
    return std::make_shared<TextureLayers>(TextureLayers{std::move(layer)});
}

std::shared_ptr<Object> with_texture(std::string_view text, const TexturePtr& texture) {
    auto object = std::make_shared<Object>(*object_from(text));
    if (texture) object->texture = WornTexture{texture, {}};
    return object;
}

std::shared_ptr<Object> csg(CsgKind kind, std::vector<ObjectPtr> children) {
    auto object = std::make_shared<Object>();
    Csg c;
    c.kind = kind;
    c.children = std::make_shared<std::vector<ObjectPtr>>(std::move(children));
    object->geometry = c;
    return object;
}

class Inherit : public testing::Test {
protected:
    World world(std::vector<ObjectPtr> objects) {
        Scene scene;
        scene.objects = std::move(objects);
        scene.default_texture = standard;
        return compile(scene, {}, diagnostics);
    }
    /// The surface seen from `from` along `d`.
    static const Surface& seen(const World& w, const Vec3& from, const Vec3& d, Hit& hit) {
        RayQuery query;
        query.ray = {from, d};
        EXPECT_TRUE(w.geometry->closest(query, hit));
        return w.surfaces[w.geometry->leaf(hit.leaf).surface];
    }
    static TexturePtr texture(const World& w, const Vec3& from, const Vec3& d) {
        Hit hit;
        return seen(w, from, d, hit).texture.layers;
    }

    Diagnostics diagnostics;
    TexturePtr standard = coloured({0.5f, 0.5f, 0.5f, 0, 0});
    TexturePtr red = coloured({1, 0, 0, 0, 0});
    TexturePtr green = coloured({0, 1, 0, 0, 0});
    TexturePtr glass = coloured({1, 1, 1, 0.9f, 0});
};

TEST_F(Inherit, UntexturedCutShowsTheDefault) {
    const World w =
        world({csg(CsgKind::difference, {with_texture("box{-1,1}", red), object_from("box{-.5,<2,2,2>}")})});
    EXPECT_EQ(texture(w, {0, 0, 5}, {0, 0, -1}), standard);
    EXPECT_EQ(texture(w, {0, 0, -5}, {0, 0, 1}), red);
}

TEST_F(Inherit, ParentsTextureReachesTheCutOnly) {
    auto object = csg(CsgKind::difference, {with_texture("box{-1,1}", red), object_from("box{-.5,<2,2,2>}")});
    object->texture = WornTexture{green, {}};
    const World w = world({object});
    EXPECT_EQ(texture(w, {0, 0, 5}, {0, 0, -1}), green);
    EXPECT_EQ(texture(w, {0, 0, -5}, {0, 0, 1}), red);
}

TEST_F(Inherit, CutawayTexturesShowTheCutObject) {
    auto object = csg(CsgKind::difference, {with_texture("box{-1,1}", red), object_from("box{-.5,<2,2,2>}")});
    std::get<Csg>(object->geometry).cutaway_textures = true;
    const auto seen = [](const World& w, const Vec3& origin, const Vec3& direction) {
        RayQuery query;
        query.ray = {origin, direction};
        Hit hit;
        EXPECT_TRUE(w.geometry->closest(query, hit));
        std::vector<SurfaceWeight> shown;
        w.geometry->surfaces_at(hit, shown);
        std::vector<std::pair<TexturePtr, float>> out;
        for (const auto& [surface, weight] : shown) {
            out.emplace_back(w.surfaces[surface].texture.layers, weight);
        }
        return out;
    };
    using Shown = std::vector<std::pair<TexturePtr, float>>;
    EXPECT_EQ(seen(world({object}), {0, 0, 5}, {0, 0, -1}), (Shown{{red, 1.0f}}));

    // Of two that contain the cut each shows half.
    auto both =
        csg(CsgKind::difference,
            {csg(CsgKind::union_, {with_texture("box{-1,1}", red), with_texture("box{-2,<.5,.5,1>}", green)}),
             object_from("box{-.5,<2,2,2>}")});
    std::get<Csg>(both->geometry).cutaway_textures = true;
    const World w = world({both});
    EXPECT_EQ(seen(w, {0.3, 0.3, 5}, {0, 0, -1}), (Shown{{red, 0.5f}, {green, 0.5f}}));
    EXPECT_EQ(seen(w, {0.7, 0.3, 5}, {0, 0, -1}), (Shown{{red, 1.0f}}));
}

TEST_F(Inherit, FallbackTextureOfTheStatementWins) {
    auto object = std::make_shared<Object>(*object_from("sphere{0,1}"));
    object->fallback_texture = green;
    EXPECT_EQ(texture(world({object}), {0, 0, -5}, {0, 0, 1}), green);
}

TEST_F(Inherit, TexturesMoveWithLaterTransformationsOfParents) {
    auto child = std::make_shared<Object>(*object_from("sphere{0,1 pigment{bozo}}"));
    child->texture->world_from_texture = Transform::scaling(Vec3{2});
    auto parent = csg(CsgKind::union_, {child, object_from("sphere{<9,0,0>,1}")});
    transform_object(*parent, Transform::translation({3, 0, 0}));
    auto uv_child = std::make_shared<Object>(*child);
    uv_child->uv_mapping = true;
    auto uv_parent = csg(CsgKind::union_, {uv_child});
    transform_object(*uv_parent, Transform::translation({30, 0, 0}));
    const World w = world({parent, uv_parent});
    Hit hit;
    EXPECT_EQ(seen(w, {3, 0, -5}, {0, 0, 1}, hit).texture.world_from_texture.point({1, 0, 0}),
              (Vec3{5, 0, 0}));
    const Surface& uv = seen(w, {30, 0, -5}, {0, 0, 1}, hit);
    EXPECT_TRUE(uv.uv_mapping);
    EXPECT_EQ(uv.texture.world_from_texture.point({1, 0, 0}), (Vec3{2, 0, 0}));
}

TEST_F(Inherit, ChildrenShareOneInteriorAndObjectsDoNot) {
    auto interior = std::make_shared<Interior>();
    interior->ior = 1.5;
    auto pair =
        csg(CsgKind::union_, {with_texture("sphere{0,1}", glass), with_texture("sphere{<3,0,0>,1}", glass)});
    pair->interior = interior;
    auto single = with_texture("sphere{<6,0,0>,1}", glass);
    single->interior = interior;
    const World w = world({pair, single});
    Hit hit;
    const uint32_t a = seen(w, {0, 0, -5}, {0, 0, 1}, hit).interior;
    const uint32_t b = seen(w, {3, 0, -5}, {0, 0, 1}, hit).interior;
    const uint32_t c = seen(w, {6, 0, -5}, {0, 0, 1}, hit).interior;
    EXPECT_EQ(a, b);
    EXPECT_NE(a, c);
    EXPECT_EQ(w.interiors[a].interior.ior, 1.5);
    EXPECT_EQ(w.geometry->interiors_at({6, 0, 0}), std::vector<uint32_t>{c});
    EXPECT_EQ(w.geometry->leaf(hit.leaf).mask & (blocks_light | filters_light), filters_light);
}

TEST_F(Inherit, LightsComeOutOfUnionsWithTheirTransform) {
    auto light = std::make_shared<Light>();
    light->location = {1, 0, 0};
    light->looks_like = object_from("sphere{<1,0,0>,.1}");
    auto object = std::make_shared<Object>();
    object->geometry = LightPtr(light);
    auto parent = csg(CsgKind::union_, {object, object_from("sphere{<9,0,0>,1}")});
    transform_object(*parent, Transform::translation({0, 5, 0}));
    const World w = world({parent});
    ASSERT_EQ(w.lights.size(), 1u);
    EXPECT_EQ(w.lights[0].light.location, (Vec3{1, 5, 0}));
    Hit hit;
    seen(w, {1, 5, -5}, {0, 0, 1}, hit);
    EXPECT_EQ(w.geometry->leaf(hit.leaf).mask & (blocks_light | filters_light), 0);
}

TEST_F(Inherit, LightGroups) {
    const auto lamp = [] {
        auto object = std::make_shared<Object>();
        object->geometry = LightPtr(std::make_shared<Light>());
        return object;
    };
    const auto group = [&](std::vector<ObjectPtr> children, bool global) {
        auto made = csg(CsgKind::union_, std::move(children));
        std::get<Csg>(made->geometry).is_light_group = true;
        std::get<Csg>(made->geometry).global_lights = global;
        return made;
    };
    const auto inner = group({object_from("sphere{<2,0,0>,.1}"), lamp()}, true);
    const auto unlit = group({object_from("sphere{<3,0,0>,.1}")}, false);
    const auto outer = group({object_from("sphere{<1,0,0>,.1}"), inner, unlit, lamp()}, false);
    const World w = world({object_from("sphere{<0,0,0>,.1}"), lamp(), outer, unlit});
    ASSERT_EQ(w.lights.size(), 3u);
    EXPECT_TRUE(w.lights[0].is_global);
    EXPECT_FALSE(w.lights[1].is_global);
    EXPECT_FALSE(w.lights[2].is_global);
    const auto lit_by = [&](double x) {
        Hit hit;
        seen(w, {x, 0, -5}, {0, 0, 1}, hit);
        return w.surfaces[w.geometry->surface_of(hit.leaf, 0)].lights;
    };
    EXPECT_TRUE(lit_by(0).global);
    EXPECT_TRUE(w.light_groups[lit_by(0).group].empty());
    for (const double x : {1.0, 2.0, 3.0}) EXPECT_FALSE(lit_by(x).global) << x;
    // The light of the inner group came first.
    EXPECT_EQ(w.light_groups[lit_by(1).group], std::vector<uint32_t>{2});
    EXPECT_EQ(w.light_groups[lit_by(2).group], std::vector<uint32_t>{1});
    EXPECT_EQ(w.light_groups[lit_by(3).group], std::vector<uint32_t>{2});
}

TEST_F(Inherit, WhatALightIsProjectedThroughIsNotSeen) {
    auto light = std::make_shared<Light>();
    light->projected_through = object_from("sphere{<0,0,5>,1}");
    auto object = std::make_shared<Object>();
    object->geometry = LightPtr(light);
    auto parent = csg(CsgKind::union_, {object, object_from("sphere{<9,0,0>,1}")});
    transform_object(*parent, Transform::translation({0, 2, 0}));
    const World w = world({parent});
    EXPECT_EQ(w.geometry->leaves().size(), 1u);
    ASSERT_TRUE(w.lights[0].projected_through);
    RayQuery query;
    query.ray = {{0, 2, 0}, {0, 0, 1}};
    query.mask = seen_by_trace;
    Hit hit;
    ASSERT_TRUE(w.lights[0].projected_through->closest(query, hit));
    EXPECT_NEAR(hit.t, 4.0, 1e-12);
}

TEST_F(Inherit, UnsupportedShapesAreReportedAndLeftOut) {
    auto object = std::make_shared<Object>();
    object->geometry = UnsupportedShape{"isosurface"};
    const World w = world({object, object, object_from("sphere{0,1}")});
    EXPECT_EQ(w.geometry->leaves().size(), 1u);
    ASSERT_EQ(diagnostics.all_unsupported().size(), 1u);
    EXPECT_EQ(diagnostics.all_unsupported()[0].count, 2);
}

TEST_F(Inherit, MeshFacesBlendTheirTextures) {
    const ObjectPtr object = object_from(
        "mesh2{vertex_vectors{3,<0,0,0>,<1,0,0>,<0,1,0>} texture_list{3 texture{pigment{rgb x}} "
        "texture{pigment{rgb y}} "
        "texture{pigment{rgb z}}} face_indices{1,<0,1,2>,0,1,2}}");
    const World w = world({object});
    Hit hit;
    seen(w, {.5, .2, -5}, {0, 0, 1}, hit);
    std::vector<SurfaceWeight> wears;
    w.geometry->surfaces_at(hit, wears);
    ASSERT_EQ(wears.size(), 3u);
    Rgb sum{0.0f};
    for (const SurfaceWeight& s : wears) {
        sum += s.weight * std::get<Color>((*w.surfaces[s.surface].texture.layers)[0].pigment->source).rgb();
    }
    EXPECT_NEAR(sum.x, 0.3, 1e-6);
    EXPECT_NEAR(sum.y, 0.5, 1e-6);
    EXPECT_NEAR(sum.z, 0.2, 1e-6);
}

TEST_F(Inherit, BlobComponentsBlendTheirTextures) {
    const ObjectPtr object = object_from(
        "blob{threshold .5 sphere{0,1,1 pigment{rgb <1,0,0>}} sphere{<1,0,0>,1,1 pigment{rgb <0,1,0>}} "
        "sphere{<0.3,0,0>,0.1,0.001} pigment{rgb <0,0,1>} interior_texture{pigment{rgb 1}}}");
    const World w = world({object});
    Hit hit;
    seen(w, {.3, 0, -5}, {0, 0, 1}, hit);
    std::vector<SurfaceWeight> wears;
    w.geometry->surfaces_at(hit, wears);
    ASSERT_EQ(wears.size(), 2u);
    Rgb sum{0.0f};
    for (const SurfaceWeight& s : wears) {
        sum += s.weight * std::get<Color>((*w.surfaces[s.surface].texture.layers)[0].pigment->source).rgb();
        EXPECT_FALSE(w.surfaces[s.surface].interior_texture.has_value());
    }
    EXPECT_NEAR(sum.x, 0.867, 1e-3);
    EXPECT_NEAR(sum.y, 0.133, 1e-3);
}

TEST_F(Inherit, MeshMistakesAreNamed) {
    const auto read = [&](std::string_view text) -> std::string {
        try {
            object_from(text);
        } catch (const SceneError& error) {
            return error.diagnostic().message;
        }
        return "accepted";
    };
    EXPECT_EQ(read("mesh2{vertex_vectors{3,<0,0,0>,<1,0,0>,<0,1,0>} face_indices{1,<0,1,3>}}"),
              "Mesh face index out of range.");
    EXPECT_EQ(read("plane{<0,0,0>,1}"), "Degenerate plane normal.");
    EXPECT_EQ(read("cylinder{<1,1,1>,<1,1,1>,1}"), "Degenerate cylinder.");
    EXPECT_EQ(read("mesh{inside_vector y}"), "No triangles in triangle mesh.");
    EXPECT_NE(read("mesh2{vertex_vectors{9,<0,0,0>,<1,0,0>} face_indices{1,<0,1,3>}}"), "accepted");
}

}  // namespace
}  // namespace rb
