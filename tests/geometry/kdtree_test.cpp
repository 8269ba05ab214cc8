// The tree against brute force with the same kernel: rays of four adversarial families, no difference, equal
// bits.
#include "base/parallel.h"
#include "kdtree/wide_walk.h"
#include "shapes/mesh_shape.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

#include <gtest/gtest.h>

namespace rb {
namespace {

/// Touching axis-parallel boxes, so that faces lie in split planes, and a sphere among them.
MeshData lattice_and_sphere() {
    MeshData data;
    auto& mesh = data.triangles;
    constexpr int side = 10;
    const auto quad = [&](const Vec3f& a, const Vec3f& b, const Vec3f& c, const Vec3f& d) {
        const auto first = static_cast<uint32_t>(mesh.vertices.size());
        mesh.vertices.insert(mesh.vertices.end(), {a, b, c, d});
        mesh.faces.push_back({first, first + 1, first + 2});
        mesh.faces.push_back({first, first + 2, first + 3});
    };
    for (int i = 0; i < side * side * side; ++i) {
        if (i % 3 == 1) continue;
        const Vec3f o{static_cast<float>(i % side), static_cast<float>(i / side % side),
                      static_cast<float>(i / side / side)};
        for (int axis = 0; axis < 3; ++axis) {
            Vec3f u{0}, v{0}, w{0};
            u[(axis + 1) % 3] = 1;
            v[(axis + 2) % 3] = 1;
            w[axis] = 1;
            quad(o, o + u, o + u + v, o + v);
            quad(o + w, o + w + u, o + w + u + v, o + w + v);
        }
    }
    constexpr int rings = 40;
    const auto first = static_cast<uint32_t>(mesh.vertices.size());
    for (int i = 0; i <= rings; ++i) {
        for (int j = 0; j < 2 * rings; ++j) {
            const double a = pi * i / rings, b = pi * j / rings;
            mesh.vertices.emplace_back(Vec3{5.3 + 2.7 * std::sin(a) * std::cos(b), 4.9 + 2.7 * std::cos(a),
                                            5.1 + 2.7 * std::sin(a) * std::sin(b)});
        }
    }
    for (uint32_t i = 0; i < rings; ++i) {
        for (uint32_t j = 0; j < 2 * rings; ++j) {
            const uint32_t p = first + i * 2 * rings + j, q = first + i * 2 * rings + (j + 1) % (2 * rings);
            mesh.faces.push_back({p, q + 2 * rings, q});
            mesh.faces.push_back({p, p + 2 * rings, q + 2 * rings});
        }
    }
    return data;
}

/// Long thin triangles, which the exact clipping acts on.
MeshData slivers() {
    MeshData data;
    std::mt19937 random(11);
    std::uniform_real_distribution<float> place(0, 10);
    std::normal_distribution<float> thin(0, 0.02f);
    for (uint32_t i = 0; i < 3000; ++i) {
        const Vec3f a{place(random), place(random), place(random)};
        const Vec3f b{place(random), place(random), place(random)};
        data.triangles.vertices.insert(data.triangles.vertices.end(),
                                       {a, b, a + Vec3f{thin(random), thin(random), thin(random)}});
        data.triangles.faces.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    }
    return data;
}

class Families {
public:
    explicit Families(const TriangleMesh& mesh) : mesh_(mesh) {}

    Ray ray(int family) {
        switch (family) {
            case 0:  // random
                return {point(), glm::normalize(Vec3{normal_(random_), normal_(random_), normal_(random_)})};
            case 1: {  // at vertices
                const Vec3 o = point();
                const auto i =
                    static_cast<size_t>(unit_(random_) * static_cast<double>(mesh_.vertices.size() - 1));
                return {o, glm::normalize(Vec3(mesh_.vertices[i]) - o + Vec3{1e-300})};
            }
            case 2: {  // in lattice planes, along axes
                Vec3 o = glm::floor(point());
                Vec3 d{0.0};
                d[static_cast<int>(unit_(random_) * 2.999)] = unit_(random_) < 0.5 ? -1.0 : 1.0;
                if (unit_(random_) < 0.5) d[static_cast<int>(unit_(random_) * 2.999)] = -0.0;
                if (d == Vec3{0.0}) d.y = 1.0;
                if (unit_(random_) < 0.5) o[static_cast<int>(unit_(random_) * 2.999)] += 0.37;
                return {o, d};
            }
            default: {  // 45 degrees through lattice edges
                const Vec3 o = glm::floor(point());
                Vec3 d{sign(), sign(), sign()};
                if (unit_(random_) < 0.6) d[static_cast<int>(unit_(random_) * 2.999)] = 0.0;
                return {o, glm::normalize(d)};
            }
        }
    }

private:
    Vec3 point() { return {12 * unit_(random_) - 1, 12 * unit_(random_) - 1, 12 * unit_(random_) - 1}; }
    double sign() { return unit_(random_) < 0.5 ? -1.0 : 1.0; }

    const TriangleMesh& mesh_;
    std::mt19937 random_{5};
    std::uniform_real_distribution<double> unit_{0, 1};
    std::normal_distribution<double> normal_;
};

void expect_equal(const MeshData& data, int rays, MeshSearch search) {
    const MeshShape tree("mesh2", data, search);
    const MeshShape brute("mesh2", data, MeshSearch::brute_force);
    EXPECT_LE(tree.tree().references().size(), 4 * data.triangles.faces.size() + 4096);
    Families families(data.triangles);
    for (int family = 0; family < 4; ++family) {
        int differences = 0;
        int any_differences = 0;
        int hits = 0;
        for (int i = 0; i < rays; ++i) {
            ShapeRay query{families.ray(family)};
            Crossing a, b, any;
            const bool hit = tree.closest(query, nullptr, a);
            const bool wanted = brute.closest(query, nullptr, b);
            hits += wanted ? 1 : 0;
            if (hit != wanted || (hit && (a.t != b.t || a.part != b.part || a.at != b.at))) ++differences;
            if (tree.any(query, nullptr, any) != wanted) ++differences;
            if (wanted) {
                // Shadow rays that end just before and at the hit.
                query.t_max = b.t;
                if (!tree.any(query, nullptr, any)) ++any_differences;
                query.t_max = std::nextafter(b.t, 0.0);
                if (tree.any(query, nullptr, any)) ++differences;
            }
        }
        EXPECT_EQ(differences, 0) << "family " << family;
        EXPECT_EQ(any_differences, 0) << "family " << family;
        EXPECT_GT(hits, rays / 20) << "family " << family;
    }
}

TEST(KdTree, LatticeAndSphereEqualBruteForce) {
    expect_equal(lattice_and_sphere(), 3000, MeshSearch::fastest);
    expect_equal(lattice_and_sphere(), 3000, MeshSearch::one_by_one);
}

TEST(KdTree, SliversEqualBruteForce) {
    expect_equal(slivers(), 3000, MeshSearch::fastest);
    expect_equal(slivers(), 3000, MeshSearch::one_by_one);
}

TEST(KdTree, RandomTreesGiveTheSameHits) {
    std::mt19937 random(3);
    std::uniform_real_distribution<float> place(0, 10);
    std::vector<BoxF> boxes;
    for (int i = 0; i < 400; ++i) {
        BoxF b{};
        for (int k = 0; k < 3; ++k) {
            b.lo[k] = i % 4 == 0 ? std::floor(place(random)) : place(random);
            b.hi[k] = b.lo[k] + (i % 5 == 0 ? 0.0f : 1.0f);
        }
        boxes.push_back(b);
    }
    const MeshData lattice = lattice_and_sphere();
    Families families(lattice.triangles);
    std::vector<Ray> rays;
    for (int i = 0; i < 2000; ++i) rays.push_back(families.ray(i % 4));
    // Every box that the ray meets must be offered.
    const auto meets = [](const BoxF& b, const Ray& ray) {
        double in = 0, out = 1e30;
        for (int k = 0; k < 3; ++k) {
            if (ray.direction[k] == 0.0) {
                if (ray.origin[k] < b.lo[k] || ray.origin[k] > b.hi[k]) return false;
                continue;
            }
            const double s = (b.lo[k] - ray.origin[k]) / ray.direction[k],
                         e = (b.hi[k] - ray.origin[k]) / ray.direction[k];
            in = std::max(in, std::min(s, e));
            out = std::min(out, std::max(s, e));
        }
        return in <= out;
    };
    size_t visited_by_one = 0;
    for (int trial = 0; trial < 20; ++trial) {
        KdOptions options;
        options.depth = trial * 3;
        options.traversal_cost = 0.05 * (1 + trial % 7);
        options.block = 1 + trial % 3;
        options.most_references = 1.0 + trial;
        const KdTree tree(boxes, options);
        for (const bool wide : {false, true}) {
            if (wide && !has_wide()) continue;
            int lost = 0;
            size_t visited = 0;
            for (const Ray& ray : rays) {
                std::vector<bool> offered(boxes.size());
                const double far = 1e30;
                const auto note = [&](const uint32_t* found, uint32_t count) {
                    visited += count;
                    for (uint32_t i = 0; i < count; ++i) offered[found[i]] = true;
                    return false;
                };
                wide ? tree.walk_wide(ray, 0.0, far, note) : tree.walk(ray, 0.0, far, note);
                for (size_t i = 0; i < boxes.size(); ++i) lost += meets(boxes[i], ray) && !offered[i] ? 1 : 0;
            }
            EXPECT_EQ(lost, 0) << "trial " << trial << (wide ? ", wide" : "");
            if (!wide) visited_by_one = visited;
            EXPECT_EQ(visited, visited_by_one) << "trial " << trial;
        }
    }
}

TEST(Mesh, WatertightAtVerticesAndEdges) {
    MeshData data = lattice_and_sphere();
    // Only the closed sphere, seen from inside.
    constexpr uint32_t rings = 40;
    const auto first = static_cast<uint32_t>(data.triangles.vertices.size()) - (rings + 1) * 2 * rings;
    std::erase_if(data.triangles.faces, [&](const auto& f) { return f[0] < first; });
    const MeshShape mesh("mesh2", data);
    std::mt19937 random(1);
    std::uniform_real_distribution<double> unit(0, 1);
    int missed = 0;
    for (int i = 0; i < 200000; ++i) {
        const Vec3 o = Vec3{5.3, 4.9, 5.1} + Vec3{unit(random) - .5, unit(random) - .5, unit(random) - .5};
        const auto& f = data.triangles.faces[static_cast<size_t>(
            unit(random) * static_cast<double>(data.triangles.faces.size() - 1))];
        const Vec3 a(data.triangles.vertices[f[0]]), b(data.triangles.vertices[f[1]]);
        const double s = i % 2 ? 0.0 : unit(random);
        Crossing c;
        missed += mesh.closest(ShapeRay{{o, a + s * (b - a) - o}}, nullptr, c) ? 0 : 1;
    }
    EXPECT_EQ(missed, 0);
}

TEST(KdTree, LeavesOutWhatIsNoBox) {
    constexpr float inf = std::numeric_limits<float>::infinity();
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    std::vector<BoxF> boxes(40, BoxF{{0, 0, 0}, {1, 1, 1}});
    boxes[3] = {{nan, 0, 0}, {nan, 1, 1}};
    boxes[5] = {{0, nan, 0}, {1, 1, nan}};
    boxes[7] = {{-inf, 0, 0}, {inf, 1, 1}};
    boxes[9] = {{0, 0, 0}, {1, inf, 1}};
    const KdTree tree(boxes, {});
    const std::set<uint32_t> held(tree.references().begin(), tree.references().end());
    EXPECT_EQ(held.size(), 36u);
    EXPECT_TRUE(tree.bounds().is_finite());
}

/// As many that subtrees have threads of their own.
std::vector<BoxF> many_boxes() {
    std::mt19937 random(3);
    std::uniform_real_distribution<float> unit(0, 1);
    std::vector<BoxF> boxes(70000);
    for (BoxF& box : boxes) {
        for (int axis = 0; axis < 3; ++axis) {
            box.lo[axis] = 100.0f * unit(random);
            box.hi[axis] = box.lo[axis] + unit(random) * unit(random);
        }
    }
    return boxes;
}

TEST(KdTree, IsTheSameWithAnyNumberOfThreads) {
    const std::vector<BoxF> boxes = many_boxes();
    const KdTree many(boxes, {});
    const ThreadLimit limit(1);
    const KdTree one(boxes, {});
    EXPECT_EQ(one.node_count(), many.node_count());
    EXPECT_TRUE(std::ranges::equal(one.references(), many.references()));
}

TEST(KdTree, LargeOneMissesNothing) {
    const std::vector<BoxF> boxes = many_boxes();
    const KdTree tree(boxes, {});
    std::mt19937 random(4);
    std::uniform_real_distribution<double> unit(0, 1);
    const auto place = [&] { return 100.0 * Vec3{unit(random), unit(random), unit(random)}; };
    for (int i = 0; i < 20; ++i) {
        const Vec3 from = place();
        const Ray ray{from, glm::normalize(place() - from)};
        std::set<uint32_t> held;
        const double t_max = 1e9;
        tree.walk(ray, 0.0, t_max, [&](const uint32_t* elements, uint32_t count) {
            held.insert(elements, elements + count);
            return false;
        });
        for (uint32_t k = 0; k < boxes.size(); ++k) {
            double near = 0.0;
            double far = t_max;
            for (int axis = 0; axis < 3; ++axis) {
                const double a = (static_cast<double>(boxes[k].lo[axis]) - from[axis]) / ray.direction[axis];
                const double b = (static_cast<double>(boxes[k].hi[axis]) - from[axis]) / ray.direction[axis];
                near = std::max(near, std::min(a, b));
                far = std::min(far, std::max(a, b));
            }
            EXPECT_TRUE(near >= far || held.contains(k)) << k;
        }
    }
}

}  // namespace
}  // namespace rb
