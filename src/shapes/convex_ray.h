#pragma once
#include "math/vec.h"

#include <cmath>
#include <limits>

namespace rb {

/// The root of `value` between a and b, where the values fa and fb have opposite signs, to the last bits:
/// inverse quadratic interpolation where the last three points allow it, else halving (Chandrupatla 1997).
template <class Value>
double bracketed_root(const Value& value, double a, double fa, double b, double fb) {
    double share = fa / (fa - fb);
    if (!(share > 0.0 && share < 1.0)) share = 0.5;
    constexpr int most = 200;
    for (int i = 0; i < most; ++i) {
        const double t = a + share * (b - a);
        const double f = value(t);
        if (f == 0.0) return t;
        // What a step along the chord would still change.
        const double left = f * ((t - a) / (f - fa));
        if (std::abs(left) <= 0.5 * std::numeric_limits<double>::epsilon() * std::abs(t)) return t;
        double c = a;
        double fc = fa;
        if ((f < 0.0) != (fa < 0.0)) {
            c = b;
            fc = fb;
            b = a;
            fb = fa;
        }
        a = t;
        fa = f;
        const double best = std::abs(fa) < std::abs(fb) ? a : b;
        const double least = 2.0 * std::numeric_limits<double>::epsilon() * std::abs(best) / std::abs(b - a);
        if (!(least < 0.5)) return best;
        const double xi = (a - b) / (c - b);
        const double phi = (fa - fb) / (fc - fb);
        share = 0.5;
        if (phi * phi < xi && (1.0 - phi) * (1.0 - phi) < 1.0 - xi)
            share =
                fa / (fb - fa) * (fc / (fb - fc)) + (c - a) / (b - a) * (fa / (fc - fa)) * (fb / (fc - fb));
        share = share > least ? (share < 1.0 - least ? share : 1.0 - least) : least;
    }
    return b;
}

/// The root of a convex function between `x`, where it is f > 0 and falls toward the root by `s`, and
/// `inner`, where it is below 0. Newton's iteration comes ever nearer from the outside and does not pass it.
template <class Value, class Slope>
double convex_root(const Value& value, const Slope& slope, double x, double f, double s, double inner,
                   double f_inner) {
    constexpr int most = 20;
    for (int i = 0; i < most; ++i) {
        const double next = x - f / s;
        if (!(next > x ? next < inner : next > inner)) break;
        const double g = value(next);
        // At the last bits.
        if (g <= 0.0 || std::abs(next - x) <= std::numeric_limits<double>::epsilon() * std::abs(next))
            return next;
        x = next;
        f = g;
        s = slope(x);
    }
    return bracketed_root(value, x, f, inner, f_inner);
}

struct Tangent {
    double t;
    double f;
    double slope;
};

/// A place between `from` and `to` where a convex function is below 0, which it is not there; with f >= 0 if
/// there is none. Moves both toward it.
template <class Value, class Slope>
Tangent convex_valley(const Value& value, const Slope& slope, Tangent& from, Tangent& to) {
    // Where one tangent is steep and one is nearly level they meet next to the steep one's place: halving
    // brings the end.
    constexpr int most_at_once = 8;
    for (int step = 1; from.slope < 0.0 && to.slope > 0.0; ++step) {
        // Both tangents lie below: where they meet above zero, all is above.
        const double meet = (to.f - from.f + from.slope * from.t - to.slope * to.t) / (from.slope - to.slope);
        if (from.f + from.slope * (meet - from.t) > 0.0) break;
        if (from.t - from.f / from.slope > to.t || to.t - to.f / to.slope < from.t) break;
        const bool halve = step % most_at_once == 0 || !(meet > from.t && meet < to.t);
        const double t = halve ? 0.5 * (from.t + to.t) : meet;
        if (!(t > from.t && t < to.t)) break;
        const double f = value(t);
        if (f < 0.0) return {t, f, 0.0};
        const Tangent at{t, f, slope(t)};
        (at.slope < 0.0 ? from : to) = at;
    }
    return from;
}

/// The roots of a convex function on [a, b], at most two, for take(t), which says how far others still
/// matter. `starts_on_root`: it is 0 at a = 0, which does not count. The function must be positive at b
/// unless there is no root there.
template <class Value, class Slope, class Take>
void convex_roots(const Value& value, const Slope& slope, double a, double b, bool starts_on_root,
                  const Take& take) {
    const double at_last = value(b);
    if (starts_on_root) {
        if (!(slope(0.0) < 0.0)) return;
        double inner = b;
        double f = at_last;
        while (f >= 0.0 && inner > 0.0) f = value(inner *= 0.5);
        if (f < 0.0 && at_last > 0.0) take(convex_root(value, slope, b, at_last, slope(b), inner, f));
        return;
    }
    const double at_first = value(a);
    if (at_first < 0.0) {
        if (at_last > 0.0) take(convex_root(value, slope, b, at_last, slope(b), a, at_first));
        return;
    }
    Tangent from{a, at_first, slope(a)};
    Tangent to{b, at_last, slope(b)};
    const Tangent valley = convex_valley(value, slope, from, to);
    if (!(valley.f < 0.0)) return;
    if (take(convex_root(value, slope, from.t, from.f, from.slope, valley.t, valley.f)) > valley.t)
        take(convex_root(value, slope, to.t, to.f, to.slope, valley.t, valley.f));
}

/// The roots between `a` and `b`, at most two, of a function that is convex there but may be steep beyond
/// measure at both ends, where its values are `fa` and `fb`.
template <class Value, class Slope, class Take>
void convex_roots_between(const Value& value, const Slope& slope, double a, double fa, double b, double fb,
                          const Take& take) {
    if ((fa < 0.0) != (fb < 0.0)) {
        take(bracketed_root(value, a, fa, b, fb));
    } else if (fa >= 0.0) {
        Tangent from{a, fa, -infinity};
        Tangent to{b, fb, infinity};
        const Tangent valley = convex_valley(value, slope, from, to);
        if (!(valley.f < 0.0)) return;
        if (take(bracketed_root(value, from.t, from.f, valley.t, valley.f)) > valley.t)
            take(bracketed_root(value, valley.t, valley.f, to.t, to.f));
    }
}

}  // namespace rb
