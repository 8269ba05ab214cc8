#pragma once
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

/// The roots of a convex function on [a, b], at most two, for take(t). `starts_on_root`: it is 0 at a = 0,
/// which does not count. The function must be positive at b unless there is no root there.
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
    double fa = at_first;
    double fb = at_last;
    double sa = slope(a);
    double sb = slope(b);
    while (sa < 0.0 && sb > 0.0) {
        // Both tangents lie below: where they meet above zero, all is above.
        const double meet = (fb - fa + sa * a - sb * b) / (sa - sb);
        if (fa + sa * (meet - a) > 0.0) return;
        const double t = meet > a && meet < b ? meet : 0.5 * (a + b);
        if (!(t > a && t < b)) return;
        const double f = value(t);
        if (f < 0.0) {
            take(convex_root(value, slope, a, fa, sa, t, f));
            take(convex_root(value, slope, b, fb, sb, t, f));
            return;
        }
        const double s = slope(t);
        (s < 0.0 ? a : b) = t;
        (s < 0.0 ? fa : fb) = f;
        (s < 0.0 ? sa : sb) = s;
    }
}

}  // namespace rb
