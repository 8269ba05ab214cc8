#include "shapes/julia_orbit.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace rb {

namespace {

/// Orbits of the functions with known bounds, as `parts` numbers whose lengths grow each for itself; |q|^2 is
/// the mean of their squares. A part of length `size` that moves by `step` moves its successor by
/// spread(size, step) at most, and by the root of growth(size^2) times `step` in first order.
struct QuaternionSquares {
    static constexpr size_t parts = 1;
    Quaternion q, c;

    std::array<double, parts> squared_sizes() const { return {glm::dot(q, q)}; }
    void advance() {
        const double twice = 2.0 * q.x;
        q = {q.x * q.x - (q.y * q.y + q.z * q.z + q.w * q.w) + c.x, twice * q.y + c.y, twice * q.z + c.z,
             twice * q.w + c.w};
    }
    static double growth(double squared_size) { return 4.0 * squared_size; }
    static double spread(double size, double step) { return step * (2.0 * size + step); }
};

struct QuaternionCubes {
    static constexpr size_t parts = 1;
    Quaternion q, c;

    std::array<double, parts> squared_sizes() const { return {glm::dot(q, q)}; }
    void advance() {
        const double d = q.y * q.y + q.z * q.z + q.w * q.w;
        const double f = 3.0 * q.x * q.x - d;
        q = {q.x * (q.x * q.x - 3.0 * d) + c.x, f * q.y + c.y, f * q.z + c.z, f * q.w + c.w};
    }
    static double growth(double squared_size) { return 9.0 * squared_size * squared_size; }
    static double spread(double size, double step) {
        return step * (3.0 * size * (size + step) + step * step);
    }
};

/// The two complex numbers that a hypercomplex one consists of.
struct HypercomplexSquares {
    static constexpr size_t parts = 2;
    Vec2 a, b, ca, cb;

    HypercomplexSquares(const Quaternion& q, const Quaternion& c)
        : a(q.x - q.w, q.y + q.z),
          b(q.x + q.w, q.y - q.z),
          ca(c.x - c.w, c.y + c.z),
          cb(c.x + c.w, c.y - c.z) {}
    std::array<double, parts> squared_sizes() const { return {glm::dot(a, a), glm::dot(b, b)}; }
    void advance() {
        a = Vec2{a.x * a.x - a.y * a.y, 2.0 * a.x * a.y} + ca;
        b = Vec2{b.x * b.x - b.y * b.y, 2.0 * b.x * b.y} + cb;
    }
    static double growth(double squared_size) { return 4.0 * squared_size; }
    static double spread(double size, double step) { return step * (2.0 * size + step); }
};

/// JuliaFormula::reach of one kind of orbit: the first derivatives give a guess, which is then proven, or
/// halved.
template <class Orbit>
class OrbitReach {
public:
    static constexpr size_t most = 64;  ///< iterates looked at

    OrbitReach(const JuliaFormula& formula, const Orbit& start)
        : orbit_(start), limit_(formula.escape()), edge_(std::sqrt(limit_)) {
        go_along(std::min(formula.steps, most));
    }
    bool stays() const { return stays_; }

    /// 0 if none above `least` is proven.
    double distance(double least) const {
        constexpr double caution = 0.7;
        for (double guess = caution * std::sqrt(squared_guess_); guess > least; guess *= 0.5) {
            if (is_proven(guess)) return guess;
        }
        return 0.0;
    }

private:
    using Parts = std::array<double, Orbit::parts>;

    static double mean(const Parts& of) {
        if constexpr (Orbit::parts == 1) return of[0];
        return 0.5 * (of[0] + of[1]);
    }
    static double mean_size(const Parts& sizes) {
        if constexpr (Orbit::parts == 1) return sizes[0];
        return std::sqrt(0.5 * (sizes[0] * sizes[0] + sizes[1] * sizes[1]));
    }

    void go_along(size_t steps) {
        Parts growth;
        growth.fill(static_cast<double>(Orbit::parts));
        for (; count_ < steps; ++count_) {
            const Parts squares = orbit_.squared_sizes();
            for (size_t k = 0; k < Orbit::parts; ++k) sizes_[count_][k] = std::sqrt(squares[k]);
            const double square = mean(squares);
            const double gap = (Orbit::parts == 1 ? sizes_[count_][0] : std::sqrt(square)) - edge_;
            const double guess = gap * gap / mean(growth);
            const bool escapes = !(square <= limit_);
            // Of the iterates beyond the edge the first few tell the most.
            if (!stays_ && !(escapes && guess > squared_guess_)) break;
            squared_guess_ = escapes ? guess : std::min(squared_guess_, guess);
            stays_ = !escapes;
            constexpr double tiny = 1e-18;
            for (size_t k = 0; k < Orbit::parts; ++k)
                growth[k] = std::max(growth[k] * Orbit::growth(squares[k]), tiny);
            orbit_.advance();
        }
    }

    bool is_proven(double distance) const {
        constexpr double rounding = 1e-12;
        Parts step;
        step.fill(Orbit::parts == 1 ? distance : std::sqrt(2.0) * distance);
        for (size_t i = 0; i < count_; ++i) {
            const double size = mean_size(sizes_[i]);
            const double move = mean_size(step);
            if (stays_ && size + move > edge_ * (1.0 - rounding)) return false;
            if (!stays_ && size - move > edge_ * (1.0 + rounding)) return true;
            for (size_t k = 0; k < Orbit::parts; ++k) step[k] = Orbit::spread(sizes_[i][k], step[k]);
        }
        return stays_;
    }

    Orbit orbit_;
    double limit_, edge_;
    size_t count_ = 0;
    bool stays_ = true;
    double squared_guess_ = std::numeric_limits<double>::infinity();
    std::array<Parts, most> sizes_;
};

template <class Orbit>
JuliaFormula::Reach reach_of(const JuliaFormula& formula, const Quaternion& start, double least) {
    const OrbitReach<Orbit> reach(formula, Orbit{start, formula.c});
    if (reach.stays() && formula.steps > OrbitReach<Orbit>::most) return {formula.stays(start), 0.0};
    return {reach.stays(), reach.distance(least)};
}

}  // namespace

JuliaFormula::Reach JuliaFormula::reach(const Quaternion& start, double least) const {
    if (algebra == JuliaAlgebra::hypercomplex) return reach_of<HypercomplexSquares>(*this, start, least);
    return function == JuliaFunction::cube ? reach_of<QuaternionCubes>(*this, start, least)
                                           : reach_of<QuaternionSquares>(*this, start, least);
}

}  // namespace rb
