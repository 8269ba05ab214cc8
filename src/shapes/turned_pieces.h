#pragma once
#include "math/range_tree.h"
#include "math/vec.h"
#include "shapes/curve_contact.h"

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

namespace rb {

/// One piece of a curve that is turned about the y axis: for w in [0,1] the height y(w) and the squared
/// radius s(w), highest power first.
struct TurnedPiece {
    std::array<double, 4> y{};
    std::array<double, 7> s{};
    int degree = 6;               ///< of what a ray makes of it: the larger of 2 deg y and deg s
    bool squares_radius = false;  ///< s is the square of a polynomial: on the axis it has a double zero
    Vec2 start;                   ///< radius and height of the ends
    Vec2 end;

    Vec2 at(double w) const;  ///< radius and height
    double height(double w) const;
    double squared_radius(double w) const;
    Vec2 slope(double w) const;  ///< derivatives of half the squared radius and of the height
};

/// A line seen from the axis. Its squared distance from the axis at height y is
/// (across (y - y_near)^2) / dy^2 + nearest, or across (t - t_near)^2 + nearest.
struct TurnedLine {
    Vec3 o;
    Vec3 d;
    double across = 0;
    double t_near = 0;
    double y_near = 0;
    double nearest = 0;
    double t_per_height = 0;
    double dd = 0;       ///< square of d.y
    bool level = false;  ///< so nearly level that the height says little about t
    bool steep = false;  ///< the height tells t well

    void look_from_axis();  ///< sets the rest from o and d
    /// Negative where the line at height y is nearer to the axis than the squared radius `s`.
    double side(double y, double s) const {
        const double up = y - y_near;
        return across * up * up + dd * (nearest - s);
    }
    double side(const Vec2& p) const { return side(p.y, p.x * p.x); }
    /// Where it meets the circle of a piece's point, if it does.
    double t_at(const TurnedPiece& piece, double w) const;
};

/// The pieces of a turned curve in a row, with boxes over ranges of them.
class TurnedPieces {
public:
    TurnedPieces() = default;
    explicit TurnedPieces(std::vector<TurnedPiece> pieces);

    const std::vector<TurnedPiece>& all() const { return pieces_; }

    using Contact = CurveContact;
    /// The point of the curve (radius, height) nearest to a point, if it is nearer than `within`; else the
    /// distance is `within`.
    Contact nearest(const Vec2& p, double within) const;
    Contact nearest_on(uint32_t piece, const Vec2& p) const;

    struct Hit {
        double t = 0;
        double w = 0;
    };
    /// The line's hits with a piece. `own`: the parameter where it starts on this piece, left out; else
    /// negative. A line that starts where two pieces meet starts on both.
    int cross(const TurnedLine& line, uint32_t piece, double own, std::array<Hit, 12>& hits) const;

    /// Calls take(piece) for those that the line may meet between t_min and `reach()`.
    template <class Reach, class Take>
    void visit(const TurnedLine& line, double t_min, Reach&& reach, Take&& take) const {
        tree_.visit([&](const Box& box) { return box.may_meet(line, t_min, reach()); }, take);
    }

private:
    class Box {
    public:
        Box() = default;
        /// From radius and height to radius and height.
        Box(const Vec2& lo, const Vec2& hi);
        void include(const Box& other) { *this = {glm::min(lo_, other.lo_), glm::max(hi_, other.hi_)}; }
        bool may_meet(const TurnedLine& line, double t_min, double t_max) const;
        double distance(const Vec2& p) const {
            return glm::length(glm::max(glm::max(lo_ - p, p - hi_), Vec2{0.0}));
        }

    private:
        Vec2 lo_{0.0};
        Vec2 hi_{0.0};
        double middle_ = 0;  ///< height
        double half_ = 0;    ///< height, or a little more
        double inner_ = 0;   ///< squared radii
        double outer_ = 0;
    };
    static constexpr size_t sample_count = 17;

    static Box box_of(const TurnedPiece& piece);
    Contact settle(uint32_t piece, const Vec2& p, double w, const Vec2& at) const;
    static Hit settled(const TurnedLine& line, const TurnedPiece& piece, const Hit& hit);
    int cross_level(const TurnedLine& line, uint32_t piece, double own, std::array<Hit, 12>& hits) const;

    std::vector<TurnedPiece> pieces_;
    std::vector<std::array<Vec2, sample_count>> samples_;
    RangeTree<Box> tree_;
};

}  // namespace rb
