// The box tree, and lists made from it, against exact slab tests in double: no element whose box the ray
// meets may be missing.
#include "kdtree/box_list.h"

#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace rb {
namespace {

bool meets(const Ray& ray, const Bounds& box, double t_min, double t_max) {
    for (int axis = 0; axis < 3; ++axis) {
        const double o = ray.origin[axis];
        const double d = ray.direction[axis];
        if (d == 0.0) {
            if (o < box.lo[axis] || o > box.hi[axis]) return false;
            continue;
        }
        const double a = (box.lo[axis] - o) / d;
        const double b = (box.hi[axis] - o) / d;
        t_min = std::max(t_min, std::min(a, b));
        t_max = std::min(t_max, std::max(a, b));
    }
    return t_min <= t_max;
}

class BallTree {
public:
    explicit BallTree(double scale, const Vec3& place, int count) : scale_(scale), place_(place) {
        for (int i = 0; i < count; ++i) {
            // On a grid, so that faces coincide, and some without thickness.
            const Vec3 a{whole(), whole(), whole()};
            const Vec3 size{flat(), flat(), flat()};
            items_.push_back({{place + scale * a, place + scale * (a + size)}, mask()});
        }
        tree_ = BoxTree(items_);
    }

    void shoot(int rays) {
        for (int i = 0; i < rays; ++i) {
            Ray ray{place_ + scale_ * Vec3{whole(), whole(), whole()}, Vec3{step(), step(), step()}};
            if (i % 3 == 0) ray.origin += scale_ * Vec3{unit(), unit(), unit()};
            if (i % 5 == 0) ray.origin -= 1000.0 * scale_ * ray.direction;
            if (i % 2 == 0) ray.direction += Vec3{unit(), 1e-12 * unit(), 1e-40 * unit()};
            if (ray.direction == Vec3{0.0}) continue;
            ray.direction *= i % 7 == 0 ? 1e-5 : scale_;
            check(ray, mask(), i % 4 == 0 ? 0.5 : 0.0, i % 4 == 1 ? 3.0 : 1e300);
        }
    }

    /// Bundles of a few rays: what the list of a bundle finds for a ray must be what the tree finds. Returns
    /// how many lists were short enough.
    int shoot_bundles(int bundles) {
        int listed = 0;
        for (int i = 0; i < bundles; ++i) {
            const Vec3 from = place_ + scale_ * Vec3{whole(), whole(), whole()};
            const Vec3 way = Vec3{step(), step(), step()} + 0.1 * Vec3{unit(), unit(), unit()};
            const double spread = i % 4 == 0 ? 0.0 : 0.2 * std::abs(unit());
            const bool segments = i % 2 == 0;
            const double far = segments ? 1.0 : 1e300;
            std::vector<Ray> rays;
            Bounds origins;
            Bounds ends;
            for (int k = 0; k < 6; ++k) {
                const Vec3 shift = scale_ * spread * Vec3{unit(), unit(), unit()};
                const Vec3 turn = spread * Vec3{unit(), unit(), unit()};
                rays.push_back({from + shift, (segments ? 3.0 * scale_ : 1.0) * (way + turn)});
                origins.include(rays.back().origin);
                ends.include(segments ? rays.back().at(1.0) : rays.back().direction);
            }
            const auto bundle =
                segments ? RayBundle::between(origins, ends) : RayBundle::along(origins, ends);
            BoxList list;
            const uint8_t wanted = mask();
            if (!list.gather(tree_, bundle, wanted, BoxList::no_element)) continue;
            ++listed;
            BoxList again;
            again.gather(list, bundle, BoxList::no_element);
            for (const Ray& ray : rays) {
                check(list, ray, wanted, 0.0, far);
                check(again, ray, wanted, 0.0, far);
            }
        }
        return listed;
    }

private:
    void check(const Ray& ray, uint8_t wanted, double t_min, double t_max) const {
        check(tree_, ray, wanted, t_min, t_max);
    }

    template <class Boxes>
    void check(const Boxes& boxes, const Ray& ray, uint8_t wanted, double t_min, double t_max) const {
        if (ray.direction == Vec3{0.0}) return;
        std::vector<bool> seen(items_.size(), false);
        boxes.walk(ray, wanted, t_min, t_max, [&](uint32_t element) {
            const uint32_t item = tree_.order()[element];
            EXPECT_FALSE(seen[item]);
            EXPECT_NE(items_[item].mask & wanted, 0);
            seen[item] = true;
            return false;
        });
        for (size_t i = 0; i < items_.size(); ++i) {
            if ((items_[i].mask & wanted) == 0 || !meets(ray, items_[i].box, t_min, t_max)) continue;
            ASSERT_TRUE(seen[i]) << "box " << i;
        }
    }

    double whole() { return static_cast<double>(random_() % 9u); }
    double flat() { return static_cast<double>(random_() % 3u); }
    double step() { return static_cast<double>(random_() % 5u) - 2.0; }
    double unit() { return std::uniform_real_distribution<double>(-1, 1)(random_); }
    uint8_t mask() { return static_cast<uint8_t>(1u + random_() % 7u); }

    double scale_;
    Vec3 place_;
    std::mt19937 random_{7};
    std::vector<BoxTree::Item> items_;
    BoxTree tree_;
};

TEST(BoxTree, MissesNoBox) {
    for (const double scale : {1e-30, 1e-6, 1.0, 0.3, 1e6, 1e20}) {
        for (const int count : {1, 2, 5, 40, 700}) {
            BallTree(scale, scale * Vec3{0.1, -7.7, 1e4}, count).shoot(2000);
            BallTree(scale, Vec3{0.0}, count).shoot(2000);
        }
    }
}

TEST(BoxList, MissesNoBox) {
    int listed = 0;
    for (const double scale : {1e-30, 1e-6, 1.0, 0.3, 1e6, 1e20}) {
        for (const int count : {1, 2, 5, 40, 700}) {
            listed += BallTree(scale, scale * Vec3{0.1, -7.7, 1e4}, count).shoot_bundles(2000);
            listed += BallTree(scale, Vec3{0.0}, count).shoot_bundles(2000);
        }
    }
    EXPECT_GT(listed, 10000);
}

TEST(RayBundle, MissesAPlaneOnlyIfAllItsRaysDo) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> unit(-1, 1);
    const auto vector = [&] { return Vec3{unit(random), unit(random), unit(random)}; };
    int missed = 0;
    for (int i = 0; i < 20000; ++i) {
        const Vec3 normal = i % 3 == 0 ? Vec3{0, 1, 0} : glm::normalize(vector());
        const double distance = i % 5 == 0 ? 0.0 : unit(random);
        Bounds origins;
        Bounds ends;
        std::vector<Ray> rays;
        const Vec3 from = 2.0 * vector();
        const Vec3 way = vector();
        for (int k = 0; k < 4; ++k) {
            rays.push_back({from + 0.1 * vector(), way + 0.1 * vector()});
            origins.include(rays.back().origin);
            ends.include(i % 2 ? rays.back().direction : rays.back().at(1.0));
        }
        const auto bundle = i % 2 ? RayBundle::along(origins, ends) : RayBundle::between(origins, ends);
        if (!bundle.misses_plane(normal, distance)) continue;
        ++missed;
        for (const Ray& ray : rays) {
            const double t = (distance - glm::dot(normal, ray.origin)) / glm::dot(normal, ray.direction);
            EXPECT_FALSE(t > 0.0 && t <= bundle.far);
        }
    }
    EXPECT_GT(missed, 5000);
}

TEST(BoxTree, ManyEqualBoxes) {
    const std::vector<BoxTree::Item> items(5000, {{Vec3{0.0}, Vec3{1.0}}, 1});
    const BoxTree tree(items);
    int count = 0;
    double t_max = 1e300;
    const auto visit = [&](uint32_t) { return ++count == 4000; };
    EXPECT_TRUE(tree.walk({{0.5, 0.5, -1}, {0, 0, 1}}, 1, 0.0, t_max, visit));
    count = 0;
    const auto nearer = [&](uint32_t) {
        t_max = 0.5;
        ++count;
        return false;
    };
    EXPECT_FALSE(tree.walk({{0.5, 0.5, -1}, {0, 0, 1}}, 1, 0.0, t_max, nearer));
    EXPECT_EQ(count, 1);
}

}  // namespace
}  // namespace rb
