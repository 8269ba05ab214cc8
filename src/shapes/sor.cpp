// sor { n, <r,y>, ... [open] }   (manual 3.5.1.14)
#include "shapes/registry.h"
#include "shapes/turned_curve.h"

namespace rb {

namespace {

/// Between the second and third of four points the squared radius is a cubic in y, with slopes from the
/// points on both sides (spec: geometry 13.3).
TurnedPiece piece_between(const Vec2* p) {
    const double height = p[2].y - p[1].y;
    const double f0 = p[1].x * p[1].x;
    const double f1 = p[2].x * p[2].x;
    const double m0 = height * 2.0 * p[1].x * (p[2].x - p[0].x) / (p[2].y - p[0].y);
    const double m1 = height * 2.0 * p[2].x * (p[3].x - p[1].x) / (p[3].y - p[1].y);
    TurnedPiece out;
    out.y = {0.0, 0.0, height, p[1].y};
    out.s = {0.0, 0.0, 0.0, 2.0 * (f0 - f1) + m0 + m1, 3.0 * (f1 - f0) - 2.0 * m0 - m1, m0, f0};
    out.degree = 3;
    out.start = p[1];
    out.end = p[2];
    return out;
}

ShapePtr read(BlockReader& in) {
    const SourceRange at = in.where();
    const int count = in.integer();
    if (count < 4) in.fail_at(at, "Surface of revolution must have at least four points.");
    std::vector<double> values;
    in.numbers(static_cast<size_t>(count), 2, values);
    std::vector<Vec2> p;
    for (size_t i = 0; i + 1 < values.size(); i += 2) p.emplace_back(values[i], values[i + 1]);
    for (size_t i = 0; i < p.size(); ++i) {
        const bool inner = i >= 2 && i + 1 < p.size();
        if (p[i].x < 0.0 || (inner && p[i].y <= p[i - 1].y) || (i >= 2 && p[i].y == p[i - 2].y))
            in.fail("Incorrect point in surface of revolution.");
    }
    auto curve = std::make_shared<TurnedCurve>();
    curve->keyword = "sor";
    std::vector<TurnedPiece> pieces;
    for (size_t i = 0; i + 3 < p.size(); ++i) pieces.push_back(piece_between(&p[i]));
    curve->pieces = TurnedPieces(std::move(pieces));
    curve->caps = !in.take_word("open");
    return std::make_shared<TurnedShape>(std::move(curve), Transform{});
}

}  // namespace

namespace shapes {
extern const ShapeKind sor;
const ShapeKind sor{"sor", read,
                    "sor { 6, <0.1,-0.8>, <0.3,-0.5>, <0.5,-0.1>, <0.25,0.2>, <0.4,0.5>, <0.3,0.8> }"};
}  // namespace shapes

}  // namespace rb
