#include "app/geometry_oracle.h"

#include "patterns/object_pattern.h"

namespace rb {

std::optional<GeometryOracle::Hit> ProbeOracle::trace(const ObjectPtr& object, const Vec3& origin,
                                                      const Vec3& direction) {
    const auto traced = probe_.trace(object, origin, direction);
    if (!traced) return std::nullopt;
    return Hit{traced->point, traced->normal};
}

bool ProbeOracle::inside(const ObjectPtr& object, const Vec3& point) { return probe_.inside(object, point); }

Bounds ProbeOracle::extent(const ObjectPtr& object) { return probe_.extent(object); }

bool ProbeOracle::has_inside(const ObjectPtr& object) { return ObjectProbe::has_inside(*object); }

PatternPtr ProbeOracle::object_pattern(const ObjectPtr& object) {
    // The pattern is asked from many threads: its probe is prepared here, and only read afterwards.
    auto probe = std::make_shared<ObjectProbe>(diagnostics_);
    probe->inside(object, Vec3{0.0});
    return rb::object_pattern([probe, object](const Vec3& p) { return probe->inside(object, p); });
}

}  // namespace rb
