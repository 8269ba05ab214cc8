#pragma once
#include "math/range_tree.h"
#include "scene/shape.h"
#include "shapes/sweep_piece.h"

namespace rb {

/// The union of all balls along a curve. The part of a crossing is the piece, at.x the place w on it.
///
/// A ball meets a ray from a - sqrt(D) to a + sqrt(D), where a is the centre's place along the ray and D the
/// squared radius less the centre's squared distance from the ray. Within each range of w where D >= 0 these
/// ways overlap; their union runs from the least a - sqrt(D) to the largest a + sqrt(D), both at ends of the
/// range or where D'^2 = 4 a'^2 D. So a ray always leaves what it enters, and nothing inside is seen.
class SphereSweep final : public Shape {
public:
    /// `extent` is what min_extent and max_extent say.
    SphereSweep(std::vector<SweepPiece> pieces, const Bounds& extent);

    std::string_view keyword() const override { return "sphere_sweep"; }
    Bounds bounds() const override { return bounds_; }
    Bounds language_extent() const override { return extent_; }
    bool inside(const Vec3& p) const override;
    void crossings(const ShapeRay& ray, Crossings& out) const override;
    bool any(const ShapeRay& ray, const CrossingFilter* filter, Crossing& found) const override;
    Vec3 normal(const Vec3& p, const Crossing& at) const override;
    ShapePtr transformed(const Transform& map) const override;
    std::optional<TriangleMesh> tessellate(double tolerance) const override;
    std::string describe() const override;

private:
    struct Start;
    std::optional<Start> start_of(const ShapeRay& ray) const;
    bool is_rounding(const Way& way, const Start& start, bool leaves, const ShapeRay& ray) const;
    double way_through(const Start& start, const RayFrame& frame) const;

    /// Calls take(range) for the parts of pieces, as long as possible, that lie in bounds which `meets`
    /// accepts.
    template <class Meets, class Take>
    void each_range(Meets&& meets, Take&& take) const;
    /// The same for those that the ray may meet between t_min and t_max.
    template <class Take>
    void each_range_on(const ShapeRay& ray, double length, Take&& take) const;
    class Facets;
    /// The ball with the least power |p - c|^2 - r^2 of those that come within `reach` of a point.
    Ball deepest_ball(const Vec3& p, double reach) const;
    /// False if `p` is surely outside.
    bool may_hold(const Vec3& p) const;

    std::vector<SweepPiece> pieces_;
    std::vector<SweepRange> ranges_;  ///< the pieces in short parts
    RangeTree<SweepBound> tree_;
    Bounds bounds_;
    Bounds extent_;
};

template <class Meets, class Take>
void SphereSweep::each_range(Meets&& meets, Take&& take) const {
    SweepRange range{any_part, 0.0, 0.0};
    tree_.visit(meets, [&](uint32_t i) {
        const SweepRange& next = ranges_[i];
        if (next.piece == range.piece && next.lo == range.hi) {
            range.hi = next.hi;
            return;
        }
        if (range.piece != any_part) take(range);
        range = next;
    });
    if (range.piece != any_part) take(range);
}

}  // namespace rb
