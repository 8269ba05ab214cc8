#pragma once
#include "math/transform.h"
#include "scene/shape.h"
#include "shapes/outline.h"
#include "shapes/ray_shape.h"
#include "shapes/turned_pieces.h"

#include <memory>

namespace rb {

/// What lathe and sor share.
struct TurnedCurve {
    std::string_view keyword;
    TurnedPieces pieces;
    Outline outline;  ///< lathe: the curve over (radius, height), whose odd side is the inside; sor: empty
    double least_radius = 0;  ///< nothing is inside below it (language rule)
    bool caps = false;        ///< sor: discs at both ends
    Bounds extent;            ///< what min_extent and max_extent show; empty: the box
};

/// A curve turned about the y axis of its frame. Normals follow the order of the points.
class TurnedShape final : public RayShape<TurnedShape> {
public:
    TurnedShape(std::shared_ptr<const TurnedCurve> curve, const Transform& object_from_local);

    std::string_view keyword() const override { return curve_->keyword; }
    NormalRule normal_rule() const override {
        // The heights of a sor rise from point to point.
        return curve_->outline.pieces().empty() ? NormalRule::of_surface : NormalRule::by_point_order;
    }
    Bounds bounds() const override { return box_; }
    Bounds language_extent() const override;
    bool inside(const Vec3& p) const override;

    template <class Sink>
    void each_crossing(const ShapeRay& query, Sink&& sink) const {
        const Line line = set_up(query);
        const auto reach = [&] { return sink.reach(); };
        curve_->pieces.visit(line, query.t_min, reach, [&](uint32_t i) {
            std::array<TurnedPieces::Hit, 12> hits;
            const int n = curve_->pieces.cross(line, i, line.own(i), hits);
            for (int k = 0; k < n; ++k) {
                const TurnedPieces::Hit& hit = hits[static_cast<size_t>(k)];
                sink(hit.t, i, Vec2{hit.w, 0.0});
            }
        });
        if (!curve_->caps) return;
        for (const uint32_t cap : {base_cap(), base_cap() + 1}) {
            double t = 0;
            if (meets_cap(line, cap, t)) sink(t, cap, Vec2{0.0});
        }
    }

    Vec3 normal(const Vec3& p, const Crossing& at) const override;
    std::optional<Vec2> uv(const Vec3& p, const Crossing& at) const override;
    ShapePtr transformed(const Transform& map) const override {
        return std::make_shared<TurnedShape>(curve_, then(object_from_local_, map));
    }
    std::optional<TriangleMesh> tessellate(double tolerance) const override;
    std::string describe() const override;

private:
    static constexpr uint32_t none = std::numeric_limits<uint32_t>::max();

    /// The ray in the frame.
    struct Line : TurnedLine {
        uint32_t part = none;  ///< where it starts
        double w = 0;
        uint32_t neighbour = none;  ///< the piece that meets `part` at this end
        double own(uint32_t piece) const { return piece == part ? w : piece == neighbour ? 1.0 - w : -1.0; }
    };

    const std::vector<TurnedPiece>& pieces() const { return curve_->pieces.all(); }
    const TurnedPiece& piece(uint32_t part) const { return pieces()[part]; }
    uint32_t base_cap() const { return static_cast<uint32_t>(pieces().size()); }
    const Vec2& cap_rim(uint32_t cap) const {
        return cap == base_cap() ? pieces().front().start : pieces().back().end;
    }
    Line set_up(const ShapeRay& query) const;
    void put_on_part(const ShapeRay& query, Line& line) const;
    uint32_t neighbour(uint32_t part, double w) const;
    void put_on_nearest(double within, Line& line) const;
    double parameter_at(const Vec3& local, const Crossing& at) const;
    bool meets_cap(const Line& line, uint32_t cap, double& t) const;

    std::shared_ptr<const TurnedCurve> curve_;
    Transform object_from_local_;
    Bounds box_;
    double local_stretch_;
};

}  // namespace rb
