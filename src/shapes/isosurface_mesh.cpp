#include "shapes/isosurface.h"

#include <algorithm>

namespace rb {

/// Of the one side of the container that the region meets; empty if it meets several.
std::optional<GradientBound> Isosurface::container_slopes(const Bounds& region) const {
    std::array<Interval, 3> slopes;
    if (data_.radius) {
        const Vec3 center = data_.box.center();
        for (int i = 0; i < 3; ++i)
            slopes[static_cast<size_t>(i)] = {region.lo[i] - center[i], region.hi[i] - center[i]};
        return GradientBound::of(slopes);
    }
    int sides = 0;
    for (int i = 0; i < 3; ++i) {
        const bool meets_low = region.lo[i] <= data_.box.lo[i];
        const bool meets_high = region.hi[i] >= data_.box.hi[i];
        sides += int{meets_low} + int{meets_high};
        if (meets_low || meets_high) slopes[static_cast<size_t>(i)] = meets_low ? -1.0 : 1.0;
    }
    if (sides != 1) return std::nullopt;
    return GradientBound::of(slopes);
}

std::optional<GradientBound> Isosurface::slopes(const Bounds& region) const {
    const auto farthest = [&] {
        const Vec3 center = data_.box.center();
        return glm::length(glm::max(glm::abs(region.lo - center), glm::abs(region.hi - center)));
    };
    const bool is_within = data_.radius ? farthest() < *data_.radius
                                        : glm::all(glm::greaterThan(region.lo, data_.box.lo)) &&
                                              glm::all(glm::lessThan(region.hi, data_.box.hi));
    if (!is_within) {
        const Interval value = data_.bound(region);
        if (!value.maybe_nan && value.hi < 0.0) return container_slopes(region);
        return std::nullopt;
    }
    std::array<Interval, 3> slopes;
    for (int axis = 0; axis < 3; ++axis) {
        slopes[static_cast<size_t>(axis)] =
            data_.function->bound_slope(FunctionCells::along(axis, region), 0).slope;
    }
    return GradientBound::of(slopes);
}

std::optional<TriangleMesh> Isosurface::tessellate(double tolerance) const {
    if (data_.open) return std::nullopt;
    return solid_mesh(*this, bounds_, tolerance);
}

}  // namespace rb
