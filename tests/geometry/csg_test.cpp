// Compounds against an evaluation that knows nothing of trees: all crossings of all shapes, sorted, and the
// solid's inside test between them.
#include "compile/geometry.h"
#include "shape_cases.h"
#include "statement.h"

#include <algorithm>
#include <array>
#include <functional>

#include <gtest/gtest.h>

namespace rb {
namespace {

World compiled(const std::vector<ObjectPtr>& objects, bool brute_force = false) {
    Scene scene;
    scene.objects = objects;
    scene.default_texture = plain_texture();
    Diagnostics diagnostics;
    CompileOptions options;
    options.brute_force = brute_force;
    return compile(scene, options, diagnostics);
}

/// An object's solid by definition, straight from the IR.
bool inside(const Object& object, const Vec3& p) {
    const Vec3 q = object.world_from_object.inverse_point(p);
    bool in = false;
    if (const auto* shape = std::get_if<ShapePtr>(&object.geometry)) {
        in = (*shape)->inside(q);
    } else {
        const Csg& csg = std::get<Csg>(object.geometry);
        const auto& children = *csg.children;
        if (csg.kind == CsgKind::union_ || csg.kind == CsgKind::merge) {
            for (const auto& child : children) in = in || inside(*child, q);
        } else {
            in = true;
            for (size_t i = 0; i < children.size(); ++i) {
                const bool subtracted = csg.kind == CsgKind::difference && i > 0;
                in = in && inside(*children[i], q) != subtracted;
            }
        }
    }
    return in != object.inverse;
}

void collect(const Object& object, const Ray& ray, std::vector<double>& t) {
    const Ray local{object.world_from_object.inverse_point(ray.origin),
                    object.world_from_object.inverse_direction(ray.direction)};
    if (const auto* shape = std::get_if<ShapePtr>(&object.geometry)) {
        Crossings all;
        (*shape)->crossings(ShapeRay{local}, all);
        for (size_t i = 0; i < all.size(); ++i) t.push_back(all[i].t);
        return;
    }
    for (const auto& child : *std::get<Csg>(object.geometry).children) collect(*child, local, t);
}

/// First place where the ray goes from outside to inside or back.
double first_change(const Object& object, const Ray& ray, double& least_gap) {
    std::vector<double> t{0.0};
    collect(object, ray, t);
    std::erase_if(t, [](double x) { return x < 0.0; });
    std::sort(t.begin(), t.end());
    t.push_back(t.back() + 1.0);
    bool in = inside(object, ray.at(0.5 * (t[0] + t[1])));
    for (size_t i = 1; i + 1 < t.size(); ++i) {
        least_gap = std::min(least_gap, t[i] - t[i - 1]);
        const bool next = inside(object, ray.at(0.5 * (t[i] + t[i + 1])));
        if (next != in) return t[i];
        in = next;
    }
    return -1;
}

/// A random compound without unions (whose inner surfaces would also be hit).
ObjectPtr random_solid(Dice& dice, int depth) {
    auto object = std::make_shared<Object>();
    if (depth == 0) {
        constexpr std::string_view texts[] = {"sphere{0,1}",
                                              "box{<-.8,-.7,-.9>,<.7,.9,.8>}",
                                              "cylinder{<0,-1,0>,<0,1,0>,.7}",
                                              "cone{<0,-1,0>,1,<0,1,0>,.3}",
                                              "torus{.7,.35}",
                                              "plane{y,.3}"};
        *object = *object_from(texts[static_cast<size_t>(dice.unit() * 5.999)]);
        transform_object(
            *object, then(Transform::rotation_deg(dice.point(180)), Transform::translation(dice.point(0.5))));
    } else {
        Csg csg;
        csg.kind = dice.unit() < 0.34  ? CsgKind::merge
                   : dice.unit() < 0.5 ? CsgKind::intersection
                                       : CsgKind::difference;
        auto children = std::make_shared<std::vector<ObjectPtr>>();
        for (int i = 0; i < 2 + (depth == 1 ? 1 : 0); ++i) children->push_back(random_solid(dice, depth - 1));
        csg.children = children;
        object->geometry = csg;
        if (dice.unit() < 0.5) transform_object(*object, Transform::scaling(Vec3{1.1, 0.9, 1.0}));
        object->inverse = dice.unit() < 0.2;
    }
    return object;
}

/// Many small solids, and a half-space, that are taken from a box, or joined without inner surfaces.
ObjectPtr random_crowd(Dice& dice, CsgKind kind) {
    constexpr std::array<std::string_view, 5> texts{"sphere{0,.2}", "box{-.15,.15}",
                                                    "cylinder{<0,-.2,0>,<0,.2,0>,.1}", "torus{.15,.05}",
                                                    "intersection{ sphere{0,.2} box{<-.1,-1,-1>,<.1,1,1>} }"};
    auto children = std::make_shared<std::vector<ObjectPtr>>();
    if (kind == CsgKind::difference) children->push_back(object_from("box{-1,1}"));
    children->push_back(object_from("plane{y,-.9}"));
    for (int i = 0; i < 60; ++i) {
        auto child = std::make_shared<Object>(*object_from(texts[dice.below(texts.size())]));
        transform_object(
            *child, then(Transform::rotation_deg(dice.point(180)), Transform::translation(dice.point(1))));
        children->push_back(child);
    }
    auto object = std::make_shared<Object>();
    Csg csg;
    csg.kind = kind;
    csg.children = children;
    object->geometry = csg;
    return object;
}

void expect_sorted_crossings(const std::function<ObjectPtr(int trial, Dice&)>& solid_of, int trials) {
    Dice dice(17);
    int wrong = 0;
    int hits = 0;
    for (int trial = 0; trial < trials; ++trial) {
        const ObjectPtr solid = solid_of(trial, dice);
        const World world = compiled({solid});
        for (int i = 0; i < 300; ++i) {
            RayQuery query;
            query.ray.direction = dice.direction();
            query.ray.origin = dice.point(0.6) - 3.0 * query.ray.direction;
            double gap = 1;
            const double wanted = first_change(*solid, query.ray, gap);
            if (gap < 1e-9) continue;
            Hit hit;
            const bool found = world.geometry->closest(query, hit);
            hits += found ? 1 : 0;
            if (found != (wanted >= 0.0) || (found && std::abs(hit.t - wanted) > 1e-9)) ++wrong;
            // The normal points out of the solid.
            if (found && inside(*solid, hit.point + 1e-7 * hit.normal) &&
                !inside(*solid, hit.point - 1e-7 * hit.normal))
                ++wrong;
        }
    }
    EXPECT_GT(hits, 33 * trials);
    EXPECT_EQ(wrong, 0);
}

TEST(Csg, NestedCompoundsEqualSortedCrossings) {
    expect_sorted_crossings([](int trial, Dice& dice) { return random_solid(dice, 1 + trial % 3); }, 150);
}

TEST(Csg, CompoundsOfManyEqualSortedCrossings) {
    const auto crowd = [](int trial, Dice& dice) {
        return random_crowd(dice, trial % 2 == 0 ? CsgKind::difference : CsgKind::merge);
    };
    expect_sorted_crossings(crowd, 20);
}

/// Finds the same hits with and without trees, boxes and slabs, for rays from outside and from between the
/// objects; returns how many.
int expect_as_brute_force(const std::vector<ObjectPtr>& objects, Dice& dice) {
    const World tree = compiled(objects);
    const World brute = compiled(objects, true);
    int hits = 0;
    for (int i = 0; i < 20000; ++i) {
        RayQuery query;
        query.ray.direction = dice.direction();
        query.ray.origin = i % 4 == 0 ? dice.point(2) : dice.point(2) - 4.0 * query.ray.direction;
        if (i % 3 == 0) {
            query.ray.direction = Vec3{0.0};
            query.ray.direction[i % 2] = i % 4 < 2 ? 1.0 : -1.0;
        }
        Hit a, b;
        const bool found = tree.geometry->closest(query, a);
        EXPECT_EQ(found, brute.geometry->closest(query, b));
        query.mask = blocks_light;
        uint32_t blocker = no_leaf;
        EXPECT_EQ(tree.geometry->occluded(query, blocker), found);
        if (!found) continue;
        ++hits;
        EXPECT_EQ(a.t, b.t);
        EXPECT_EQ(a.leaf, b.leaf);
        EXPECT_TRUE(tree.geometry->occluded(query, blocker));
    }
    return hits;
}

TEST(Csg, NoTreeNoDifference) {
    Dice dice(17);
    std::vector<ObjectPtr> objects;
    for (int i = 0; i < 60; ++i) {
        auto object = std::make_shared<Object>(*random_solid(dice, i % 3));
        transform_object(*object, then(Transform::scaling(Vec3{0.3}), Transform::translation(dice.point(2))));
        objects.push_back(object);
    }
    // Coincident ones too: the tie must not depend on the tree.
    objects.push_back(objects[3]);
    objects.push_back(objects[7]);
    expect_as_brute_force(objects, dice);
}

// Turned solids that planes cut: slabs along the planes and tight boxes leave rays out, and no hit changes.
TEST(Csg, SlabsLeaveNothingOut) {
    const char* const statements[] = {
        "difference{blob{threshold 0.6 sphere{0,1,1} sphere{0,1,1 scale <0.3,1.2,1.05>} "
        "cylinder{-x,y,0.4,-1}}"
        " plane{y,0} plane{z,0 inverse} plane{x,-0.1 inverse}}",
        "intersection{blob{threshold 0.3 sphere{x/3,1,1} sphere{-x/3,1,0.8}} plane{x,0.3} "
        "clipped_by{plane{y,0.2}}}",
        "difference{union{sphere{0,1} box{<0,0,-1.2>,<1,1,1.2>}} plane{<1,2,0.5>,0} torus{0.8,0.2}}",
        "intersection{plane{y,0.5} plane{-y,0.5} box{<-1,-1,-1>,<1,1,1>} merge{cone{-x,1,x,0.2} "
        "sphere{0,0.7}}}",
        "object{sphere{0,1 scale <2,0.5,1>} clipped_by{plane{z,0.1}}}",
        "blob{threshold 0.6 sphere{0,1,1} sphere{0.1,1,1 scale <0.3,0.45,0.8>} sphere{y,0.8,-1}}"};
    Dice dice(23);
    std::vector<ObjectPtr> objects;
    for (int i = 0; i < 90; ++i) {
        auto object = std::make_shared<Object>(*object_from(statements[i % 6]));
        const Transform turned = i < 6 ? Transform{} : Transform::rotation_deg(180.0 * dice.point(1.0));
        transform_object(*object, then(then(turned, Transform::scaling(Vec3{0.4})),
                                       Transform::translation(i % 5 == 0 ? Vec3{0.0} : dice.point(2))));
        objects.push_back(object);
    }
    const int hits = expect_as_brute_force(objects, dice);
    EXPECT_GT(hits, 5000);
}

TEST(Csg, DeclaredCopiesShareTheirLook) {
    std::vector<ObjectPtr> objects;
    const ObjectPtr ball = object_from("sphere{0,1}");
    for (int i = 0; i < 100; ++i) {
        auto copy = std::make_shared<Object>(*ball);
        transform_object(*copy, Transform::translation({3.0 * i, 0, 0}));
        objects.push_back(copy);
    }
    const World world = compiled(objects);
    EXPECT_EQ(world.geometry->leaves().size(), 100u);
    EXPECT_EQ(world.surfaces.size(), 1u);
    EXPECT_TRUE(world.geometry->leaf(5).in_world_space);
}

TEST(Csg, CoincidentSurfaces) {
    const auto seen = [](std::vector<ObjectPtr> objects, const Vec3& from, const Vec3& direction) {
        const World world = compiled(objects);
        RayQuery query;
        query.ray = {from, glm::normalize(direction)};
        Hit hit;
        EXPECT_TRUE(world.geometry->closest(query, hit));
        return std::string(world.geometry->leaf(hit.leaf).shape->keyword());
    };
    const ObjectPtr box = object_from("box{-1,1}");
    const ObjectPtr plane = object_from("plane{<0,0,-1>,1}");
    EXPECT_EQ(seen({box, plane}, {0, 0, -5}, {0, 0, 1}), "box");
    EXPECT_EQ(seen({box, plane, object_from("sphere{50,1}")}, {0, 0, -5}, {0, 0, 1}), "plane");
    EXPECT_EQ(seen({box, plane, object_from("sphere{50,1}")}, {0.1, 0.2, -5}, {0.01, 0.02, 1}), "plane");
    EXPECT_EQ(seen({object_from("intersection{box{-1,1} cylinder{<0,0,-1>,<0,0,1>,1}}")}, {0.1, 0.2, -5},
                   {0.01, 0.02, 1}),
              "cylinder");
}

// A ray that leaves one surface must not see another one that lies in the same place.
TEST(Csg, CoincidentSurfacesAreIgnoredAtTheOrigin) {
    const World world = compiled({object_from("plane{y,0}"), object_from("box{<-1,0,-1>,<1,1,1>}"),
                                  object_from("disc{<0,0,0>,y,2}"), object_from("sphere{<0,5,0>,1}")});
    Dice dice(17);
    int wrong = 0;
    for (int i = 0; i < 2000; ++i) {
        RayQuery down;
        down.ray = {{3 + dice.unit(), 2, 3 + dice.unit()},
                    glm::normalize(Vec3{-0.9, -0.6, -0.8} + 0.1 * dice.point(1))};
        Hit hit;
        ASSERT_TRUE(world.geometry->closest(down, hit));
        for (const double sine : {1.0, 1e-3, 1e-6}) {
            RayQuery query;
            query.ray = {hit.point,
                         glm::normalize(sine * hit.normal + glm::cross(hit.normal, dice.direction()))};
            query.origin_leaf = hit.leaf;
            query.origin_error = hit.error;
            Hit next;
            if (world.geometry->closest(query, next) && next.t < 1e-6) ++wrong;
        }
    }
    EXPECT_EQ(wrong, 0);
}

TEST(Csg, InteriorsOfSolidsThatHoldAPoint) {
    const World world =
        compiled({object_from("sphere{0,1}"), object_from("box{-2,<0,2,2>}"), object_from("plane{y,-5}"),
                  object_from("difference{sphere{0,4} sphere{0,3}}")});
    EXPECT_EQ(world.geometry->interiors_at({-0.1, 0, 0}).size(), 2u);
    EXPECT_EQ(world.geometry->interiors_at({0.5, 0, 0}).size(), 1u);
    EXPECT_EQ(world.geometry->interiors_at({0, -6, 0}).size(), 1u);
    EXPECT_EQ(world.geometry->interiors_at({3.5, 0, 0}).size(), 1u);
    // Those near a box are enough for its points; the plane is near everything.
    const Bounds box{{-0.2, -6, 2.1}, {0.4, 0.2, 4.4}};
    const std::vector<uint32_t> near = world.geometry->solids_near(box);
    EXPECT_EQ(near, (std::vector<uint32_t>{2, 3}));
    for (double t = 0; t <= 1; t += 0.05) {
        const Vec3 p = box.lo + t * box.size();
        EXPECT_EQ(world.geometry->interiors_at(p, near), world.geometry->interiors_at(p));
    }
}

TEST(Csg, VisibilityFlags) {
    const World world =
        compiled({object_from("sphere{0,1 no_shadow}"), object_from("sphere{5,1 no_image}"),
                  object_from("union{sphere{<9,0,0>,1 no_image} sphere{<12,0,0>,1} split_union off}")});
    const auto& leaves = world.geometry->leaves();
    EXPECT_EQ(leaves[0].mask & (blocks_light | filters_light), 0);
    EXPECT_EQ(leaves[1].mask & seen_by_image, 0);
    // Measured: in a union that stays whole a child's no_image does nothing to camera rays.
    EXPECT_NE(leaves[2].mask & seen_by_image, 0);
    EXPECT_NE(leaves[3].mask & seen_by_image, 0);
    EXPECT_TRUE(world.geometry->has(blocks_light));
    EXPECT_FALSE(world.geometry->has(filters_light));
}

}  // namespace
}  // namespace rb
