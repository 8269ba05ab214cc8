#pragma once
#include "base/source.h"
#include "math/bounds.h"
#include "math/ray.h"
#include "scene/texture.h"

#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rb {

constexpr uint32_t any_part = std::numeric_limits<uint32_t>::max();

/// One crossing of a ray with a shape's surface, in the shape's own terms.
struct Crossing {
    constexpr Crossing() = default;
    constexpr Crossing(double t_, uint32_t part_, const Vec2& at_) : t(t_), part(part_), at(at_) {}

    double t = 0;         ///< ray parameter
    uint32_t part = 0;    ///< face, side or segment: what the shape needs to find normal and uv again
    uint32_t member = 0;  ///< which surface of a compound that is met as one shape; `part` and `at` are its
    Vec2 at{0.0};  ///< parameters on that part (barycentric for triangles); meaning belongs to the shape
};

/// A ray's question to one shape, in the shape's space: which crossings have t_min < t <= t_max? `t_min` is
/// never negative. Where a ray starts on a surface, its own crossing there is no answer, whatever its
/// computed t: a shape leaves out a crossing at the origin if the origin is within `origin_error` of that
/// part of its surface, and with `starts_on_surface` the one at the part nearest to the origin in any case.
struct ShapeRay {
    const Ray& ray;
    double t_min = 0;
    double t_max = std::numeric_limits<double>::infinity();
    double origin_error = 0;          ///< shape units; 0 for rays that start in free space
    bool starts_on_surface = false;   ///< the origin lies on this very shape
    uint32_t origin_part = any_part;  ///< the part it lies on, where known
};

/// Decides whether a crossing counts (CSG, clips); asked only for crossings that would be taken otherwise.
class CrossingFilter {
public:
    virtual bool counts(const Crossing& crossing) const = 0;

protected:
    ~CrossingFilter() = default;
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

/// TextureWeight::texture where the object's own texture shows.
constexpr uint32_t own_texture = std::numeric_limits<uint32_t>::max();

/// One of several textures that a point wears at once.
struct TextureWeight {
    uint32_t texture = own_texture;
    float weight = 1;
};

/// From where to where something reaches along a direction; unbounded as it is.
struct Extent {
    double lo = -std::numeric_limits<double>::infinity();
    double hi = std::numeric_limits<double>::infinity();

    static constexpr Extent nothing() {
        return {std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    }
};

/// How a surface bends. From a flat one no ray comes back to it; from a convex one none that leaves outward.
enum class Curvature { any, convex, flat };

/// What the language makes a shape's normals of, where they are not exactly those of its surface.
enum class NormalRule {
    of_surface,      ///< pointing out of the solid
    by_point_order,  ///< of the surface, in or out after the order of the points
    interpolated,    ///< between given ones
    differences,     ///< differences of a function over a finite step
    of_iterate       ///< of a surface near by
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

    /// What the language's min_extent() and max_extent() start from: looser than bounds() for some shapes.
    virtual Bounds language_extent() const { return bounds(); }

    /// A box around `inside`; everything() where the solid is larger than its surface (a disc's half-space).
    virtual Bounds solid_bounds() const { return bounds(); }

    /// Boxes around what the surface, and what the solid, has in `region`: of some infinite shapes a slab
    /// leaves a finite part.
    virtual Bounds bounds_within(const Bounds& region) const { return intersection(bounds(), region); }
    virtual Bounds solid_bounds_within(const Bounds& region) const {
        return intersection(solid_bounds(), region);
    }

    /// Holds dot(direction, p) for all points of the surface, and of the solid.
    virtual Extent extent(const Vec3& direction) const;
    /// True if extent() tells more than the box.
    virtual bool has_tight_extent() const { return false; }

    /// Adds all crossings.
    virtual void crossings(const ShapeRay& ray, Crossings& out) const = 0;

    /// The nearest crossing that passes `filter` (may be null); of several at the same t the last one found.
    virtual bool closest(const ShapeRay& ray, const CrossingFilter* filter, Crossing& nearest) const;

    /// True if there is a crossing that passes `filter`; `found` is then any one of them, its t perhaps
    /// rough.
    virtual bool any(const ShapeRay& ray, const CrossingFilter* filter, Crossing& found) const {
        return closest(ray, filter, found);
    }

    /// Moves a computed point of the crossing exactly onto the surface where numbers allow (axis-parallel
    /// faces), so that coincident faces of other solids see a point on their boundary.
    virtual void snap(const Crossing&, Vec3&) const {}

    /// The outward normal at a crossing; not necessarily unit length.
    virtual Vec3 normal(const Vec3& p, const Crossing& at) const = 0;

    /// Surface coordinates for uv_mapping; empty where the language uses x and y of the world point instead.
    virtual std::optional<Vec2> uv(const Vec3& p, const Crossing& at) const;

    /// The same shape moved, if the shape can take the map into its own numbers (a sphere under a uniform
    /// scale); otherwise null, and the caller keeps the transform beside the shape.
    virtual std::shared_ptr<const Shape> transformed(const Transform& map) const;

    /// Does once what queries would otherwise do first (a tree of its own). Safe to call from many threads.
    virtual void prepare() const {}

    /// The complement, if the shape has one of its own kind (plane, quadric); otherwise null, and the caller
    /// turns normals and inside.
    virtual std::shared_ptr<const Shape> inverted() const { return nullptr; }

    /// Textures that parts of the surface bring along (meshes, blobs); what textures_at() indexes.
    virtual std::span<const TexturePtr> textures() const { return {}; }
    /// Adds indices into textures() and weights (sum 1) at a crossing; nothing where the object's own texture
    /// shows alone.
    virtual void textures_at(const Vec3& /*p*/, const Crossing&, std::vector<TextureWeight>&) const {}

    virtual Curvature curvature() const { return Curvature::any; }
    /// True if the surface is all of the boundary of a convex solid.
    virtual bool is_convex_body() const { return false; }
    virtual NormalRule normal_rule() const { return NormalRule::of_surface; }

    /// True if crossings cost so much that it pays to cut a ray to the box where they count before asking.
    virtual bool is_costly() const { return false; }
    /// True for a sphere: the ball in the middle of its box holds it.
    virtual bool fills_ball() const { return false; }

    /// True for a plane; gives its unit normal and distance, so that rays that leave it behind are dropped
    /// early.
    virtual bool as_plane(Vec3& /*normal*/, double& /*distance*/) const { return false; }

    /// True if the surface consists of triangles already, so that tessellating it changes nothing.
    virtual bool is_faceted() const { return false; }

    /// A mesh within `tolerance` (object units) of the surface; empty for a shape that has no finite surface,
    /// or none that is proven to be near enough: such a shape is always met exactly.
    virtual std::optional<TriangleMesh> tessellate(double tolerance) const = 0;

    /// One line per argument for `--dump scene`.
    virtual std::string describe() const = 0;
};

using ShapePtr = std::shared_ptr<const Shape>;

}  // namespace rb
