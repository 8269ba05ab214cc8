#pragma once
#include "math/bounds.h"
#include "scene/object.h"

#include <optional>

namespace rb {

/// What the language asks geometry while a scene is being read. The application plugs it in, so that the
/// front end does not depend on the renderer.
class GeometryOracle {
public:
    struct Hit {
        Vec3 point{0.0};
        Vec3 normal{0.0};
    };

    virtual ~GeometryOracle() = default;
    /// The first crossing of the ray with the object; `direction` need not have unit length.
    virtual std::optional<Hit> trace(const ObjectPtr& object, const Vec3& origin, const Vec3& direction) = 0;
    virtual bool inside(const ObjectPtr& object, const Vec3& point) = 0;
    virtual Bounds extent(const ObjectPtr& object) = 0;
    /// False for surfaces without an inside, for which inside() is an error.
    virtual bool has_inside(const ObjectPtr& object) = 0;
    /// `object { ... }` as a pattern: 1 inside, 0 outside; must be safe for several threads. Null: not
    /// available.
    virtual PatternPtr object_pattern(const ObjectPtr&) { return nullptr; }
};

}  // namespace rb
