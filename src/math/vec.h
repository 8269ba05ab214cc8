#pragma once
#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace rb {

/// Space is left-handed as in the scene language: with the default camera x is right, y is up, z goes into
/// the picture.
using Vec2 = glm::dvec2;
using Vec3 = glm::dvec3;
using Vec3f = glm::vec3;

inline constexpr double pi = 3.14159265358979323846;
inline constexpr double infinity = std::numeric_limits<double>::infinity();

inline double max_component(const Vec3& v) {
    return v.x > v.y ? (v.x > v.z ? v.x : v.z) : (v.y > v.z ? v.y : v.z);
}
inline double largest_magnitude(const Vec3& v) { return max_component(glm::abs(v)); }
inline double min_component(const Vec3& v) {
    return v.x < v.y ? (v.x < v.z ? v.x : v.z) : (v.y < v.z ? v.y : v.z);
}

}  // namespace rb
