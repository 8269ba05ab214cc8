#pragma once
#include "math/range_tree.h"
#include "math/roots.h"
#include "math/vec.h"
#include "shapes/curve_contact.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace rb {

/// A piece of a plane curve as a Bezier curve of degree 1, 2 or 3: control[0] is its start, control[degree]
/// its end.
struct CurvePiece {
    std::array<Vec2, 4> control{};
    int degree = 1;

    const Vec2& start() const { return control[0]; }
    const Vec2& end() const { return control[static_cast<size_t>(degree)]; }
    Vec2 at(double w) const;
    Vec2 slope(double w) const;  ///< derivative by w
    /// Power coefficients of a function that takes the values `b` at the control points, highest first,
    /// filled with leading zeros.
    static std::array<double, 4> powers(const std::array<double, 4>& b, int degree);
};

/// The rules by which the language joins points to a curve (manual 3.5.1.6, 3.5.1.9).
enum class OutlineSpline { linear, quadratic, cubic, bezier };

/// One piece of a spline from the points at and around it: linear p[0] p[1], quadratic p[0..2] from p[1] to
/// p[2], cubic (Catmull-Rom) p[0..3] from p[1] to p[2], bezier p[0..3].
CurvePiece spline_piece(OutlineSpline kind, const Vec2* p);

/// The line a x + b y + c = 0 in a plane.
struct PlaneLine {
    double a = 0;
    double b = 0;
    double c = 0;
    double side(const Vec2& p) const { return a * p.x + b * p.y + c; }
};

/// A box in a plane.
struct FlatBox {
    Vec2 lo{std::numeric_limits<double>::infinity()};
    Vec2 hi{-std::numeric_limits<double>::infinity()};

    void include(const Vec2& p) {
        lo = glm::min(lo, p);
        hi = glm::max(hi, p);
    }
    void include(const FlatBox& box) {
        lo = glm::min(lo, box.lo);
        hi = glm::max(hi, box.hi);
    }
    double distance(const Vec2& p) const {
        return glm::length(glm::max(glm::max(lo - p, p - hi), Vec2{0.0}));
    }
    bool overlaps(const FlatBox& box) const {
        return lo.x <= box.hi.x && lo.y <= box.hi.y && box.lo.x <= hi.x && box.lo.y <= hi.y;
    }
};

/// A box by its middle and half its size, larger than what it was made of by more than rounding errors: where
/// a line is tested against many boxes, each test takes few steps.
struct CenteredBox {
    Vec2 center{0.0};
    Vec2 half{0.0};

    CenteredBox() = default;
    explicit CenteredBox(const FlatBox& box)
        : center(0.5 * (box.lo + box.hi)), half(0.5 * (box.hi - box.lo)) {
        constexpr double rounding = 2e-14;
        half += rounding * glm::max(glm::abs(box.lo), glm::abs(box.hi));
    }
    void include(const CenteredBox& box) {
        FlatBox both{center - half, center + half};
        both.include(FlatBox{box.center - box.half, box.center + box.half});
        *this = CenteredBox(both);
    }
    /// Not more than that to the points inside.
    double distance(const Vec2& p) const {
        return glm::length(glm::max(glm::abs(p - center) - half, Vec2{0.0}));
    }

    /// True only for boxes that the line passes by.
    class Misses {
    public:
        explicit Misses(const PlaneLine& line)
            : line_(line), a_(std::abs(line.a)), b_(std::abs(line.b)), margin_(rounding * std::abs(line.c)) {}
        bool operator()(const CenteredBox& box) const {
            return std::abs(line_.side(box.center)) > a_ * box.half.x + b_ * box.half.y + margin_;
        }

    private:
        static constexpr double rounding = 1e-14;
        PlaneLine line_;
        double a_, b_, margin_;
    };
};

/// A region of the plane: what closed curves enclose by the even-odd rule. The pieces of a curve follow each
/// other, and where one ends the next begins with the same numbers.
class Outline {
public:
    Outline() = default;
    explicit Outline(std::vector<CurvePiece> pieces);

    const std::vector<CurvePiece>& pieces() const { return pieces_; }
    const Vec2& lo() const { return box_.lo; }  ///< tight box
    const Vec2& hi() const { return box_.hi; }
    const FlatBox& box() const { return box_; }

    using Contact = CurveContact;
    /// The point of the curves that is nearest to `p`, if it is nearer than `within`; else distance is
    /// `within`.
    Contact nearest(const Vec2& p, double within = std::numeric_limits<double>::infinity()) const;
    Contact nearest_on(uint32_t piece, const Vec2& p) const;

    /// Hands the line's crossings with the curves to sink(piece, w), an even number together with the
    /// `contact`, which is left out (may be null).
    template <class Sink>
    void crossings(const PlaneLine& line, const Contact* contact, Sink&& sink) const {
        const CenteredBox::Misses misses(line);
        if (misses(reach_)) return;
        // A line that runs along a straight edge meets the region, but not one along y (as measured).
        const bool touch_counts = line.b != 0.0;
        const bool zero_is_negative = (line.side(0.5 * (lo() + hi())) >= 0.0) == touch_counts;
        const auto take = [&](uint32_t i) {
            const bool here = contact && contact->piece == i;
            if (!here && !may_cross(line, zero_is_negative, pieces_[i])) return;
            std::array<double, 3> w;
            const int n = roots(line, zero_is_negative, i, here ? contact : nullptr, w);
            for (int k = 0; k < n; ++k) sink(i, w[static_cast<size_t>(k)]);
        };
        // The control points of a few pieces tell sooner than boxes around them.
        constexpr size_t few = 8;
        if (pieces_.size() <= few) {
            for (uint32_t i = 0; i < pieces_.size(); ++i) take(i);
        } else {
            tree_.visit([&](const CenteredBox& box) { return !misses(box); }, take);
        }
    }

    /// Points on the boundary belong to the region on the side of smaller x (spec: geometry 13.4).
    bool contains(const Vec2& p) const;

    /// Closed polygons within `tolerance` of the curves.
    std::vector<std::vector<Vec2>> flattened(double tolerance) const;

private:
    static constexpr size_t sample_count = 17;

    /// The side of the line on which points on it count.
    static bool is_negative(double side, bool zero_is_negative) {
        return side < 0.0 || (side == 0.0 && zero_is_negative);
    }
    /// A Bezier curve lies in the hull of its control points: no crossing if all are on one side.
    static bool may_cross(const PlaneLine& line, bool zero_is_negative, const CurvePiece& piece) {
        const bool first = is_negative(line.side(piece.control[0]), zero_is_negative);
        for (int i = 1; i <= piece.degree; ++i) {
            if (is_negative(line.side(piece.control[static_cast<size_t>(i)]), zero_is_negative) != first)
                return true;
        }
        return false;
    }
    /// For a piece that the line may cross, or that has the contact.
    int roots(const PlaneLine& line, bool zero_is_negative, uint32_t piece, const Contact* contact,
              std::array<double, 3>& w) const;

    std::vector<CurvePiece> pieces_;
    std::vector<std::array<Vec2, sample_count>> samples_;  ///< empty if all pieces are straight
    RangeTree<CenteredBox> tree_;
    FlatBox box_{Vec2{0.0}, Vec2{0.0}};
    CenteredBox reach_;  ///< the same
};

}  // namespace rb
