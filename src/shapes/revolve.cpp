#include "shapes/revolve.h"

#include "shapes/ray_shape.h"

#include <algorithm>
#include <cmath>

namespace rb {

namespace {

constexpr int fewest_segments = 8;
constexpr int most_segments = 2048;

int clamp_segments(double n) {
    return static_cast<int>(
        std::clamp(std::ceil(n), static_cast<double>(fewest_segments), static_cast<double>(most_segments)));
}

/// Bound on what rounding the vertices to single precision moves.
double rounding_of(const TriangleMesh& mesh) {
    float largest = 0.0f;
    for (const Vec3f& v : mesh.vertices) {
        largest = std::max({largest, std::abs(v.x), std::abs(v.y), std::abs(v.z)});
    }
    return 1.1e-7 * static_cast<double>(largest);
}

bool is_mirror(const Affine& map) { return glm::dot(map.row[0], glm::cross(map.row[1], map.row[2])) < 0.0; }

}  // namespace

int turn_segments(double radius, double tolerance) {
    if (!(radius > 0.0)) return fewest_segments;
    const double share = std::clamp(tolerance / radius, 1e-9, 1.0);
    return clamp_segments(pi / std::acos(1.0 - share));
}

TriangleMesh revolve(const std::vector<Vec2>& profile, bool closed_profile, int segments,
                     const Affine& place) {
    TriangleMesh mesh;
    const auto n = static_cast<uint32_t>(segments);
    std::vector<uint32_t> first;
    for (const Vec2& point : profile) {
        first.push_back(static_cast<uint32_t>(mesh.vertices.size()));
        const uint32_t copies = point.x == 0.0 ? 1 : n;
        for (uint32_t j = 0; j < copies; ++j) {
            const double angle = 2.0 * pi * j / n;
            mesh.vertices.emplace_back(
                place.point({point.x * std::cos(angle), point.x * std::sin(angle), point.y}));
        }
    }
    const bool mirror = is_mirror(place);
    const auto add = [&](uint32_t a, uint32_t b, uint32_t c) {
        if (a == b || b == c || c == a) return;
        mesh.faces.push_back(mirror ? std::array<uint32_t, 3>{a, c, b} : std::array<uint32_t, 3>{a, b, c});
    };
    const auto at = [&](size_t i, uint32_t j) { return first[i] + (profile[i].x == 0.0 ? 0 : j % n); };
    const size_t bands = closed_profile ? profile.size() : profile.size() - 1;
    for (size_t i = 0; i < bands; ++i) {
        const size_t up = (i + 1) % profile.size();
        for (uint32_t j = 0; j < n; ++j) {
            add(at(i, j), at(up, j + 1), at(i, j + 1));
            add(at(i, j), at(up, j), at(up, j + 1));
        }
    }
    mesh.error = rounding_of(mesh);
    return mesh;
}

TriangleMesh round_mesh(const Roundness& shape, const Affine& place) {
    const double R = shape.major;
    const double r = shape.minor;
    const double scale = stretch(place);
    const double s = std::max(shape.tolerance / scale, 1e-9 * (R + r));
    // Filip's bound for a right triangle a x b in (u, v): (a^2 Muu + 2ab Muv + b^2 Mvv) / 8 with Muu <= R +
    // r, Muv <= r, Mvv = r. Half of the tolerance for each direction, the mixed term is below their mean.
    const double step_u = std::sqrt(2.0 * s / (R + r));
    const double step_v = std::sqrt(2.0 * s / r);
    const int turns = clamp_segments(2.0 * pi / step_u);
    const bool sphere = R == 0.0;
    const int steps = clamp_segments((sphere ? pi : 2.0 * pi) / step_v);
    std::vector<Vec2> profile;
    const double sweep = (sphere ? pi : 2.0 * pi) / steps;
    for (int i = 0; i < (sphere ? steps + 1 : steps); ++i) {
        const double angle = -0.5 * pi + sweep * i;
        profile.emplace_back(R + r * std::cos(angle), r * std::sin(angle));
    }
    if (sphere) profile.front().x = profile.back().x = 0.0;
    TriangleMesh mesh = revolve(profile, !sphere, turns, place);
    const double a = 2.0 * pi / turns;
    mesh.error += scale * (a * a * (R + r) + 2.0 * a * sweep * r + sweep * sweep * r) / 8.0;
    return mesh;
}

}  // namespace rb
