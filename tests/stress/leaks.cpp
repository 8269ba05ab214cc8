// Rays through closed shapes, aimed at where numbers are worst. A ray that starts outside crosses the surface
// an even number of times; and followed from hit to hit, as mirrors and glass do, every ray that enters
// leaves.
#include "compile/geometry.h"
#include "compile/tessellated.h"
#include "stress.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include <fmt/format.h>

namespace rb::stress {

namespace {

struct Solid {
    std::string name;
    ShapePtr exact;
    ShapePtr facets;  ///< null for shapes that have no mesh
    TriangleMesh mesh;
    World world;
};

std::vector<Solid> make_solids() {
    std::vector<Solid> solids;
    for (const ShapeCase& c : shape_cases()) {
        Solid solid;
        solid.name = c.name;
        solid.exact = shape_from(c.statement);
        if (!bounds_a_body(*solid.exact) || !solid.exact->bounds().is_finite()) continue;
        constexpr double tolerance = 0.01;
        if (auto mesh = solid.exact->tessellate(tolerance)) {
            solid.mesh = *mesh;
            solid.facets = std::make_shared<TessellatedShape>(solid.exact, std::move(*mesh),
                                                              TessellatedShape::Hits::on_facets);
        }
        CompileOptions options;
        options.geometry = GeometryMode::exact;
        solid.world = world_of({placed(c.statement, {})}, options);
        solids.push_back(std::move(solid));
    }
    return solids;
}

/// From afar through a point.
Ray through(const Vec3& target, const Vec3& d) { return {target - 4.0 * d, d}; }

Vec3 vertex(const TriangleMesh& mesh, Dice& dice) {
    return Vec3(mesh.vertices[dice.below(mesh.vertices.size())]);
}

Vec3 edge_point(const TriangleMesh& mesh, Dice& dice) {
    const auto& face = mesh.faces[dice.below(mesh.faces.size())];
    const size_t k = dice.below(3);
    return glm::mix(Vec3(mesh.vertices[face[k]]), Vec3(mesh.vertices[face[(k + 1) % 3]]), dice.unit());
}

/// False if the dice gave no ray.
using Aim = bool (*)(const Solid& solid, Dice& dice, Ray& ray);

bool anywhere(const Solid&, Dice& dice, Ray& ray) {
    ray = through(dice.point(0.6), dice.direction());
    return true;
}

/// Along an axis through round coordinates: in faces, through seams, along edges.
bool along_lattice(const Solid&, Dice& dice, Ray& ray) {
    Vec3 target;
    for (int i = 0; i < 3; ++i) target[i] = 0.05 * (static_cast<double>(dice.below(25)) - 12.0);
    Vec3 d{0.0};
    d[static_cast<int>(dice.below(3))] = dice.coin() ? 1.0 : -1.0;
    ray = through(target, d);
    return true;
}

bool at_vertex(const Solid& solid, Dice& dice, Ray& ray) {
    if (!solid.facets) return false;
    ray = through(vertex(solid.mesh, dice), dice.direction());
    return true;
}

bool at_edge(const Solid& solid, Dice& dice, Ray& ray) {
    if (!solid.facets) return false;
    ray = through(edge_point(solid.mesh, dice), dice.direction());
    return true;
}

/// In the plane through a vertex across an axis, where a tree may have been split.
bool in_split_plane(const Solid& solid, Dice& dice, Ray& ray) {
    if (!solid.facets) return false;
    const int axis = static_cast<int>(dice.below(3));
    Vec3 d = dice.direction();
    d[axis] = 0.0;
    d = glm::normalize(d);
    Vec3 target = dice.point(0.5);
    target[axis] = vertex(solid.mesh, dice)[axis];
    ray = through(target, d);
    return true;
}

/// Along the surface, some last bits above or below it.
bool at_silhouette(const Solid& solid, Dice& dice, Ray& ray) {
    RayQuery query;
    query.mask = seen_by_trace;
    query.ray = through(dice.point(0.5), dice.direction());
    Hit hit;
    if (!solid.world.geometry->closest(query, hit)) return false;
    const Vec3 d = glm::normalize(glm::cross(hit.normal, dice.direction()));
    ray = through(hit.point + std::round(dice.between(-8, 8)) * 0x1p-53 * hit.normal, d);
    return true;
}

enum class Side { inside, outside, unclear };

/// Which side of a surface points lie on; unclear next to it.
class Truth {
public:
    virtual bool inside(const Vec3& p) const = 0;

    Side side(const Vec3& p) const {
        constexpr double step = 1e-6;
        const bool first = inside(p);
        // All around, for the sake of edges that point inwards.
        for (const double x : {-step, 0.0, step}) {
            for (const double y : {-step, 0.0, step}) {
                for (const double z : {-step, 0.0, step}) {
                    if (inside(p + Vec3{x, y, z}) != first) return Side::unclear;
                }
            }
        }
        return first ? Side::inside : Side::outside;
    }

protected:
    ~Truth() = default;
};

class ShapeTruth final : public Truth {
public:
    explicit ShapeTruth(const Shape& shape) : shape_(shape) {}
    bool inside(const Vec3& p) const override { return shape_.inside(p); }

private:
    const Shape& shape_;
};

/// Of facets, by counting along a direction that nothing is aligned with.
class FacetTruth final : public Truth {
public:
    explicit FacetTruth(const Shape& facets) : facets_(facets) {}
    bool inside(const Vec3& p) const override {
        Crossings all;
        facets_.crossings({{p, Vec3{0.5431, 0.6127, 0.5739}}}, all);
        return all.size() % 2 == 1;
    }

private:
    const Shape& facets_;
};

std::string described(const Ray& ray) {
    const Vec3& o = ray.origin;
    const Vec3& d = ray.direction;
    return fmt::format("ray <{:.17g},{:.17g},{:.17g}> <{:.17g},{:.17g},{:.17g}>", o.x, o.y, o.z, d.x, d.y,
                       d.z);
}

/// A crossing must lie between any two places of the ray on different sides; a mere touch may count or not.
Trial judge(const std::string& name, const Truth& truth, const Ray& ray, std::vector<double> t) {
    const auto fail = [&](double from, double to) {
        return Trial{true, fmt::format("{}: between {} and {} of {} crossings, {}", name, from, to, t.size(),
                                       described(ray))};
    };
    std::ranges::sort(t);
    constexpr double end = 8.0;
    t.insert(t.begin(), 0.0);
    t.push_back(end);
    for (size_t i = 0; i + 1 < t.size(); ++i) {
        constexpr double least = 1e-5;
        if (!(t[i + 1] - t[i] > least)) continue;
        // Before the first crossing and behind the last the ray is outside.
        bool in = false;
        bool out = i == 0 || i + 2 == t.size();
        for (const double share : {0.02, 0.2, 0.5, 0.8, 0.98}) {
            const Side side = truth.side(ray.at(glm::mix(t[i], t[i + 1], share)));
            in = in || side == Side::inside;
            out = out || side == Side::outside;
        }
        if (in && out) return fail(t[i], t[i + 1]);
    }
    return {};
}

Trial all_crossings(const std::string& name, const Shape& shape, const Truth& truth, const Ray& ray) {
    Crossings all;
    shape.crossings({ray}, all);
    std::vector<double> t;
    for (size_t i = 0; i < all.size(); ++i) t.push_back(all[i].t);
    return judge(name, truth, ray, std::move(t));
}

Trial follow(const Solid& solid, const Ray& ray) {
    RayQuery query;
    query.mask = seen_by_trace;
    query.ray = ray;
    constexpr size_t most = 1000;
    std::vector<double> t;
    for (Hit hit; t.size() < most && solid.world.geometry->closest(query, hit);) {
        t.push_back((t.empty() ? 0.0 : t.back()) + hit.t);
        query.ray.origin = hit.point;
        query.origin_leaf = hit.leaf;
        query.origin_error = hit.error;
        query.origin_part = hit.crossing.part;
    }
    if (t.size() == most) return {true, fmt::format("{}: does not end, {}", solid.name, described(ray))};
    return judge(solid.name, ShapeTruth(*solid.exact), ray, std::move(t));
}

/// Rays that once entered and did not leave.
struct Find {
    std::string_view solid;
    Ray ray;
};
constexpr std::array<Find, 15> finds{{
    // A root next to the end of a piece.
    {"lathe_4",
     {{1.8891655591404368, 0.11969064497713161, 3.8889636569248918},
      {-0.47229138978510921, 0.0062101512557170965, -0.88142060173122294}}},
    // Out through the tip.
    {"sor_2",
     {{3.1363865114646008, 1.7430288867507562, -1.0639083907482705},
      {-0.7840966278661502, -0.56075722168768904, 0.26597709768706762}}},
    // In next to a flat end on the axis.
    {"lathe_3",
     {{-2.8081364572889833, 1.4043563635394771, 2.6915083419191941},
      {0.70275627241413863, -0.22624016872213326, -0.6744990790499017}}},
    // Down the axis, out of one tip and into the other.
    {"lathe_4", {{0.0, 3.65, 0.0}, {0.0, -1.0, 0.0}}},
    // Through a piece into its joint with the next, whose root rounding put behind the end.
    {"lathe_2",
     {{-3.7880092062796069, -0.0004936952627344407, -0.84296620977377779},
      {0.98415954282494666, 0.00012342381568361017, 0.17728502202147217}}},
    // Along a face, flat to the last bits: the search for a root took no end.
    {"superellipsoid_2",
     {{-2.8985411388014297, 1.0, 2.7211600088133792},
      {0.73079520770858875, -2.0177433549941316e-31, -0.68259678023717674}}},
    // In by an edge: both faces that meet there took the ray for theirs.
    {"prism_2",
     {{0.78924235728372527, 2.7676479337845632, 3.2819923271396614},
      {-0.072310589320931304, -0.71488012764767972, -0.69549808178491535}}},
    // The same with curves on both sides of the edge.
    {"prism",
     {{-2.5353609996262261, 3.7374864182255978, 0.67302484756518188},
      {0.50884024990655652, -0.80937160455639945, -0.29325621189129547}}},
    {"prism_4",
     {{0.7498120980194739, 3.713179934266492, -1.4936735076790979},
      {-0.062453024504868483, -0.92555839119355154, 0.37341837691977448}}},
    // Along the surface: in and out by less than what rounding makes of its place.
    {"sphere_sweep_2",
     {{-1.4366462428364601, 3.9567613684849663, -0.22238302857101172},
      {0.38334027288898903, -0.92144318236865552, 0.063187790337375538}}},
    {"superellipsoid_4",
     {{0.34364261377760807, -2.7143119018084079, 2.7998577630188657},
      {-0.016272730900150186, 0.78619905587359007, -0.61775904912233126}}},
    {"superellipsoid_5",
     {{1.1299781649835769, -2.7788135274038321, 2.6424426985224563},
      {-0.33608860635292231, 0.57209161059526714, -0.74816818815441732}}},
    {"sphere_sweep_2",
     {{3.0340323231119064, -3.3465423306155087, -0.051051975916580228},
      {-0.61780122561705064, 0.78623591690989192, 0.012438994610969711}}},
    // Through a channel thinner than a step.
    {"julia_fractal",
     {{-3.336114830277753, 1.6077317859192188, 1.0183116576652416},
      {0.96266975112421549, -0.26494612714854826, -0.05541209235741066}}},
    // Through a rim thinner than a step.
    {"julia_fractal",
     {{-0.5295747554819743, 1.310960525074361, 3.9617581283026753},
      {0.45448441990550892, -0.34950608906272462, -0.81932252853881171}}},
}};

void once_lost(const std::vector<Solid>& solids, Table& table) {
    table.run_listed("once lost", finds.size(), [&](size_t i) -> Trial {
        const auto solid = std::ranges::find(solids, finds[i].solid, &Solid::name);
        if (solid == solids.end()) return {true, std::string(finds[i].solid) + ": no such solid"};
        Trial trial = all_crossings(solid->name, *solid->exact, ShapeTruth(*solid->exact), finds[i].ray);
        return trial.failure.empty() ? follow(*solid, finds[i].ray) : trial;
    });
}

void run(const Effort& effort, Table& table) {
    const std::vector<Solid> solids = make_solids();
    once_lost(solids, table);
    struct Kind {
        std::string_view name;
        Aim aim;
    };
    static constexpr std::array<Kind, 6> kinds{{{"anywhere", anywhere},
                                                {"along axes through round numbers", along_lattice},
                                                {"vertices", at_vertex},
                                                {"edges", at_edge},
                                                {"split planes", in_split_plane},
                                                {"silhouettes", at_silhouette}}};
    for (const Kind& kind : kinds) {
        const auto rays = [&](std::string_view form, double full, auto&& look) {
            table.run(fmt::format("{}, {}", form, kind.name), effort.of(full), [&](Dice& dice) {
                const Solid& solid = solids[dice.below(solids.size())];
                if (!effort.solid.empty() && solid.name != effort.solid) return Trial::nothing();
                Ray ray;
                if (!kind.aim(solid, dice, ray)) return Trial::nothing();
                return look(solid, ray);
            });
        };
        rays("exact", 6e6, [](const Solid& s, const Ray& ray) {
            return all_crossings(s.name, *s.exact, ShapeTruth(*s.exact), ray);
        });
        rays("facets", 8e6, [](const Solid& s, const Ray& ray) {
            if (!s.facets) return Trial::nothing();
            return all_crossings(s.name, *s.facets, FacetTruth(*s.facets), ray);
        });
        rays("hit to hit", 4e6, follow);
    }
}

}  // namespace

const Family leaks{"leaks", "Rays through closed shapes", run};

}  // namespace rb::stress
