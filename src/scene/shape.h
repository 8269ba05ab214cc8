#pragma once
#include "base/source.h"
#include "math/bounds.h"
#include "math/ray.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

namespace rb {

/// One crossing of a ray with a shape's surface, in the shape's own terms.
struct Crossing {
    double t = 0;       ///< ray parameter
    uint32_t part = 0;  ///< face, side or segment: what the shape needs to find normal and uv again
    Vec2 at{0.0};       ///< parameters on that part (barycentric for triangles); meaning belongs to the shape
};

/// The crossings that one call of Shape::crossings found, in any order. Holds the usual few without the heap.
class Crossings {
public:
    void clear() { size_ = 0; }
    void add(const Crossing& c) {
        if (size_ < inline_capacity) {
            first_[size_] = c;
        } else {
            rest_.resize(size_ - inline_capacity);
            rest_.push_back(c);
        }
        ++size_;
    }
    size_t size() const { return size_; }
    const Crossing& operator[](size_t i) const {
        return i < inline_capacity ? first_[i] : rest_[i - inline_capacity];
    }

private:
    static constexpr size_t inline_capacity = 6;
    size_t size_ = 0;
    Crossing first_[inline_capacity];
    std::vector<Crossing> rest_;
};

/// A triangle mesh: what tessellation makes, and what mesh and mesh2 are made of. Vertices are single
/// precision, as in the reference.
struct TriangleMesh {
    std::vector<Vec3f> vertices;
    std::vector<Vec3f> normals;                  ///< unit, per corner through `normal_index`; may be empty
    std::vector<std::array<uint32_t, 3>> faces;  ///< indices into `vertices`
    std::vector<std::array<uint32_t, 3>>
        face_normals;  ///< indices into `normals`, parallel to `faces`, or empty
    double error = 0;  ///< proven bound on the distance of any mesh point to the true surface
};

/// Geometry in its own space, immutable and shared by all its copies. See docs/architecture.md, "Shapes".
class Shape {
public:
    virtual ~Shape() = default;

    /// The keyword in the scene language.
    virtual std::string_view keyword() const = 0;

    /// A box around the surface; infinite for a plane.
    virtual Bounds bounds() const = 0;

    /// True if `p` belongs to the solid; always false for a patch (a surface without an inside).
    virtual bool inside(const Vec3& p) const = 0;
    virtual bool is_patch() const { return false; }

    /// Adds all crossings with t in [t_min, t_max]. With `starts_on_surface` the origin lies on this very
    /// surface (up to rounding) and the crossing at the origin is left out by the shape, whatever its
    /// computed t.
    virtual void crossings(const Ray& ray, double t_min, double t_max, bool starts_on_surface,
                           Crossings& out) const = 0;

    /// The outward normal at a crossing; not necessarily unit length.
    virtual Vec3 normal(const Vec3& p, const Crossing& at) const = 0;

    /// Surface coordinates for uv_mapping; empty where the language uses x and y of the world point instead.
    virtual std::optional<Vec2> uv(const Vec3& p, const Crossing& at) const;

    /// The same shape moved, if the shape can take the map into its own numbers (a sphere under a uniform
    /// scale); otherwise null, and the caller keeps the transform beside the shape.
    virtual std::shared_ptr<const Shape> transformed(const Transform& map) const;

    /// A mesh within `tolerance` (object units) of the surface; empty for a shape that has no finite surface.
    virtual std::optional<TriangleMesh> tessellate(double tolerance) const = 0;

    /// One line per argument for `--dump scene`.
    virtual std::string describe() const = 0;
};

using ShapePtr = std::shared_ptr<const Shape>;

}  // namespace rb
