// What must hold for every shape of the registry, each on its own example statement.
#include "compile/geometry.h"
#include "tests/geometry/shape_cases.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <gtest/gtest.h>

namespace rb {
namespace {

class EveryShape : public testing::TestWithParam<const ShapeKind*> {
protected:
    const ShapeKind& kind() const { return *GetParam(); }
    ShapePtr shape() const { return shape_from(kind().example); }
    bool infinite() const { return !shape()->bounds().is_finite(); }
};

/// A ray from afar towards the shape (or to the plane), and a hit on it.
bool random_hit(const World& world, Dice& dice, double scale, const Vec3& offset, Hit& hit) {
    RayQuery query;
    query.mask = seen_by_trace;
    const Vec3 d = dice.direction();
    query.ray = {offset + scale * (dice.point(0.6) - 3.0 * d), d};
    return world.geometry->closest(query, hit);
}

TEST_P(EveryShape, HitsLieOnTheSurfaceWithUnitNormals) {
    const World world = world_of({placed(kind().example, {})});
    const ShapePtr s = shape();
    Dice dice(1);
    int hits = 0;
    for (int i = 0; i < 50 * RB_TEST_SAMPLES; ++i) {
        Hit hit;
        if (!random_hit(world, dice, 1, Vec3{0.0}, hit)) continue;
        ++hits;
        EXPECT_NEAR(glm::length(hit.normal), 1.0, 1e-12);
        if (!bounds_a_body(*s)) continue;
        constexpr double step = 1e-6;
        const bool before = s->inside(hit.point + step * hit.normal);
        EXPECT_NE(before, s->inside(hit.point - step * hit.normal));
        if (has_outward_normals(*s)) {
            EXPECT_FALSE(before);
        }
    }
    EXPECT_GT(hits, 5 * RB_TEST_SAMPLES);
}

TEST_P(EveryShape, BoundsHoldEveryHit) {
    Dice dice(2);
    for (int trial = 0; trial < 20; ++trial) {
        const Transform map =
            then(Transform::scaling(Vec3{1.0} + dice.point(0.7)), Transform::rotation_deg(dice.point(180)));
        const ShapePtr moved = shape()->transformed(map);
        if (!moved) continue;
        const Bounds box = moved->bounds();
        for (int i = 0; i < 500; ++i) {
            const Vec3 d = dice.direction();
            Crossings all;
            const ShapeRay ray{{dice.point(0.6) - 5.0 * d, d}};
            moved->crossings(ray, all);
            for (size_t k = 0; k < all.size(); ++k) {
                const Vec3 p = ray.ray.at(all[k].t);
                for (int a = 0; a < 3; ++a) {
                    EXPECT_GE(p[a], box.lo[a] - 1e-13);
                    EXPECT_LE(p[a], box.hi[a] + 1e-13);
                }
            }
        }
    }
}

/// Shapes that bound a body (a disc's inside is a half-space, a patch has none).
class EverySolid : public EveryShape {};

TEST_P(EverySolid, CrossingsAlternateAndAgreeWithInside) {
    const ShapePtr s = shape();
    Dice dice(3);
    int odd = 0;
    for (int i = 0; i < 200 * RB_TEST_SAMPLES; ++i) {
        const Vec3 d = dice.direction();
        const ShapeRay ray{{dice.point(0.6) - 5.0 * d, d}};
        Crossings all;
        s->crossings(ray, all);
        std::vector<double> t;
        for (size_t k = 0; k < all.size(); ++k) t.push_back(all[k].t);
        std::sort(t.begin(), t.end());
        if (!infinite() && t.size() % 2 != 0) ++odd;
        bool in = s->inside(ray.ray.origin);
        for (size_t k = 0; k + 1 < t.size(); ++k) {
            in = !in;
            const double gap = t[k + 1] - t[k];
            if (gap > 1e-6) {
                EXPECT_EQ(s->inside(ray.ray.at(t[k] + 0.5 * gap)), in);
            }
        }
        Crossing nearest;
        EXPECT_EQ(s->closest(ray, nullptr, nearest), !t.empty());
        if (!t.empty()) {
            EXPECT_EQ(nearest.t, t.front());
        }
    }
    EXPECT_EQ(odd, 0);
}

/// What a shape lets a ray meet that starts on it.
struct Restart {
    bool returns = true;         ///< a ray may come back to the surface at all
    bool closed = true;          ///< an inward ray must
    double least_sine = 0.0;     ///< flatter rays tell nothing: normals are no better
    double least_facing = 1e-7;  ///< and neither do flatter crossings
};

Restart restart_of(const Shape& s) {
    Restart r;
    const bool infinite = !s.bounds().is_finite();
    r.closed = bounds_a_body(s) && !infinite;
    r.returns = s.curvature() != Curvature::flat;
    if (s.normal_rule() == NormalRule::differences) r.least_sine = 0.01;
    if (s.normal_rule() == NormalRule::of_iterate) {
        r.least_sine = 1.0;
        r.least_facing = 0.3;
    }
    return r;
}

/// A shape where it stands in a world; tells the way out where normals do not.
struct Standing {
    const Shape& shape;
    Transform world_from_object;
    double scale;
    bool solid;

    /// The hit's normal, turned outward; 0 where an edge is too near to tell.
    Vec3 way_out(const Hit& hit) const {
        if (!solid || has_outward_normals(shape)) return hit.normal;
        constexpr double step = 1e-5;
        const auto inside = [&](double side) {
            return shape.inside(
                world_from_object.inverse_point(hit.point + side * step * scale * hit.normal));
        };
        const bool before = inside(1.0);
        if (before == inside(-1.0)) return Vec3{0.0};
        return before ? -hit.normal : hit.normal;
    }
};

/// From a hit: outward rays enter before they leave, inward rays leave first; nothing lies at the origin.
void expect_no_self_hits(const World& world, const Standing& standing, const Vec3& offset,
                         const Restart& rule) {
    const double scale = standing.scale;
    Dice dice(4);
    int wrong = 0;
    int restarts = 0;
    for (int i = 0; i < 30 * RB_TEST_SAMPLES; ++i) {
        Hit hit;
        if (!random_hit(world, dice, scale, offset, hit)) continue;
        const Vec3 n = standing.way_out(hit);
        if (n == Vec3{0.0}) continue;
        const Vec3 along = glm::normalize(glm::cross(n, dice.direction()));
        for (const double sine : {1.0, -1.0, 0.3, -0.3, 1e-3, -1e-3, 1e-6, -1e-6}) {
            if (std::abs(sine) < rule.least_sine) continue;
            RayQuery query;
            query.mask = seen_by_trace;
            query.ray = {hit.point, glm::normalize(sine * n + std::sqrt(1 - sine * sine) * along)};
            query.origin_leaf = hit.leaf;
            query.origin_error = hit.error;
            if (i % 2) query.origin_part = hit.crossing.part;
            ++restarts;
            Hit next;
            if (!world.geometry->closest(query, next)) {
                // Inside a solid something must come.
                if (rule.closed && sine < -1e-4) ++wrong;
                continue;
            }
            if (!rule.returns) {
                ++wrong;
                continue;
            }
            const double facing = glm::dot(query.ray.direction, standing.way_out(next));
            if (std::abs(facing) > rule.least_facing && (facing < 0.0) != (sine > 0.0)) ++wrong;
            if (next.t <= 0.0) ++wrong;
        }
    }
    EXPECT_GT(restarts, 5 * RB_TEST_SAMPLES);
    EXPECT_EQ(wrong, 0) << "scale " << scale << ", offset " << offset.x << ", of " << restarts;
}

TEST_P(EveryShape, NoSelfHitsAtAnyScale) {
    const ShapePtr s = shape();
    const bool solid = bounds_a_body(*s) && !infinite();
    const Restart rule = restart_of(*shape());
    const Transform turn = then(Transform::scaling({1, 0.8, 1.1}), Transform::rotation_deg({20, 30, 40}));
    for (const Transform& base : {Transform{}, turn}) {
        for (const double scale : {1e-6, 1.0, 1e6}) {
            for (const double sizes : {0.0, 1e5}) {
                const Vec3 offset = scale * sizes * Vec3{1, 0.3, -0.7};
                const Transform map =
                    then(then(base, Transform::scaling(Vec3{scale})), Transform::translation(offset));
                // Mesh vertices are single precision before any transformation, so an offset keeps their
                // shape.
                expect_no_self_hits(world_of({placed(kind().example, map)}), {*s, map, scale, solid}, offset,
                                    rule);
            }
        }
    }
}

TEST_P(EveryShape, TransformedIsTheSameAsATransformBesideIt) {
    Dice dice(5);
    const Transform map =
        then(then(Transform::scaling({1.3, 0.7, 0.9}), Transform::rotation_deg({15, 25, 35})),
             Transform::translation({0.3, -0.2, 0.1}));
    const ShapePtr s = shape();
    for (const Transform& t :
         {map, then(Transform::scaling(Vec3{-1.7}), Transform::translation({1, 2, 3}))}) {
        const ShapePtr moved = s->transformed(t);
        if (!moved) continue;
        for (int i = 0; i < 10 * RB_TEST_SAMPLES; ++i) {
            const Vec3 d = dice.direction();
            const Vec3 from = t.point(dice.point(0.6)) - 5.0 * d;
            Crossing a, b;
            const bool hit = moved->closest(ShapeRay{{from, d}}, nullptr, a);
            const bool wanted =
                s->closest(ShapeRay{{t.inverse_point(from), t.inverse_direction(d)}}, nullptr, b);
            EXPECT_EQ(hit, wanted);
            if (!hit || !wanted) continue;
            EXPECT_NEAR(a.t, b.t, 1e-10);
            // The language makes vertex normals unit again after each transformation: a map that stretches
            // one way more than another changes what lies between them.
            if (s->normal_rule() == NormalRule::interpolated && t == map) continue;
            const Vec3 n = glm::normalize(moved->normal(from + a.t * d, a));
            const Vec3 m = glm::normalize(t.normal(s->normal(t.inverse_point(from + b.t * d), b)));
            // Triangles may turn over (language rule).
            EXPECT_NEAR(std::abs(glm::dot(n, m)), 1.0, 1e-8);
            if (!s->is_patch()) {
                EXPECT_GT(glm::dot(n, m), 0.0);
            }
        }
    }
}

/// Distance to the true surface along the ray through `p` along the normal direction `n`.
double distance_along(const Shape& s, const Vec3& p, const Vec3& n) {
    double best = std::numeric_limits<double>::infinity();
    for (const double sign : {1.0, -1.0}) {
        Crossing c;
        if (s.closest(ShapeRay{{p, sign * n}}, nullptr, c)) best = std::min(best, c.t);
    }
    return best;
}

/// The same in the plane across `n`: a point of a flat face may lie beside the true face's curved rim.
double distance_across(const Shape& s, const Vec3& p, const Vec3& n) {
    const Vec3 x = glm::normalize(glm::cross(n, std::abs(n.x) < 0.5 ? Vec3{1, 0, 0} : Vec3{0, 1, 0}));
    const Vec3 y = glm::cross(n, x);
    double best = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 8; ++i)
        best = std::min(best, distance_along(s, p, std::cos(i * pi / 8) * x + std::sin(i * pi / 8) * y));
    return best;
}

TEST_P(EveryShape, TessellationIsClosedOutwardAndWithinItsBound) {
    const ShapePtr s = shape();
    for (const double tolerance : {0.02, 0.001}) {
        const auto mesh = s->tessellate(tolerance);
        if (infinite()) {
            EXPECT_FALSE(mesh.has_value());
            return;
        }
        // A fine one of a fractal is not affordable.
        if (s->normal_rule() == NormalRule::of_iterate && !mesh && tolerance < 0.01) continue;
        ASSERT_TRUE(mesh.has_value());
        EXPECT_FALSE(mesh->faces.empty());
        EXPECT_LE(mesh->error, 1.01 * tolerance + 1e-6);
        const bool solid = bounds_a_body(*s);
        std::map<std::pair<uint32_t, uint32_t>, int> edges;
        double volume = 0;
        for (const auto& f : mesh->faces) {
            for (size_t k = 0; k < 3; ++k) ++edges[{f[k], f[(k + 1) % 3]}];
            const Vec3 a(mesh->vertices[f[0]]), b(mesh->vertices[f[1]]), c(mesh->vertices[f[2]]);
            volume += glm::dot(a, glm::cross(c, b)) / 6;
            EXPECT_NE(glm::cross(b - a, c - a), Vec3{0.0});
        }
        for (const auto& [edge, count] : edges) {
            EXPECT_EQ(count, 1);
            if (solid) {
                EXPECT_EQ(edges.count({edge.second, edge.first}), 1u);
            }
        }
        if (solid) {
            EXPECT_GT(volume, 0.0);
        }
        Dice dice(6);
        for (int i = 0; i < 40 * RB_TEST_SAMPLES; ++i) {
            const auto& f =
                mesh->faces[static_cast<size_t>(dice.unit() * static_cast<double>(mesh->faces.size()))];
            double u = dice.unit(), v = dice.unit();
            if (u + v > 1) u = 1 - u, v = 1 - v;
            const Vec3 a(mesh->vertices[f[0]]), b(mesh->vertices[f[1]]), c(mesh->vertices[f[2]]);
            const Vec3 p = a + u * (b - a) + v * (c - a);
            const Vec3 n = glm::normalize(glm::cross(c - a, b - a));
            // Looking along the facet's normal can only overrate the distance.
            double d = distance_along(*s, p + 1e-9 * n, n);
            if (d > mesh->error) d = std::min(d, distance_across(*s, p - 2 * mesh->error * n, n));
            if (std::isfinite(d)) {
                EXPECT_LE(d, 1.2 * mesh->error + 2e-9);
            }
        }
    }
}

TEST_P(EveryShape, NonsenseArgumentsAreRefusedOrHarmless) {
    Crossing c;
    const ShapePtr s = shape();
    for (const Vec3& d : {Vec3{0, 0, 1}, Vec3{0, -0.0, 1}, Vec3{-0.0, 1, 0}, Vec3{1, 0, 0}}) {
        const ShapeRay ray{{{0.01, 0.02, -1e9 * d.z}, d}};
        if (s->closest(ray, nullptr, c)) {
            EXPECT_TRUE(std::isfinite(c.t));
        }
    }
    EXPECT_FALSE(s->describe().empty());
}

std::vector<const ShapeKind*> solid_kinds() {
    std::vector<const ShapeKind*> kinds;
    for (const ShapeKind* kind : all_shapes()) {
        if (bounds_a_body(*shape_from(kind->example))) kinds.push_back(kind);
    }
    return kinds;
}

INSTANTIATE_TEST_SUITE_P(Registry, EverySolid, testing::ValuesIn(solid_kinds()),
                         [](const auto& test) { return std::string(test.param->keyword); });
INSTANTIATE_TEST_SUITE_P(Registry, EveryShape, testing::ValuesIn(all_shapes().begin(), all_shapes().end()),
                         [](const auto& test) { return std::string(test.param->keyword); });

}  // namespace
}  // namespace rb
