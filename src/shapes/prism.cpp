// prism { [linear_spline|quadratic_spline|cubic_spline|bezier_spline] [linear_sweep|conic_sweep]
//         h1, h2, n, <x,z>, ... [open] }   (manual 3.5.1.9)
#include "shapes/extrusion.h"
#include "shapes/registry.h"
#include "shapes/spline_words.h"

#include <cmath>

namespace rb {

namespace {

bool same(const Vec2& a, const Vec2& b) {
    // The language's own tolerance for closing a curve.
    constexpr double tolerance = 1e-10;
    return std::abs(a.x - b.x) < tolerance && std::abs(a.y - b.y) < tolerance;
}

/// Joins the points to closed curves (spec: geometry 13.4).
class LoopMaker {
public:
    LoopMaker(OutlineSpline kind, const std::vector<Vec2>& points) : kind_(kind), points_(points) {}

    bool is_closed() const { return closed_; }

    std::vector<CurvePiece> pieces() {
        if (kind_ == OutlineSpline::bezier) {
            beziers();
        } else {
            splines();
        }
        if (!closed_ && kind_ != OutlineSpline::linear) pieces_.clear();
        return std::move(pieces_);
    }

private:
    void add(CurvePiece piece, size_t loop_start) {
        // Joints meet exactly.
        if (pieces_.size() > loop_start) piece.control[0] = pieces_.back().end();
        pieces_.push_back(piece);
    }
    void close(size_t loop_start) {
        CurvePiece& last = pieces_.back();
        last.control[static_cast<size_t>(last.degree)] = pieces_[loop_start].start();
    }

    void splines() {
        const size_t before = kind_ == OutlineSpline::linear ? 0 : 1;
        const size_t after = kind_ == OutlineSpline::cubic ? 1 : 0;
        size_t i = before;
        while (i < points_.size()) {
            const size_t first = i;
            const size_t loop_start = pieces_.size();
            bool ends = false;
            while (!ends && i + 1 + after < points_.size()) {
                add(spline_piece(kind_, &points_[i - before]), loop_start);
                ++i;
                ends = same(points_[i], points_[first]);
            }
            if (!ends) {
                closed_ = false;
                if (pieces_.size() > loop_start)
                    pieces_.push_back({{pieces_.back().end(), pieces_[loop_start].start()}, 1});
                return;
            }
            close(loop_start);
            i += 1 + after + before;
        }
    }

    void beziers() {
        size_t loop_start = 0;
        for (size_t i = 0; i + 3 < points_.size(); i += 4) {
            const bool follows = pieces_.size() > loop_start;
            if (follows && !same(pieces_.back().end(), points_[i])) {
                closed_ = false;
                return;
            }
            add(spline_piece(kind_, &points_[i]), loop_start);
            if (!same(pieces_.back().end(), pieces_[loop_start].start())) continue;
            close(loop_start);
            reverse(loop_start);
            loop_start = pieces_.size();
        }
        closed_ = loop_start == pieces_.size();
    }

    /// The language walks a bezier prism from its end to its start, which shows in its normals.
    void reverse(size_t loop_start) {
        for (size_t i = loop_start; i < pieces_.size(); ++i) std::ranges::reverse(pieces_[i].control);
        std::reverse(pieces_.begin() + static_cast<std::ptrdiff_t>(loop_start), pieces_.end());
    }

    OutlineSpline kind_;
    const std::vector<Vec2>& points_;
    std::vector<CurvePiece> pieces_;
    bool closed_ = true;
};

size_t least_points(OutlineSpline kind) {
    switch (kind) {
        case OutlineSpline::linear:
            return 3;
        case OutlineSpline::quadratic:
            return 5;
        case OutlineSpline::cubic:
            return 6;
        case OutlineSpline::bezier:
            break;
    }
    return 4;
}

std::vector<Vec2> read_points(BlockReader& in, OutlineSpline kind) {
    const SourceRange at = in.where();
    const int count = in.integer();
    if (count < 0 || static_cast<size_t>(count) < least_points(kind) ||
        (kind == OutlineSpline::bezier && count % 4 != 0)) {
        in.fail_at(at, "Prism has too few points or incorrect number of points.");
    }
    std::vector<double> values;
    in.numbers(static_cast<size_t>(count), 2, values);
    std::vector<Vec2> points;
    for (size_t i = 0; i + 1 < values.size(); i += 2) points.emplace_back(values[i], values[i + 1]);
    return points;
}

ShapePtr read(BlockReader& in) {
    auto swept = std::make_shared<SweptOutlines>();
    swept->keyword = "prism";
    OutlineSpline kind = OutlineSpline::linear;
    for (;;) {
        if (take_spline_kind(in, kind)) continue;
        if (in.take_word("linear_sweep")) {
            swept->conic = false;
        } else if (in.take_word("conic_sweep")) {
            swept->conic = true;
        } else {
            break;
        }
    }
    swept->h0 = in.number();
    swept->h1 = in.number();
    if (swept->h0 > swept->h1) std::swap(swept->h0, swept->h1);
    const std::vector<Vec2> points = read_points(in, kind);
    LoopMaker maker(kind, points);
    std::vector<CurvePiece> pieces = maker.pieces();
    if (!maker.is_closed()) {
        in.diagnostics().warning(in.block_where(), kind == OutlineSpline::linear
                                                       ? "Linear prism not closed. Closing it."
                                                       : "Prism not closed. Ignoring it.");
    }
    if (!pieces.empty()) swept->outlines.emplace_back(std::move(pieces));
    swept->open = in.take_word("open");
    Transform object_from_local;
    object_from_local.forward.row = {Vec3{1, 0, 0}, Vec3{0, 0, 1}, Vec3{0, 1, 0}, Vec3{0.0}};
    object_from_local.backward = object_from_local.forward;
    return std::make_shared<Extrusion>(std::move(swept), object_from_local);
}

}  // namespace

namespace shapes {
extern const ShapeKind prism;
const ShapeKind prism{"prism", read,
                      "prism { cubic_spline -0.4, 0.5, 14, <-0.6,0.5>, <-0.5,-0.5>, <0.6,-0.5>, <0.5,0.6>, "
                      "<-0.6,0.5>, <-0.5,-0.5>, <0.6,-0.5>, <0.2,-0.2>, <0.2,0.2>, <-0.2,0.2>, "
                      "<-0.2,-0.2>, <0.2,-0.2>, <0.2,0.2>, <-0.2,0.2> }"};
}  // namespace shapes

}  // namespace rb
