#pragma once
#include "scene/shape.h"

#include <array>

namespace rb {

struct FlatGeometry;

/// Where crossings of a solid's leaf can count: between pairs of parallel planes, along the normals of the
/// planes that cut the solid. A turned solid has a wide box, which many rays meet that these leave out.
class Slabs {
public:
    static constexpr size_t most = 3;

    bool empty() const { return count_ == 0; }
    /// The points p with dot(normal, p) within `extent`. `size`: of the coordinates that they have.
    void add(const Vec3& normal, const Extent& extent, double size);
    /// True if no point of the ray between `t_min` and `t_max` lies in all of them.
    bool are_missed(const Ray& ray, double t_min, double t_max) const;

private:
    struct Slab {
        Vec3 normal{0.0};
        Extent extent;
    };
    std::array<Slab, most> slabs_;
    size_t count_ = 0;
};

/// Those of a leaf of solids; none where its box is as good.
Slabs slabs_of(const FlatGeometry& flat, uint32_t leaf);

/// The part of a leaf's box where its crossings can count, as far as shapes know more than their boxes.
Bounds tight_box(const FlatGeometry& flat, uint32_t leaf);

}  // namespace rb
