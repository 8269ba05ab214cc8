#include "patterns/warps.h"

#include "base/scratch.h"
#include "patterns/formula.h"
#include "patterns/noise.h"
#include "patterns/noise_tables.h"

#include <algorithm>

namespace rb {

namespace {

double scaled_by_distance(double a, double distance, double exponent) {
    if (exponent == 0.0) return a;
    if (exponent == 1.0) return a * distance;
    return a * std::pow(distance, exponent);
}

Vec3 oriented(const Vec3& o, const Vec3& q) {
    if (o == Vec3{0.0, 0.0, 1.0}) return q;
    const double u = q.x;
    const double v = q.y;
    const double w = q.z;
    return {o.x * w + o.y * u + o.z * u, o.x * v - o.y * w + o.z * v, -o.x * u + o.y * v + o.z * w};
}

Vec3 warped(const Transform& map, const Vec3& q) { return map.inverse_point(q); }

Vec3 warped(const RepeatWarp& warp, Vec3 q) {
    const double width = warp.width;
    double& along = q[warp.axis];
    const double block = std::floor(along / width);
    along -= block * width;
    if (std::fmod(block, 2.0) != 0.0) {
        q *= warp.flip;
        if (warp.flip[warp.axis] < 0.0) along += width;
    }
    return q + block * warp.offset;
}

Vec3 warped(const BlackHoleWarp& hole, const Vec3& q) {
    if (!hole.acts) return q;
    Vec3 center = hole.center;
    if (hole.repeat != Vec3{0.0}) {
        Vec3 block{0.0};
        for (int axis = 0; axis < 3; ++axis) {
            if (hole.repeat[axis] >= tiny) block[axis] = std::floor(q[axis] / hole.repeat[axis]);
        }
        if (hole.turbulence != Vec3{0.0}) {
            const UniformTable& random = uniform_table();
            const uint32_t s =
                hash3(static_cast<uint32_t>(truncated(block.x)), static_cast<uint32_t>(truncated(block.y)),
                      static_cast<uint32_t>(truncated(block.z)));
            center += Vec3{random[s], random[s + 1], random[s + 2]} * hole.turbulence;
        }
        center += hole.repeat * block;
    }
    const Vec3 away = q - center;
    const double distance = glm::length(away);
    if (distance >= hole.radius) return q;
    const double k =
        std::min(1.0, std::pow((hole.radius - distance) / hole.radius, hole.falloff) * hole.strength);
    return hole.inverse ? q - k * away : q + k * away;
}

Vec3 warped(const MappingWarp& warp, const Vec3& q) {
    constexpr double whole = 2.0 * pi;
    const double e = warp.dist_exp;
    switch (warp.kind) {
        case Mapping::cylindrical: {
            const double d = std::sqrt(q.x * q.x + q.z * q.z);
            if (d == 0.0) return q;
            return oriented(warp.orientation, {scaled_by_distance(turn(q.x, q.z) / whole, d, e), q.y, d});
        }
        case Mapping::spherical: {
            const double d = glm::length(q);
            if (d == 0.0) return q;
            const double around = q.x == 0.0 && q.z == 0.0 ? 0.0 : turn(q.x, q.z);
            return oriented(
                warp.orientation,
                {scaled_by_distance(around / whole, d, e),
                 scaled_by_distance(0.5 + std::asin(std::clamp(q.y / d, -1.0, 1.0)) / pi, d, e), d});
        }
        case Mapping::toroidal: {
            if (q.x == 0.0 && q.z == 0.0) return q;
            const double x = std::sqrt(q.x * q.x + q.z * q.z) - warp.major_radius;
            const double d = std::sqrt(x * x + q.y * q.y);
            double around = d == 0.0 ? 0.0 : std::acos(std::clamp(-x / d, -1.0, 1.0));
            if (q.y > 0.0) around = whole - around;
            return oriented(warp.orientation, {scaled_by_distance(turn(q.x, q.z) / whole, d, e),
                                               scaled_by_distance(around / whole, d, e), d});
        }
        case Mapping::planar:
            return oriented(warp.orientation, {q.x, q.y, warp.offset});
    }
    return q;
}

/// The six faces of a cube, unfolded as a cross into the unit square.
Vec3 warped(const CubicWarp&, const Vec3& q) {
    const double x = std::abs(q.x);
    const double y = std::abs(q.y);
    const double z = std::abs(q.z);
    constexpr double third = 1.0 / 3.0;
    const auto eighth = [](double a, double m) { return (a / m + 1.0) / 8.0; };
    const auto sixth = [](double a, double m) { return (a / m + 1.0) / 6.0; };
    if (q.x >= 0.0 && x >= y && x >= z) return {0.75 - eighth(q.z, x), third + sixth(q.y, x), x};
    if (q.y >= 0.0 && y >= x && y >= z) return {0.25 + eighth(q.x, y), 1.0 - sixth(q.z, y), y};
    if (q.z >= 0.0 && z >= x && z >= y) return {0.25 + eighth(q.x, z), third + sixth(q.y, z), z};
    if (q.x < 0.0 && x >= y && x >= z) return {eighth(q.z, x), third + sixth(q.y, x), x};
    if (q.y < 0.0 && y >= x && y >= z) return {0.25 + eighth(q.x, y), sixth(q.z, y), y};
    return {1.0 - eighth(q.x, z), third + sixth(q.y, z), z};
}

}  // namespace

void warp_points(const Warp& warp, std::span<Vec3> points) {
    if (const auto* shape = std::get_if<TurbulenceWarp>(&warp)) {
        Scratch::Scope memory(thread_scratch());
        const auto moves = memory.take<Vec3>(points.size());
        vector_turbulence(points, *shape, moves);
        for (size_t i = 0; i < points.size(); ++i) points[i] += moves[i] * shape->amount;
        return;
    }
    std::visit(
        [points](const auto& one) {
            if constexpr (!std::is_same_v<std::decay_t<decltype(one)>, TurbulenceWarp>) {
                for (Vec3& p : points) p = warped(one, p);
            }
        },
        warp);
}

void limit_coordinates(std::span<Vec3> points) {
    for (Vec3& p : points) p = glm::clamp(p, Vec3{-coordinate_limit}, Vec3{coordinate_limit});
}

}  // namespace rb
