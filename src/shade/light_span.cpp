#include "shade/light_span.h"

#include <algorithm>
#include <cmath>

namespace rb {

namespace {

struct Part {
    double from = -infinity;
    double to = infinity;
};
using MaybePart = std::optional<Part>;

/// Where a t^2 + 2 b t + c is 0, in order.
MaybePart roots_of(double a, double b, double c) {
    const double square = b * b - a * c;
    if (square < 0.0 || a == 0.0) return std::nullopt;
    const double root = std::sqrt(square);
    const double q = b < 0.0 ? -b + root : -b - root;
    if (q == 0.0) return Part{0.0, 0.0};
    const double t1 = q / a;
    const double t2 = c / q;
    return Part{std::min(t1, t2), std::max(t1, t2)};
}

MaybePart in_cone(const Vec3& from_apex, const Vec3& axis, double angle, const Ray& ray) {
    const double cosine = std::cos(angle);
    if (cosine <= 0.0) return Part{};
    const double square = cosine * cosine;
    const double along = glm::dot(ray.direction, axis);
    const double start = glm::dot(from_apex, axis);
    const double a = along * along - square;
    const double b = start * along - square * glm::dot(from_apex, ray.direction);
    const double c = start * start - square * glm::dot(from_apex, from_apex);
    const auto roots = roots_of(a, b, c);
    // Between the roots the ray is inside the double cone if it is flatter than its sides, else outside.
    if (a < 0.0) {
        if (!roots || start + along * 0.5 * (roots->from + roots->to) <= 0.0) return std::nullopt;
        return roots;
    }
    if (!roots) return Part{};
    return along > 0.0 ? Part{roots->to, infinity} : Part{-infinity, roots->from};
}

MaybePart in_cylinder(const Vec3& from_light, const Vec3& axis, double radius, const Ray& ray) {
    const double along = glm::dot(ray.direction, axis);
    const double start = glm::dot(from_light, axis);
    const Vec3 d = ray.direction - along * axis;
    const Vec3 v = from_light - start * axis;
    const double c = glm::dot(v, v) - radius * radius;
    Part part;
    if (const auto roots = roots_of(glm::dot(d, d), glm::dot(v, d), c)) {
        part = *roots;
    } else if (c > 0.0) {
        return std::nullopt;
    }
    // In front of the light.
    if (along > 0.0) part.from = std::max(part.from, -start / along);
    if (along < 0.0) part.to = std::min(part.to, -start / along);
    if (along == 0.0 && start <= 0.0) return std::nullopt;
    return part;
}

}  // namespace

std::optional<LightSpan> lit_span(const Light& light, const Ray& ray, double length) {
    if (!light.media_interaction || light.kind == LightKind::shadowless) return std::nullopt;
    const Vec3 way = light.point_at - light.location;
    const double distance = glm::length(way);
    const Vec3 axis = distance > 0.0 ? way / distance : way;
    MaybePart part = Part{};
    if (light.kind == LightKind::spotlight) {
        part = in_cone(ray.origin - light.location, axis, light.falloff * (pi / 180.0), ray);
    } else if (light.kind == LightKind::cylinder) {
        part = in_cylinder(ray.origin - light.location, axis, light.falloff, ray);
    }
    if (!part || !(part->to > 0.0) || !(part->from < length)) return std::nullopt;
    return LightSpan{std::max(part->from, 0.0), std::min(part->to, length)};
}

void cut_by_light(std::span<const LightSpan> spans, double length, std::vector<MediaPiece>& pieces) {
    thread_local std::vector<double> starts;
    thread_local std::vector<double> ends;
    starts.clear();
    ends.clear();
    pieces.clear();
    for (const LightSpan& span : spans) {
        starts.push_back(span.from);
        ends.push_back(span.to);
    }
    std::ranges::sort(starts);
    std::ranges::sort(ends);
    double reached = 0;
    for (size_t i = 0; i < starts.size();) {
        const double from = starts[i];
        double to = ends[i];
        while (++i < starts.size() && starts[i] <= to) to = ends[i];
        if (from > reached) pieces.push_back({reached, from, false});
        pieces.push_back({from, to, true});
        reached = to;
    }
    if (reached < length || pieces.empty()) pieces.push_back({reached, length, false});
}

}  // namespace rb
