// Light at 89.9 degrees from the normal: what a point on a surface sees of it must be what points a little
// above the surface see. Where two such points agree with each other but not with it, it wears a speck.
#include "compile/geometry.h"
#include "stress.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>

namespace rb::stress {

namespace {

struct Standing {
    std::string name;
    World world;
    double scale;
    Vec3 offset;
    double sine;  ///< of the light above the surface
};

/// With normals between given ones or of another iterate a surface shades itself at any angle.
bool has_normals_of_its_surface(const Shape& shape) {
    return shape.normal_rule() != NormalRule::interpolated && shape.normal_rule() != NormalRule::of_iterate;
}
double sine_for(const Shape& shape) {
    return shape.normal_rule() == NormalRule::differences ? 0.02 : std::cos(89.9 * pi / 180.0);
}

std::vector<Standing> make_standing(double scale, double sizes) {
    std::vector<Standing> all;
    const Vec3 offset = scale * sizes * Vec3{1, 0.3, -0.7};
    const Transform map = then(then(Transform::rotation_deg({20, 30, 40}), Transform::scaling(Vec3{scale})),
                               Transform::translation(offset));
    for (const ShapeCase& c : shape_cases()) {
        const ShapePtr shape = shape_from(c.statement);
        if (!has_normals_of_its_surface(*shape)) continue;
        all.push_back({c.name, world_of({placed(c.statement, map)}), scale, offset, sine_for(*shape)});
    }
    return all;
}

/// True if the light's ray surely meets the body: between its first two crossings it is inside. Points above
/// do not see a rise that is lower than they are.
bool passes_through_body(const Geometry& geometry, const RayQuery& shadow) {
    const Leaf& leaf = geometry.leaf(shadow.origin_leaf);
    const Ray ray = leaf.in_world_space ? shadow.ray
                                        : Ray{leaf.object_from_world.point(shadow.ray.origin),
                                              leaf.object_from_world.direction(shadow.ray.direction)};
    ShapeRay query{ray};
    query.starts_on_surface = true;
    query.origin_part = shadow.origin_part;
    Crossings all;
    leaf.shape->crossings(query, all);
    std::vector<double> t;
    for (size_t i = 0; i < all.size(); ++i) t.push_back(all[i].t);
    std::ranges::sort(t);
    return t.size() > 1 && leaf.shape->inside(ray.at(0.5 * (t[0] + t[1])));
}

Trial look(const Standing& standing, Dice& dice) {
    const Geometry& geometry = *standing.world.geometry;
    RayQuery query;
    query.mask = seen_by_trace;
    const Vec3 from = dice.direction();
    query.ray = {standing.offset + standing.scale * (dice.point(0.5) - 3.0 * from), from};
    Hit hit;
    if (!geometry.closest(query, hit)) return Trial::nothing();
    const double steep = standing.sine;
    const Vec3 n = glm::dot(hit.normal, from) > 0.0 ? -hit.normal : hit.normal;
    const Vec3 along = glm::normalize(glm::cross(n, dice.direction()));
    const Vec3 to_light = glm::normalize(steep * n + std::sqrt(1 - steep * steep) * along);
    const auto toward_light = [&](double height) {
        RayQuery shadow;
        shadow.mask = seen_by_trace;
        shadow.ray = {hit.point + height * standing.scale * n, to_light};
        shadow.t_max = 1e3 * standing.scale;
        if (height == 0.0) {
            shadow.origin_leaf = hit.leaf;
            shadow.origin_error = hit.error;
            shadow.origin_part = hit.crossing.part;
        }
        return shadow;
    };
    const auto dark_at = [&](double height) {
        uint32_t blocker = no_leaf;
        return geometry.occluded(toward_light(height), blocker);
    };
    const bool dark = dark_at(0.0);
    for (const double height : {1e-9, 1e-7, 1e-6, 1e-5}) {
        if (dark == dark_at(height)) return {};
    }
    if (dark && passes_through_body(geometry, toward_light(0.0))) return {};
    const Vec3 p = (hit.point - standing.offset) / standing.scale;
    return {true, fmt::format("{}: {} at <{:.17g},{:.17g},{:.17g}> towards <{:.17g},{:.17g},{:.17g}>",
                              standing.name, dark ? "dark" : "lit", p.x, p.y, p.z, to_light.x, to_light.y,
                              to_light.z)};
}

void run(const Effort& effort, Table& table) {
    struct Place {
        std::string_view name;
        double scale;
        double sizes;
    };
    static constexpr std::array<Place, 4> places{{{"as it is", 1, 0},
                                                  {"scaled by 1e-6", 1e-6, 0},
                                                  {"scaled by 1e6", 1e6, 0},
                                                  {"moved by 1e4 sizes", 1, 1e4}}};
    for (const Place& place : places) {
        const std::vector<Standing> all = make_standing(place.scale, place.sizes);
        table.run(std::string(place.name), effort.of(1e7),
                  [&](Dice& dice) { return look(all[dice.below(all.size())], dice); });
    }
}

}  // namespace

const Family specks{"specks", "Light at 89.9 degrees", run};

}  // namespace rb::stress
