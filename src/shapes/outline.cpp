#include "shapes/outline.h"

#include <cmath>
#include <limits>
#include <optional>

namespace rb {

namespace {

constexpr double inf = std::numeric_limits<double>::infinity();

/// Includes the extremes between the ends.
void include_piece(const CurvePiece& piece, FlatBox& box) {
    box.include(piece.start());
    box.include(piece.end());
    if (piece.degree == 1) return;
    for (int axis = 0; axis < 2; ++axis) {
        std::array<double, 4> b{};
        for (size_t i = 0; i < 4; ++i) b[i] = piece.control[i][axis];
        const auto c = CurvePiece::powers(b, piece.degree);
        std::array<double, 2> turns{};
        const int n = solve_quadratic(3.0 * c[0], c[1], c[2], turns);
        for (int i = 0; i < n; ++i) {
            const double w = turns[static_cast<size_t>(i)];
            if (!(w > 0.0 && w < 1.0)) continue;
            const double x = piece.at(w)[axis];
            box.lo[axis] = std::min(box.lo[axis], x);
            box.hi[axis] = std::max(box.hi[axis], x);
        }
    }
}

FlatBox hull_of(const CurvePiece& piece) {
    FlatBox box;
    for (int i = 0; i <= piece.degree; ++i) box.include(piece.control[static_cast<size_t>(i)]);
    return box;
}

/// Bound on the distance between a piece and its chords when it is cut into n equal parts: |second
/// derivative| / (8 n^2).
int parts_within(const CurvePiece& piece, double tolerance) {
    if (piece.degree == 1) return 1;
    double bend = 0;
    for (int i = 0; i + 2 <= piece.degree; ++i) {
        const auto k = static_cast<size_t>(i);
        bend =
            std::max(bend, glm::length(piece.control[k] - 2.0 * piece.control[k + 1] + piece.control[k + 2]));
    }
    bend *= piece.degree * (piece.degree - 1);
    constexpr double most = 4096;
    return static_cast<int>(std::clamp(std::ceil(std::sqrt(bend / (8.0 * tolerance))), 1.0, most));
}

}  // namespace

Vec2 CurvePiece::at(double w) const {
    const double v = 1.0 - w;
    switch (degree) {
        case 1:
            return v * control[0] + w * control[1];
        case 2:
            return v * v * control[0] + 2.0 * v * w * control[1] + w * w * control[2];
        default:
            return v * v * v * control[0] + 3.0 * v * v * w * control[1] + 3.0 * v * w * w * control[2] +
                   w * w * w * control[3];
    }
}

Vec2 CurvePiece::slope(double w) const {
    const double v = 1.0 - w;
    switch (degree) {
        case 1:
            return control[1] - control[0];
        case 2:
            return 2.0 * (v * (control[1] - control[0]) + w * (control[2] - control[1]));
        default:
            return 3.0 * (v * v * (control[1] - control[0]) + 2.0 * v * w * (control[2] - control[1]) +
                          w * w * (control[3] - control[2]));
    }
}

std::array<double, 4> CurvePiece::powers(const std::array<double, 4>& b, int degree) {
    switch (degree) {
        case 1:
            return {0.0, 0.0, b[1] - b[0], b[0]};
        case 2:
            return {0.0, b[0] - 2.0 * b[1] + b[2], 2.0 * (b[1] - b[0]), b[0]};
        default:
            return {b[3] - b[0] + 3.0 * (b[1] - b[2]), 3.0 * (b[0] - 2.0 * b[1] + b[2]), 3.0 * (b[1] - b[0]),
                    b[0]};
    }
}

CurvePiece spline_piece(OutlineSpline kind, const Vec2* p) {
    switch (kind) {
        case OutlineSpline::linear:
            return {{p[0], p[1]}, 1};
        case OutlineSpline::quadratic:
            return {{p[1], p[1] + 0.25 * (p[2] - p[0]), p[2]}, 2};
        case OutlineSpline::cubic:
            return {{p[1], p[1] + (p[2] - p[0]) / 6.0, p[2] - (p[3] - p[1]) / 6.0, p[2]}, 3};
        case OutlineSpline::bezier:
            break;
    }
    return {{p[0], p[1], p[2], p[3]}, 3};
}

Outline::Outline(std::vector<CurvePiece> pieces) : pieces_(std::move(pieces)) {
    if (pieces_.empty()) return;
    box_ = {};
    std::vector<CenteredBox> hulls;
    for (const CurvePiece& piece : pieces_) {
        include_piece(piece, box_);
        hulls.emplace_back(hull_of(piece));
    }
    reach_ = CenteredBox(box_);
    tree_ = RangeTree<CenteredBox>(hulls);
    if (std::ranges::all_of(pieces_, [](const CurvePiece& piece) { return piece.degree == 1; })) return;
    samples_.resize(pieces_.size());
    for (size_t i = 0; i < pieces_.size(); ++i) {
        for (size_t k = 0; k < sample_count; ++k)
            samples_[i][k] = pieces_[i].at(static_cast<double>(k) / (sample_count - 1));
    }
}

Outline::Contact Outline::nearest_on(uint32_t index, const Vec2& p) const {
    const CurvePiece& piece = pieces_[index];
    if (piece.degree == 1) {
        const Vec2 along = piece.end() - piece.start();
        const double length = glm::dot(along, along);
        double w = 0.0;
        if (length > 0.0) w = std::clamp(glm::dot(p - piece.start(), along) / length, 0.0, 1.0);
        return {index, w, glm::length(piece.at(w) - p)};
    }
    double least = inf;
    size_t first = 0;
    for (size_t i = 0; i < sample_count; ++i) {
        const Vec2 off = samples_[index][i] - p;
        const double dd = glm::dot(off, off);
        if (!(dd < least)) continue;
        least = dd;
        first = i;
    }
    const double w = static_cast<double>(first) / (sample_count - 1);
    return settle_on_curve(piece, index, p, w, samples_[index][first],
                           [&](double at_w, const Vec2&) { return piece.slope(at_w); });
}

Outline::Contact Outline::nearest(const Vec2& p, double within) const {
    Contact best{0, 0.0, within};
    tree_.visit([&](const CenteredBox& box) { return box.distance(p) < best.distance; },
                [&](uint32_t piece) {
                    const Contact found = nearest_on(piece, p);
                    if (found.distance < best.distance) best = found;
                });
    return best;
}

int Outline::roots(const PlaneLine& line, bool zero_is_negative, uint32_t index, const Contact* contact,
                   std::array<double, 3>& w) const {
    const CurvePiece& piece = pieces_[index];
    if (piece.degree == 1) {
        const double a = line.side(piece.control[0]);
        const double b = line.side(piece.control[1]);
        const bool crosses = is_negative(a, zero_is_negative) != is_negative(b, zero_is_negative);
        if (contact) {
            // By rounding both ends may lie on one side of a line through a contact next to one of them.
            w[0] = std::round(contact->w);
            return crosses ? 0 : 1;
        }
        if (!crosses) return 0;
        const double x = -a / (b - a);
        w[0] = std::isnan(x) ? 0.5 : std::clamp(x, 0.0, 1.0);
        return 1;
    }
    std::array<double, 4> b{};
    for (int i = 0; i <= piece.degree; ++i)
        b[static_cast<size_t>(i)] = line.side(piece.control[static_cast<size_t>(i)]);
    bool start = is_negative(b[0], zero_is_negative);
    bool end = is_negative(b[static_cast<size_t>(piece.degree)], zero_is_negative);
    auto c = CurvePiece::powers(b, piece.degree);
    int degree = piece.degree;
    std::optional<double> crossed_end;
    if (contact) {
        // Divided by w - contact: the other crossings stay where they are.
        for (size_t i = 1; i < 4; ++i) c[i] += contact->w * c[i - 1];
        c = {0.0, c[0], c[1], c[2]};
        start = !start;
        --degree;
        // Next to an end the line's side of it is mere rounding. Where what is left says otherwise, the end
        // itself is crossed.
        constexpr double near = 1e-9;
        bool& close_end = contact->w < 0.5 ? start : end;
        const double at_end = std::round(contact->w);
        const bool says = (c[1] * at_end + c[2]) * at_end + c[3] < 0.0;
        if (std::abs(contact->w - at_end) < near && says != close_end) {
            close_end = says;
            crossed_end = at_end;
        }
    }
    int n = 0;
    if (degree == 1) n = sign_changes<1>({c[2], c[3]}, start, end, std::span<double, 1>(w.data(), 1));
    if (degree == 2) n = sign_changes<2>({c[1], c[2], c[3]}, start, end, std::span<double, 2>(w.data(), 2));
    if (degree == 3) n = sign_changes<3>(c, start, end, w);
    if (crossed_end) w[static_cast<size_t>(n++)] = *crossed_end;
    return n;
}

bool Outline::contains(const Vec2& p) const {
    if (p.x < lo().x || p.x > hi().x || p.y < lo().y || p.y > hi().y) return false;
    bool in = false;
    crossings({0.0, 1.0, -p.y}, nullptr, [&](uint32_t piece, double w) {
        if (pieces_[piece].at(w).x >= p.x) in = !in;
    });
    return in;
}

std::vector<std::vector<Vec2>> Outline::flattened(double tolerance) const {
    std::vector<std::vector<Vec2>> loops;
    const CurvePiece* before = nullptr;
    for (const CurvePiece& piece : pieces_) {
        if (!before || before->end() != piece.start()) loops.emplace_back();
        const int parts = parts_within(piece, tolerance);
        for (int i = 0; i < parts; ++i) loops.back().push_back(piece.at(static_cast<double>(i) / parts));
        before = &piece;
    }
    return loops;
}

}  // namespace rb
