// lathe { [linear_spline|quadratic_spline|cubic_spline|bezier_spline] n, <r,y>, ... }   (manual 3.5.1.7)
#include "shapes/registry.h"
#include "shapes/spline_words.h"
#include "shapes/turned_curve.h"

namespace rb {

namespace {

TurnedPiece turned(const CurvePiece& piece) {
    TurnedPiece out;
    std::array<double, 4> r{};
    std::array<double, 4> y{};
    for (size_t i = 0; i < 4; ++i) {
        r[i] = piece.control[i].x;
        y[i] = piece.control[i].y;
    }
    out.y = CurvePiece::powers(y, piece.degree);
    const auto x = CurvePiece::powers(r, piece.degree);
    for (size_t i = 0; i < 4; ++i) {
        for (size_t k = 0; k < 4; ++k) out.s[i + k] += x[i] * x[k];
    }
    out.degree = 2 * piece.degree;
    out.squares_radius = true;
    out.start = piece.start();
    out.end = piece.end();
    return out;
}

struct Rule {
    size_t least = 2;   ///< points
    size_t around = 2;  ///< points that make a piece
    size_t step = 1;
};
Rule rule_of(OutlineSpline kind) {
    switch (kind) {
        case OutlineSpline::linear:
            return {2, 2, 1};
        case OutlineSpline::quadratic:
            return {3, 3, 1};
        case OutlineSpline::cubic:
            return {4, 4, 1};
        case OutlineSpline::bezier:
            break;
    }
    return {4, 4, 4};
}

ShapePtr read(BlockReader& in) {
    OutlineSpline kind = OutlineSpline::linear;
    while (take_spline_kind(in, kind)) {
    }
    const Rule rule = rule_of(kind);
    const SourceRange at = in.where();
    const int count = in.integer();
    if (count < 0 || static_cast<size_t>(count) < rule.least ||
        (kind == OutlineSpline::bezier && count % 4 != 0))
        in.fail_at(at, "Lathe has too few points or incorrect number of points.");
    std::vector<double> values;
    in.numbers(static_cast<size_t>(count), 2, values);
    std::vector<Vec2> points;
    auto curve = std::make_shared<TurnedCurve>();
    curve->keyword = "lathe";
    for (size_t i = 0; i + 1 < values.size(); i += 2) {
        points.emplace_back(values[i], values[i + 1]);
        const bool inner = i > 0 && i + 2 < values.size();
        if (inner && values[i] < 0.0) in.fail("Incorrect point in lathe.");
    }
    std::vector<CurvePiece> pieces;
    for (size_t i = 0; i + rule.around <= points.size(); i += rule.step)
        pieces.push_back(spline_piece(kind, &points[i]));
    std::vector<TurnedPiece> turned_pieces;
    turned_pieces.reserve(pieces.size());
    for (const CurvePiece& piece : pieces) turned_pieces.push_back(turned(piece));
    curve->pieces = TurnedPieces(std::move(turned_pieces));
    curve->outline = Outline(std::move(pieces));
    curve->least_radius = std::max(curve->outline.lo().x, 0.0);
    if (kind == OutlineSpline::bezier) {
        // The language takes the control points' box for the curve's.
        for (const Vec2& p : points) {
            curve->least_radius = std::max(std::min(curve->least_radius, p.x), 0.0);
            curve->extent.include({p.x, p.y, p.x});
            curve->extent.include({-p.x, p.y, -p.x});
        }
    }
    return std::make_shared<TurnedShape>(std::move(curve), Transform{});
}

}  // namespace

namespace shapes {
extern const ShapeKind lathe;
const ShapeKind lathe{"lathe", read,
                      "lathe { cubic_spline 7, <0.2,-0.5>, <0,-0.5>, <0.5,-0.3>, <0.3,0.1>, <0.5,0.4>, "
                      "<0,0.5>, <0.2,0.5> }"};
}  // namespace shapes

}  // namespace rb
