#include "math/transform.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

namespace rb {

const Transform SharedTransform::identity{};
const Affine SharedAffine::identity{};

SharedTransform::SharedTransform(const Transform& map) {
    // Bit by bit: -0 is not the identity's 0.
    using Bits = std::array<uint64_t, sizeof map / sizeof(uint64_t)>;
    if (std::bit_cast<Bits>(map) != std::bit_cast<Bits>(identity))
        map_ = std::make_shared<const Transform>(map);
}

Affine then(const Affine& a, const Affine& b) {
    return {{b.direction(a.row[0]), b.direction(a.row[1]), b.direction(a.row[2]), b.point(a.row[3])}};
}

std::optional<Affine> inverse_of(const Affine& a) {
    const Vec3 c0 = glm::cross(a.row[1], a.row[2]);
    const Vec3 c1 = glm::cross(a.row[2], a.row[0]);
    const Vec3 c2 = glm::cross(a.row[0], a.row[1]);
    const double determinant = glm::dot(a.row[0], c0);
    if (determinant == 0.0 || !std::isfinite(1.0 / determinant)) return std::nullopt;
    const double s = 1.0 / determinant;
    Affine inverse{
        {s * Vec3{c0.x, c1.x, c2.x}, s * Vec3{c0.y, c1.y, c2.y}, s * Vec3{c0.z, c1.z, c2.z}, Vec3{0.0}}};
    inverse.row[3] = -inverse.direction(a.row[3]);
    return inverse;
}

Transform Transform::translation(const Vec3& offset) {
    Transform t;
    t.forward.row[3] = offset;
    t.backward.row[3] = -offset;
    return t;
}

Transform Transform::scaling(const Vec3& factors) {
    Transform t;
    for (int i = 0; i < 3; ++i) {
        t.forward.row[static_cast<size_t>(i)][i] = factors[i];
        t.backward.row[static_cast<size_t>(i)][i] = 1.0 / factors[i];
    }
    return t;
}

Transform Transform::rotation_deg(const Vec3& degrees) {
    const Vec3 radians = degrees * (pi / 180.0);
    Transform total;
    for (int axis = 0; axis < 3; ++axis) {
        if (degrees[axis] == 0.0) continue;
        const double c = std::cos(radians[axis]);
        const double s = std::sin(radians[axis]);
        const int u = (axis + 1) % 3;
        const int v = (axis + 2) % 3;
        Transform turn;
        auto& f = turn.forward.row;
        f[static_cast<size_t>(u)] = Vec3{0.0};
        f[static_cast<size_t>(v)] = Vec3{0.0};
        f[static_cast<size_t>(u)][u] = c;
        f[static_cast<size_t>(u)][v] = s;
        f[static_cast<size_t>(v)][u] = -s;
        f[static_cast<size_t>(v)][v] = c;
        // The inverse of a rotation is its transpose.
        for (size_t i = 0; i < 3; ++i) {
            for (int j = 0; j < 3; ++j) {
                turn.backward.row[i][j] = f[static_cast<size_t>(j)][static_cast<int>(i)];
            }
        }
        total = then(total, turn);
    }
    return total;
}

std::optional<Transform> Transform::from_matrix(const Affine& matrix) {
    const auto inverse = inverse_of(matrix);
    if (!inverse) return std::nullopt;
    return Transform{matrix, *inverse};
}

Transform then(const Transform& a, const Transform& b) {
    return {then(a.forward, b.forward), then(b.backward, a.backward)};
}

}  // namespace rb
