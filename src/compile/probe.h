#pragma once
#include "base/diagnostics.h"
#include "scene/object.h"

#include <memory>
#include <optional>
#include <unordered_map>

namespace rb {

/// What the language's trace() found.
struct Traced {
    Vec3 point{0.0};
    Vec3 normal{0.0};  ///< unit, outward; not turned towards the ray
};

/// Answers trace(), inside(), min_extent() and max_extent() on objects of the scene being read (spec:
/// geometry 7), with the geometry that the renderer uses. Objects are prepared once, at their first question;
/// not for several threads at once.
class ObjectProbe {
public:
    /// Objects asked about that do not work yet are reported.
    explicit ObjectProbe(Diagnostics& diagnostics);
    ~ObjectProbe();

    /// The nearest hit farther than the language's 1e-4 along `direction` (any length but 0).
    std::optional<Traced> trace(const ObjectPtr& object, const Vec3& origin, const Vec3& direction);
    bool inside(const ObjectPtr& object, const Vec3& p);
    /// The box that the language reports: single precision, -1e10..1e10 where infinite.
    Bounds extent(const ObjectPtr& object);
    /// False for triangles, meshes without inside_vector and other surfaces without inside: inside() is an
    /// error.
    static bool has_inside(const Object& object);

private:
    struct Prepared;
    const Prepared& prepare(const ObjectPtr& object);

    Diagnostics& diagnostics_;
    std::unordered_map<const Object*, std::unique_ptr<Prepared>> prepared_;
};

}  // namespace rb
