// Single hard cases: rays in faces and from surfaces, coincident solids, slivers, nonsense input, deep CSG,
// many objects.
#include "compile/geometry.h"
#include "stress.h"
#include "tests/geometry/statement.h"

#include <array>
#include <cmath>
#include <vector>

#include <fmt/format.h>

namespace rb::stress {

namespace {

bool nearest(const World& world, const Ray& ray, Hit& hit) {
    RayQuery query;
    query.mask = seen_by_trace;
    query.ray = ray;
    return world.geometry->closest(query, hit);
}

std::string text(const Ray& ray) {
    const Vec3& o = ray.origin;
    const Vec3& d = ray.direction;
    return fmt::format("ray <{:.17g},{:.17g},{:.17g}> <{:.17g},{:.17g},{:.17g}>", o.x, o.y, o.z, d.x, d.y,
                       d.z);
}

/// In the plane of a box's face, and along its edges.
void rays_in_faces(const Effort& effort, Table& table) {
    const ShapePtr box = shape_from("box { -0.5, <0.5,0.25,0.75> }");
    const Bounds bounds = box->bounds();
    table.run("rays in faces of a box", effort.of(1e6), [&](Dice& dice) -> Trial {
        const int axis = static_cast<int>(dice.below(3));
        Vec3 d = dice.unit() < 0.2 ? Vec3{0.0} : dice.direction();
        if (d == Vec3{0.0}) d[(axis + 1) % 3] = 1.0;
        d[axis] = 0.0;
        d = glm::normalize(d);
        Vec3 target = dice.point(0.5);
        for (int i = 0; i < 3; ++i) {
            if (i == axis || dice.unit() < 0.2) target[i] = dice.coin() ? bounds.lo[i] : bounds.hi[i];
        }
        const Ray ray{target - 4.0 * d, d};
        Crossings all;
        box->crossings({ray}, all);
        if (all.size() % 2 == 0) return {};
        return {true, text(ray)};
    });
}

/// A ray that leaves along the tangent plane does not meet its own point again.
void tangent_starts(const Effort& effort, Table& table) {
    std::vector<World> worlds;
    for (const ShapeCase& c : shape_cases()) worlds.push_back(world_of({placed(c.statement, {})}));
    table.run("rays from surfaces along the tangent", effort.of(1e6), [&](Dice& dice) -> Trial {
        const size_t index = dice.below(worlds.size());
        const Vec3 d = dice.direction();
        Hit hit;
        if (!nearest(worlds[index], {dice.point(0.5) - 3.0 * d, d}, hit)) return Trial::nothing();
        RayQuery query;
        query.mask = seen_by_trace;
        query.ray = {hit.point, glm::normalize(glm::cross(hit.normal, dice.direction()))};
        query.origin_leaf = hit.leaf;
        query.origin_error = hit.error;
        query.origin_part = hit.crossing.part;
        Hit next;
        if (!worlds[index].geometry->closest(query, next) || next.t > 1e-13) return {};
        return {true, fmt::format("{}: t {} {}", shape_cases()[index].name, next.t, text(query.ray))};
    });
}

/// A solid cut with itself is itself; but closed cylinders and cones exclude their boundary (language rule),
/// so that nothing is left of their surface.
void coincident_solids(const Effort& effort, Table& table) {
    struct Pair {
        std::string name;
        World one;
        World both;
        bool nothing;
    };
    std::vector<Pair> pairs;
    for (const ShapeCase& c : shape_cases()) {
        // Of infinite solids rounding decides, as in POV-Ray (docs/differences.md, coincident curved faces).
        const ShapePtr shape = shape_from(c.statement);
        if (!bounds_a_body(*shape) || !shape->solid_bounds().is_finite()) continue;
        const bool nothing = c.kind->keyword == "cylinder" || c.kind->keyword == "cone";
        pairs.push_back({c.name, world_of({object_from(c.statement)}),
                         world_of({object_from(fmt::format("intersection {{ {0} {0} }}", c.statement))}),
                         nothing});
    }
    table.run("solids cut with themselves", effort.of(1e6), [&](Dice& dice) -> Trial {
        const Pair& pair = pairs[dice.below(pairs.size())];
        const Vec3 d = dice.direction();
        const Ray ray{dice.point(0.5) - 3.0 * d, d};
        Hit a;
        Hit b;
        const bool hit = !pair.nothing && nearest(pair.one, ray, a);
        if (hit == nearest(pair.both, ray, b) && (!hit || std::abs(a.t - b.t) < 1e-9)) return {};
        return {true, fmt::format("{}: {}", pair.name, text(ray))};
    });
}

/// Closed tetrahedra as thin as 1e-9 of their length, rays through their corners and edges, or past them by
/// rounding.
void slivers(const Effort& effort, Table& table) {
    table.run("slivers", effort.of(2e5), [](Dice& dice) -> Trial {
        const double thin = dice.scale(1e-9, 1e-1);
        std::array<Vec3, 4> p{Vec3{-1, 0, 0}, Vec3{1, 0, 0}, Vec3{0, thin, 0},
                              Vec3{0, 0, thin * dice.scale(1e-3, 1)}};
        const Transform turn = Transform::rotation_deg(dice.point(180));
        std::string statement = "mesh {";
        for (Vec3& v : p) v = turn.point(v);
        constexpr std::array<std::array<size_t, 3>, 4> faces{{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
        const auto vector = [](const Vec3& v) {
            return fmt::format("<{:.9g},{:.9g},{:.9g}>", v.x, v.y, v.z);
        };
        for (const auto& f : faces)
            statement +=
                fmt::format(" triangle {{ {}, {}, {} }}", vector(p[f[0]]), vector(p[f[1]]), vector(p[f[2]]));
        statement += " inside_vector <0,0,1> }";
        ShapePtr shape;
        try {
            shape = shape_from(statement);
        } catch (const SceneError&) {
            return Trial::nothing();
        }
        // A face of no area is left out by the language, and with it the mesh is open.
        const auto mesh = shape->tessellate(1.0);
        if (!mesh || mesh->faces.size() < faces.size()) return Trial::nothing();
        const auto& f = mesh->faces[dice.below(mesh->faces.size())];
        const Vec3 a(mesh->vertices[f[0]]);
        const Vec3 target = dice.coin() ? a : glm::mix(a, Vec3(mesh->vertices[f[1]]), dice.unit());
        Vec3 d = dice.direction();
        if (dice.coin()) d = {0, 0, std::copysign(1.0, d.z)};
        const Ray ray{target - 4.0 * d, d};
        Crossings all;
        shape->crossings({ray}, all);
        if (all.size() % 2 == 0) return {};
        return {true, fmt::format("{} {}", statement, text(ray))};
    });
}

/// Refused with a message, or harmless: all hits finite.
void nonsense(Table& table) {
    static constexpr std::array<std::string_view, 30> statements{
        "sphere { 0, 0 }",
        "sphere { 0, -1 }",
        "sphere { 0, 1e-300 }",
        "sphere { 0, 1e300 }",
        "sphere { <1e300,0,0>, 1 }",
        "box { 0, 0 }",
        "box { 0, <1,1,0> }",
        "box { -1e300, 1e300 }",
        "cylinder { 0, 0, 1 }",
        "cylinder { 0, y, 0 }",
        "cone { 0, 0, y, 0 }",
        "cone { 0, 1, 0, 1 }",
        "torus { 0, 0 }",
        "torus { 1, 0 }",
        "torus { 0.1, 1 }",
        "disc { 0, 0, 1 }",
        "plane { 0, 1 }",
        "triangle { 0, 0, 0 }",
        "triangle { 0, x, 2*x }",
        "smooth_triangle { 0, 0, x, 0, y, 0 }",
        "polygon { 4, 0, x, 2*x, 0 }",
        "mesh { triangle { 0, x, 2*x } triangle { 0, x, y } }",
        "bicubic_patch { type 1 0,0,0,0, 0,0,0,0, 0,0,0,0, 0,0,0,0 }",
        "blob { threshold 0 sphere { 0, 0, 1 } }",
        "superellipsoid { <0.0001, 0.0001> }",
        "quadric { 0, 0, 0, 0 }",
        "prism { 0, 0, 5, <0,0>, <1,0>, <1,1>, <0,1>, <0,0> }",
        "lathe { linear_spline 2, <0,0>, <0,0> }",
        "sphere { 0, 1 scale <1e-200,1,1> }",
        "sphere { 0, 1 matrix <1,0,0, 1,0,0, 0,0,1, 0,0,0> }",
    };
    table.run_listed("zero sizes, huge and degenerate numbers", statements.size(), [&](size_t i) -> Trial {
        try {
            const World world = world_of({object_from(statements[i])});
            Dice dice(i);
            for (int k = 0; k < 2000; ++k) {
                const Vec3 d = dice.direction();
                Hit hit;
                if (!nearest(world, {dice.point(1) - 3.0 * d, d}, hit)) continue;
                if (std::isfinite(hit.t) && std::isfinite(glm::dot(hit.normal, hit.normal))) continue;
                return {true, fmt::format("{}: t {}", statements[i], hit.t)};
            }
        } catch (const SceneError&) {
            return {};
        }
        return {};
    });
    static constexpr std::array<std::string_view, 6> not_numbers{
        "sphere { 0, 0/0 }",         "sphere { <0/0,0,0>, 1 }", "box { -1, sqrt(-1) }",
        "sphere { 0, 1 scale 1/0 }", "torus { 1, log(0) }",     "sphere { 0, 1 translate x*1e400 }"};
    table.run_listed("input that is no number", not_numbers.size(), [&](size_t i) -> Trial {
        try {
            const World world = world_of({object_from(not_numbers[i])});
            Hit hit;
            const bool found = nearest(world, {{0.1, 0.2, -5}, {0, 0, 1}}, hit);
            if (!found || (std::isfinite(hit.t) && std::isfinite(glm::dot(hit.normal, hit.normal))))
                return {};
            return {true, std::string(not_numbers[i])};
        } catch (const SceneError&) {
            return {};
        }
    });
}

void deep_csg(Table& table) {
    constexpr int levels = 1000;
    static constexpr std::array<std::string_view, 4> kinds{"union", "merge", "intersection", "difference"};
    table.run_listed("CSG, 1000 levels", kinds.size(), [&](size_t i) -> Trial {
        // Statements must not nest as deep; declared objects may.
        const std::string_view part = i == 2   ? "sphere { 0, 1 + 0.001 * I }"
                                      : i == 3 ? "sphere { <0.01 * I, 0, 3>, 1 }"
                                               : "sphere { <0.01 * I, 0, 0>, 1 }";
        const World world = world_of(
            scene_from(
                fmt::format("#declare A = sphere {{ 0, 1 }} #declare I = 1; #while (I <= {}) #declare A = {} "
                            "{{ object {{ A }} {} }} #declare I = I + 1; #end object {{ A }}",
                            levels, kinds[i], part))
                .objects);
        Hit hit;
        if (!nearest(world, {{0, 0, -5}, {0, 0, 1}}, hit) || std::abs(hit.t - 4) > 1e-12)
            return {true, fmt::format("{}: t {}", kinds[i], hit.t)};
        return {};
    });
}

/// From the centre of any of them its own surface is met.
void many_objects(const Effort& effort, Table& table) {
    const auto count = static_cast<size_t>(effort.of(1e6));
    const World world = world_of(
        scene_from(
            fmt::format(
                "#declare S = sphere {{ 0, 0.4 }} #declare I = 0; #while (I < {}) object {{ S translate "
                "<mod(I,100), mod(int(I/100),100), int(I/10000)> }} #declare I = I + 1; #end",
                count))
            .objects);
    table.run(fmt::format("{} objects", count), effort.of(1e6), [&](Dice& dice) -> Trial {
        const size_t i = dice.below(count);
        const Vec3 center{static_cast<double>(i % 100), static_cast<double>(i / 100 % 100),
                          static_cast<double>(i / 10000)};
        Hit hit;
        if (nearest(world, {center, dice.direction()}, hit) && std::abs(hit.t - 0.4) < 1e-9) return {};
        return {true, fmt::format("sphere {}", i)};
    });
}

void run(const Effort& effort, Table& table) {
    rays_in_faces(effort, table);
    tangent_starts(effort, table);
    coincident_solids(effort, table);
    slivers(effort, table);
    nonsense(table);
    deep_csg(table);
    many_objects(effort, table);
}

}  // namespace

const Family hard_cases{"hard_cases", "Single hard cases", run};

}  // namespace rb::stress
