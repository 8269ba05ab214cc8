#include "shapes/container.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace rb {

bool Container::holds(const Vec3& p, double margin) const {
    if (radius) return glm::length(p - box.center()) <= *radius - margin;
    return Bounds{box.lo + margin, box.hi - margin}.contains(p);
}

bool Container::clip(const Ray& ray, double& from, double& to) const {
    const Vec3& d = ray.direction;
    const Vec3& o = ray.origin;
    if (radius) {
        const double dd = glm::dot(d, d);
        const double middle = -glm::dot(o - box.center(), d) / dd;
        const Vec3 foot = o + middle * d - box.center();
        const double chord = *radius * *radius - glm::dot(foot, foot);
        if (!(chord > 0.0)) return false;
        const double half = std::sqrt(chord / dd);
        from = std::max(from, middle - half);
        to = std::min(to, middle + half);
        return from < to;
    }
    for (int i = 0; i < 3; ++i) {
        if (d[i] == 0.0) {
            if (o[i] < box.lo[i] || o[i] > box.hi[i]) return false;
            continue;
        }
        const double a = (box.lo[i] - o[i]) / d[i];
        const double b = (box.hi[i] - o[i]) / d[i];
        from = std::max(from, std::min(a, b));
        to = std::min(to, std::max(a, b));
    }
    return from < to;
}

Container take_container(BlockReader& outer) {
    Container container;
    BlockReader in(outer.block("contained_by"), outer.context());
    if (in.at_block("box")) {
        BlockReader box(in.block("box"), in.context());
        const Vec3 a = box.vec3();
        const Vec3 b = box.vec3();
        box.finish();
        container.box = {glm::min(a, b), glm::max(a, b)};
    } else if (in.at_block("sphere")) {
        BlockReader sphere(in.block("sphere"), in.context());
        const Vec3 center = sphere.vec3();
        container.radius = std::abs(sphere.number());
        sphere.finish();
        container.box = {center - *container.radius, center + *container.radius};
    } else {
        in.fail(fmt::format("Expected 'box or sphere', {} found instead", in.found()));
    }
    in.finish();
    return container;
}

}  // namespace rb
