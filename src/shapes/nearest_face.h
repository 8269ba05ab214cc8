#pragma once
#include "scene/shape.h"
#include "shapes/woop.h"

namespace rb {

/// Shape::closest() of a shape made of numbered triangles. `each(t_max, take)` calls take(face, hit) for
/// those that the ray may meet up to `t_max`, which shrinks meanwhile.
template <class Each>
bool nearest_face(const ShapeRay& ray, const CrossingFilter* filter, Crossing& nearest, Each&& each) {
    double best = ray.t_max;
    bool found = false;
    each(best, [&](uint32_t face, const TriangleHit& hit) {
        // At a shared edge the later face is seen.
        if (found && hit.t == best && face <= nearest.part) return false;
        const Crossing crossing{hit.t, face, hit.at};
        if (filter && !filter->counts(crossing)) return false;
        nearest = crossing;
        best = hit.t;
        found = true;
        return false;
    });
    return found;
}

}  // namespace rb
