#pragma once
#include "compile/probe.h"
#include "language/oracle.h"

namespace rb {

/// Answers what the language asks of geometry with the renderer's own.
class ProbeOracle final : public GeometryOracle {
public:
    explicit ProbeOracle(Diagnostics& diagnostics) : diagnostics_(diagnostics), probe_(diagnostics) {}

    std::optional<Hit> trace(const ObjectPtr& object, const Vec3& origin, const Vec3& direction) override;
    bool inside(const ObjectPtr& object, const Vec3& point) override;
    Bounds extent(const ObjectPtr& object) override;
    bool has_inside(const ObjectPtr& object) override;
    PatternPtr object_pattern(const ObjectPtr& object) override;

private:
    Diagnostics& diagnostics_;
    ObjectProbe probe_;
};

}  // namespace rb
