#pragma once
#include "math/transform.h"
#include "scene/shape.h"
#include "shapes/outline.h"
#include "shapes/ray_shape.h"

#include <memory>

namespace rb {

/// One piece of a curve that is turned about the y axis: for w in [0,1] the height y(w) and the squared
/// radius s(w), highest power first.
struct TurnedPiece {
    std::array<double, 4> y{};
    std::array<double, 7> s{};
    int degree = 6;  ///< of what a ray makes of it: the larger of 2 deg y and deg s
    Vec2 start;      ///< radius and height of the ends
    Vec2 end;

    Vec2 at(double w) const;     ///< radius and height
    Vec2 slope(double w) const;  ///< derivatives of half the squared radius and of the height
};

/// What lathe and sor share.
struct TurnedCurve {
    std::string_view keyword;
    std::vector<TurnedPiece> pieces;
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
    Bounds bounds() const override { return box_; }
    Bounds language_extent() const override;
    bool inside(const Vec3& p) const override;

    template <class Sink>
    void each_crossing(const ShapeRay& query, Sink&& sink) const {
        Line line;
        if (!set_up(query, line)) return;
        for (uint32_t i = 0; i < curve_->pieces.size(); ++i) {
            std::array<Hit, 12> hits;
            const int n = cross(line, i, hits);
            for (int k = 0; k < n; ++k) {
                const Hit& hit = hits[static_cast<size_t>(k)];
                sink(hit.t, i, Vec2{hit.w, 0.0});
            }
        }
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

    /// The ray in the frame. The squared distance from the axis at height y is (across (y - y_near)^2) / dy^2
    /// + nearest, or across (t - t_near)^2 + nearest.
    struct Line {
        Vec3 o;
        Vec3 d;
        double across = 0;
        double t_near = 0;
        double y_near = 0;
        double nearest = 0;
        bool level = false;    ///< so nearly level that the height says little about t
        uint32_t part = none;  ///< where it starts
        double w = 0;
    };
    struct Hit {
        double t = 0;
        double w = 0;
    };

    uint32_t base_cap() const { return static_cast<uint32_t>(curve_->pieces.size()); }
    const Vec2& cap_rim(uint32_t cap) const {
        return cap == base_cap() ? curve_->pieces.front().start : curve_->pieces.back().end;
    }
    bool set_up(const ShapeRay& query, Line& line) const;
    void put_on_part(const ShapeRay& query, Line& line) const;
    double nearest_part(const Vec3& o, Line& line) const;
    double nearest_on(const TurnedPiece& piece, const Vec2& p, double& w) const;
    double parameter_at(const Vec3& local, const Crossing& at) const;
    int cross(const Line& line, uint32_t piece, std::array<Hit, 12>& hits) const;
    int cross_level(const Line& line, uint32_t piece, std::array<Hit, 12>& hits) const;
    bool meets_cap(const Line& line, uint32_t cap, double& t) const;
    /// Negative where the line at the height of the point `p` of the curve is nearer to the axis than p.
    double side(const Line& line, const Vec2& p) const {
        const double up = p.y - line.y_near;
        return line.across * up * up + line.d.y * line.d.y * (line.nearest - p.x * p.x);
    }
    double t_at(const Line& line, const Vec2& p) const;

    std::shared_ptr<const TurnedCurve> curve_;
    Transform object_from_local_;
    Bounds box_;
    double local_stretch_;
};

}  // namespace rb
