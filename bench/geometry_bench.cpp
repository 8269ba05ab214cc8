// Rays per second of the geometry queries on scenes made here. Usage: geometry_bench [scene]
#include "block/reader.h"
#include "bumpy.h"
#include "compile/geometry.h"
#include "shapes/mesh_shape.h"
#include "shapes/registry.h"

#include <cmath>
#include <cstring>
#include <ctime>
#include <fstream>
#include <random>

#include <fmt/format.h>

namespace {

using namespace rb;

/// CPU seconds.
double seconds() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

std::string memory() {
    std::ifstream status("/proc/self/status");
    std::string rss;
    std::string peak;
    for (std::string line; std::getline(status, line);) {
        if (line.starts_with("VmRSS")) rss = line.substr(6);
        if (line.starts_with("VmHWM")) peak = line.substr(6);
    }
    return fmt::format("now{} peak{}", rss, peak);
}

/// Appends numbers of `terms` terms to a block, as the front end packs them.
void add_numbers(Block& block, int terms, const std::vector<double>& values) {
    Item item;
    item.kind = Item::Kind::numbers;
    item.terms = terms;
    item.first = static_cast<uint32_t>(block.numbers.size());
    item.count = static_cast<uint32_t>(values.size() / static_cast<size_t>(terms));
    block.items.push_back(item);
    block.numbers.insert(block.numbers.end(), values.begin(), values.end());
}

ShapePtr read_shape(const Block& block) {
    Diagnostics diagnostics;
    ReadContext context;
    context.diagnostics = &diagnostics;
    BlockReader in(block, context);
    return find_shape(block.keyword)->read(in);
}

ShapePtr simple(std::string_view keyword, std::initializer_list<std::vector<double>> arguments) {
    Block block;
    block.keyword = keyword;
    for (const auto& a : arguments) add_numbers(block, static_cast<int>(a.size()), a);
    return read_shape(block);
}

TexturePtr plain_texture() {
    Texture layer;
    layer.pigment = std::make_shared<Pigment>();
    layer.finish = std::make_shared<Finish>();
    return std::make_shared<TextureLayers>(TextureLayers{std::move(layer)});
}

class BenchScene {
public:
    BenchScene() { scene_.default_texture = plain_texture(); }
    void add(const ShapePtr& shape, const Transform& place = {}) {
        auto object = std::make_shared<Object>();
        object->geometry = shape;
        object->world_from_object = place;
        scene_.objects.push_back(std::move(object));
    }
    void add(Csg csg) {
        auto object = std::make_shared<Object>();
        object->geometry = std::move(csg);
        scene_.objects.push_back(std::move(object));
    }
    /// Five sides around everything, so that diffuse rays end.
    void add_room() {
        add(simple("plane", {{0, 1, 0}, {-2}}));
        add(simple("plane", {{0, -1, 0}, {-8}}));
        add(simple("plane", {{1, 0, 0}, {-8}}));
        add(simple("plane", {{-1, 0, 0}, {-8}}));
        add(simple("plane", {{0, 0, -1}, {-8}}));
    }
    World world() const {
        Diagnostics diagnostics;
        return compile(scene_, {}, diagnostics);
    }

private:
    Scene scene_;
};

struct Rays {
    std::vector<RayQuery> primary;
    std::vector<Hit> hits;
};

void report(std::string_view scene, std::string_view kind, size_t rays, double time, double share) {
    fmt::print("{:10} {:8} {:6.2f} Mray/s   ({:.0f} ns/ray, {:.0f} % hit)\n", scene, kind,
               static_cast<double>(rays) / time * 1e-6, time / static_cast<double>(rays) * 1e9, 100 * share);
}

void measure(std::string_view name, const World& world) {
    const Geometry& geometry = *world.geometry;
    constexpr int side = 800;
    std::vector<RayQuery> rays;
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            RayQuery q;
            q.ray = {{0.1, 0.3, -4},
                     glm::normalize(Vec3{(x + 0.5) / side - 0.5, 0.5 - (y + 0.5) / side, 1.0})};
            rays.push_back(q);
        }
    }
    std::vector<Hit> hits(rays.size());
    size_t hit_count = 0;
    double start = seconds();
    for (const RayQuery& q : rays) {
        if (geometry.closest(q, hits[hit_count])) ++hit_count;
    }
    report(name, "primary", rays.size(), seconds() - start,
           static_cast<double>(hit_count) / static_cast<double>(rays.size()));

    hits.resize(hit_count);

    std::mt19937 random(7);
    std::normal_distribution<double> normal;
    std::vector<RayQuery> diffuse;
    std::vector<RayQuery> shadow;
    for (const Hit& hit : hits) {
        RayQuery q;
        Vec3 n = hit.normal;
        if (n.z > 0.9) n = -n;
        q.ray = {hit.point,
                 glm::normalize(n + glm::normalize(Vec3{normal(random), normal(random), normal(random)}))};
        q.origin_leaf = hit.leaf;
        q.origin_error = hit.error;
        q.origin_part = hit.crossing.part;
        diffuse.push_back(q);
        const Vec3 to_light = Vec3{2, 6, -5} - hit.point;
        q.t_max = glm::length(to_light);
        q.ray.direction = to_light / q.t_max;
        q.mask = blocks_light;
        shadow.push_back(q);
    }
    start = seconds();
    size_t count = 0;
    for (const RayQuery& q : diffuse) {
        Hit hit;
        count += geometry.closest(q, hit) ? 1 : 0;
    }
    report(name, "diffuse", diffuse.size(), seconds() - start,
           static_cast<double>(count) / static_cast<double>(diffuse.size()));
    start = seconds();
    count = 0;
    uint32_t blocker = no_leaf;
    for (const RayQuery& q : shadow) count += geometry.occluded(q, blocker) ? 1 : 0;
    report(name, "shadow", shadow.size(), seconds() - start,
           static_cast<double>(count) / static_cast<double>(shadow.size()));
}

void million_triangles() {
    const double start = seconds();
    const auto mesh = std::make_shared<MeshShape>("mesh2", MeshData{.triangles = bumpy(1000000)});
    mesh->prepare();
    fmt::print("mesh2 of 1,000,000 triangles: made and tree {:.2f} s; {}; {}\n", seconds() - start,
               mesh->describe(), memory());
    fmt::print("{} nodes, {} references, {:.1f} MB\n", mesh->tree().node_count(),
               mesh->tree().references().size(), static_cast<double>(mesh->tree_memory()) * 1e-6);
    BenchScene scene;
    scene.add_room();
    scene.add(mesh);
    measure("bumpy", scene.world());
}

void spheres() {
    BenchScene scene;
    scene.add_room();
    std::mt19937 random(3);
    std::uniform_real_distribution<double> place(-1.8, 1.8);
    for (int i = 0; i < 1000; ++i) {
        scene.add(simple("sphere", {{place(random), place(random), place(random)},
                                    {0.03 + 0.02 * std::abs(place(random))}}));
    }
    const double start = seconds();
    const World world = scene.world();
    fmt::print("spheres compiled in {:.1f} ms\n", 1e3 * (seconds() - start));
    measure("spheres", world);
}

/// A hundred thousand small spheres: compile time.
void many() {
    BenchScene scene;
    scene.add_room();
    const ShapePtr ball = simple("sphere", {{0, 0, 0}, {0.01}});
    std::mt19937 random(3);
    std::uniform_real_distribution<double> place(-1.8, 1.8);
    for (int i = 0; i < 100000; ++i) {
        scene.add(ball, Transform::translation({place(random), place(random), place(random)}));
    }
    const std::string before = memory();
    const double start = seconds();
    const World world = scene.world();
    fmt::print("many: 100,000 spheres compiled in {:.2f} s; before: {}; after: {}\n", seconds() - start,
               before, memory());
    measure("many", world);
}

void boxes() {
    BenchScene scene;
    scene.add_room();
    std::mt19937 random(5);
    std::uniform_real_distribution<double> place(-1.8, 1.8);
    for (int i = 0; i < 1000; ++i) {
        const double s = 0.05;
        scene.add(
            simple("box", {{-s, -s, -s}, {s, s, s}}),
            then(i % 2 ? Transform::rotation_deg({place(random) * 90, place(random) * 90, 0}) : Transform{},
                 Transform::translation({place(random), place(random), place(random)})));
    }
    measure("boxes", scene.world());
}

/// The same hollow piece many times: difference and intersection at every hit.
void csg() {
    BenchScene scene;
    scene.add_room();
    std::mt19937 random(9);
    std::uniform_real_distribution<double> place(-1.8, 1.8);
    for (int i = 0; i < 300; ++i) {
        auto children = std::make_shared<std::vector<ObjectPtr>>();
        const Vec3 c{place(random), place(random), place(random)};
        const auto part = [&](const ShapePtr& shape) {
            auto object = std::make_shared<Object>();
            object->geometry = shape;
            object->world_from_object = Transform::translation(c);
            children->push_back(std::move(object));
        };
        part(simple("box", {{-.1, -.1, -.1}, {.1, .1, .1}}));
        part(simple("sphere", {{0, 0, 0}, {.12}}));
        part(simple("cylinder", {{0, -.2, 0}, {0, .2, 0}, {.04}}));
        Csg piece;
        piece.kind = CsgKind::difference;
        piece.children = std::move(children);
        scene.add(std::move(piece));
    }
    measure("csg", scene.world());
}

void few() {
    BenchScene scene;
    scene.add(simple("plane", {{0, 1, 0}, {-1}}));
    scene.add(simple("sphere", {{0, 0, 0}, {1}}));
    scene.add(simple("box", {{1, -1, -1}, {2, 1, 1}}));
    scene.add(simple("cylinder", {{-2, -1, 0}, {-2, 1, 0}, {.5}}));
    measure("few", scene.world());
}

}  // namespace

int main(int argc, char** argv) {
    const auto wanted = [&](const char* name) { return argc < 2 || std::strcmp(argv[1], name) == 0; };
    if (wanted("bumpy")) million_triangles();
    if (wanted("spheres")) spheres();
    if (wanted("many")) many();
    if (wanted("boxes")) boxes();
    if (wanted("csg")) csg();
    if (wanted("few")) few();
    return 0;
}
