#pragma once
#include "math/vec.h"

#include <array>
#include <cmath>
#include <memory>
#include <optional>

namespace rb {

/// An affine map in the scene language's row convention: p' = x*row[0] + y*row[1] + z*row[2] + row[3].
struct Affine {
    std::array<Vec3, 4> row{Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}, Vec3{0, 0, 0}};

    Vec3 point(const Vec3& p) const { return p.x * row[0] + p.y * row[1] + p.z * row[2] + row[3]; }
    Vec3 direction(const Vec3& d) const { return d.x * row[0] + d.y * row[1] + d.z * row[2]; }
    /// Product with the transposed 3x3 part: what a normal needs, given the *inverse* map. Not normalised.
    Vec3 transposed_direction(const Vec3& n) const {
        return {glm::dot(row[0], n), glm::dot(row[1], n), glm::dot(row[2], n)};
    }
    friend bool operator==(const Affine&, const Affine&) = default;
};

/// First `a`, then `b`.
Affine then(const Affine& a, const Affine& b);

/// How much an affine map can stretch a length: a bound (Frobenius norm of the 3x3 part).
inline double stretch(const Affine& map) {
    return std::sqrt(glm::dot(map.row[0], map.row[0]) + glm::dot(map.row[1], map.row[1]) +
                     glm::dot(map.row[2], map.row[2]));
}

/// Empty if the 3x3 part is singular.
std::optional<Affine> inverse_of(const Affine& a);

/// An affine map together with its inverse, as the language's transformations build it. Named `to_from`:
/// `world_from_object.point(p)` takes an object point to the world.
struct Transform {
    Affine forward;
    Affine backward;

    Vec3 point(const Vec3& p) const { return forward.point(p); }
    Vec3 direction(const Vec3& d) const { return forward.direction(d); }
    /// A surface normal carried along (inverse transpose); not normalised.
    Vec3 normal(const Vec3& n) const { return backward.transposed_direction(n); }
    Vec3 inverse_point(const Vec3& p) const { return backward.point(p); }
    Vec3 inverse_direction(const Vec3& d) const { return backward.direction(d); }
    Vec3 inverse_normal(const Vec3& n) const { return forward.transposed_direction(n); }

    bool is_identity() const { return forward == Affine{}; }
    Transform inverse() const { return {backward, forward}; }
    friend bool operator==(const Transform&, const Transform&) = default;

    static Transform translation(const Vec3& offset);
    /// Factors must not be 0 (the language replaces 0 by 1 with a warning before it gets here).
    static Transform scaling(const Vec3& factors);
    /// Degrees about x, then y, then z (manual 3.3.1.12.1: left-handed rotation).
    static Transform rotation_deg(const Vec3& degrees);
    /// Empty if the matrix is singular.
    static std::optional<Transform> from_matrix(const Affine& matrix);
};

/// A transform in the size of a pointer, for what there are many of: the identity takes no memory, copies
/// share.
class SharedTransform {
public:
    SharedTransform() = default;
    SharedTransform(const Transform& map);

    operator const Transform&() const { return map_ ? *map_ : identity; }
    const Transform* operator->() const { return map_ ? map_.get() : &identity; }
    Vec3 point(const Vec3& p) const { return (*this)->point(p); }
    Vec3 inverse_point(const Vec3& p) const { return (*this)->inverse_point(p); }
    Vec3 inverse_direction(const Vec3& d) const { return (*this)->inverse_direction(d); }
    bool is_identity() const { return !map_ || map_->is_identity(); }
    friend bool operator==(const SharedTransform& a, const SharedTransform& b) {
        return a.map_ == b.map_ || *a.operator->() == *b.operator->();
    }

private:
    static const Transform identity;

    std::shared_ptr<const Transform> map_;
};

/// The same for an affine map.
class SharedAffine {
public:
    SharedAffine() = default;
    SharedAffine(const Affine& map) : map_(std::make_shared<const Affine>(map)) {}

    operator const Affine&() const { return map_ ? *map_ : identity; }
    const Affine* operator->() const { return map_ ? map_.get() : &identity; }
    Vec3 point(const Vec3& p) const { return (*this)->point(p); }
    Vec3 direction(const Vec3& d) const { return (*this)->direction(d); }
    Vec3 transposed_direction(const Vec3& n) const { return (*this)->transposed_direction(n); }

private:
    static const Affine identity;

    std::shared_ptr<const Affine> map_;
};

/// First `a`, then `b`: `scale 2 translate x` is then(scaling(2), translation(x)).
Transform then(const Transform& a, const Transform& b);

}  // namespace rb
