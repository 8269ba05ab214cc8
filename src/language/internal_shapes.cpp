// Internal functions that are not polynomials. Language spec 15.
#include "language/internal_functions.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace rb {

namespace {

template <class T>
using In = InternalPoint<T>;
constexpr double turn = 6.283185307179586477;
constexpr double half_turn = turn / 2;

using std::abs;
using std::atan2;
using std::cos;
using std::exp;
using std::fmod;
using std::max;
using std::min;
using std::pow;
using std::sin;
using std::sqrt;

double positive_mod(double v, double m) {
    const double r = fmod(v, m);
    return r < 0 ? r + m : r;
}
Interval positive_mod(const Interval& v, const Interval& m) {
    const Interval r = fmod(v, m);
    return r.lo < 0 ? hull(r, r + m) : r;
}
IntervalSlope positive_mod(const IntervalSlope& v, const IntervalSlope& m) {
    const IntervalSlope r = fmod(v, m);
    if (r.value.lo >= 0) return r;
    if (r.value.hi < 0) return r + m;
    return {hull(r.value, (r + m).value), Interval::everything()};
}

/// The cross section of a helix or spiral: a circle for 1, a square for 0, superellipses between.
template <class T>
T section(const T& u, const T& w, const T& power) {
    if (known(power) == 1) return sqrt(square(u) + square(w));
    if (known(power) != 0) {
        return pow(pow(abs(u), 2 / power) + pow(abs(w), 2 / power), power / 2);
    }
    return max(abs(u), abs(w));
}

template <class T>
struct Three {
    T a, b, c;
};
template <class T>
Three<T> ellipsoid_terms(const In<T>& in, const T& flat, const T& steep) {
    return {exp(-steep * (flat * in.X + flat * in.Y + in.Z)),
            exp(-steep * (flat * in.X + in.Y + flat * in.Z)),
            exp(-steep * (in.X + flat * in.Y + flat * in.Z))};
}

template <class T>
T blob(In<T>& a) {
    const T h = a.P[0] / 2;
    const T p = min(T(1), (square(a.x + h) + a.Y + a.Z) * square(a.P[2]));
    const T q = min(T(1), (square(a.x - h) + a.Y + a.Z) * square(a.P[4]));
    return -(a.P[1] * square(1 - p) + a.P[3] * square(1 - q));
}
template <class T>
T blob2(In<T>& a) {
    return a.P[3] -
           a.P[2] * (exp(-a.P[1] * (a.X + a.Y + a.Z)) + exp(-a.P[1] * (square(a.x - a.P[0]) + a.Y + a.Z)));
}
template <class T>
T comma(In<T>& in) {
    T x = in.x;
    keep_from_axis(x, in.z, 1e-4);
    const T half = in.P[0] / 2;
    const T angle = atan2(in.z, x);
    const T r = sqrt(square(x + in.P[0] / 4) + in.Z);
    const T q = min(in.z, cos(angle / 2) * half - sqrt(square(r - 0.75 * in.P[0]) + in.Y));
    return -max(q, half - sqrt(square(x - half) + in.Z + in.Y));
}
template <class T>
T cross_ellipsoids(In<T>& a) {
    const Three<T> e = ellipsoid_terms(a, a.P[0], a.P[1]);
    return a.P[3] - a.P[2] * max(max(e.a, e.b), e.c);
}
template <class T>
T flange_cover(In<T>& a) {
    const Three<T> e = ellipsoid_terms(a, a.P[0], a.P[1]);
    return a.P[3] - a.P[2] * (e.a + e.b + e.c);
}
template <class T>
T isect_ellipsoids(In<T>& a) {
    const Three<T> e = ellipsoid_terms(a, a.P[0], a.P[1]);
    return a.P[3] - a.P[2] * min(min(e.a, e.b), e.c);
}
template <class T>
T spikes(In<T>& a) {
    const Three<T> e = ellipsoid_terms(a, a.P[0], a.P[1]);
    return -a.P[2] * (a.P[4] * exp(-a.P[3] * (a.X + a.Y + a.Z)) - e.a - e.b - e.c);
}
template <class T>
T ellipsoid(In<T>& a) {
    return sqrt(square(a.P[0]) * a.X + square(a.P[1]) * a.Y + square(a.P[2]) * a.Z);
}

template <class T>
T helical_torus(In<T>& in) {
    T x = in.x;
    const T* P = in.P;
    const T q = sqrt(in.X + in.Z);
    keep_from_axis(x, in.z, 1e-6);
    const T phi = atan2(x, in.z);
    T tau = atan2(q - P[0], in.y);
    const T r = sqrt(square(q - P[0]) + in.Y);
    T theta = positive_mod(P[1] * phi + P[2] * tau, turn);
    tau = atan2(P[8] * (theta - half_turn), r - P[5]);
    tau = P[3] * cos(P[7] * tau + P[9] * phi) + P[4];
    const T a = P[4] + P[5] - P[0] - q;
    theta -= half_turn;
    tau -= min(sqrt(square(r - P[5]) + P[6] * theta * theta), r + P[5]);
    return -max(a, tau);
}
template <class T>
T helix1(In<T>& in) {
    T x = in.x;
    const T* P = in.P;
    const T r = sqrt(in.X + in.Z);
    keep_from_axis(x, in.z, 1e-6);
    const T theta = positive_mod(P[0] * atan2(in.z, x) + P[0] * P[1] * in.y, turn);
    T w = (theta - half_turn) / P[4] / (P[1] * P[0]);
    T u = r - P[3];
    if (known(P[5]) != 1 && known(P[6]) != 0) {
        const T angle = P[6] * half_turn / 180;
        const T turned = u * cos(angle) - w * sin(angle);
        w = u * sin(angle) + w * cos(angle);
        u = turned;
    }
    return -P[2] + min(P[3] + r, section(u, w, P[5]));
}
template <class T>
T helix2(In<T>& in) {
    const T* P = in.P;
    const T c = cos(P[1] * in.y);
    const T s = sin(P[1] * in.y);
    const T a = in.x - P[3] * c;
    const T b = in.z - P[3] * s;
    return section(a * c + b * s, -a * s + b * c, P[5]) - P[2];
}

struct Hex {
    double a, b;
    bool flat;
};
Hex hexagon(const In<double>& in) {
    const double s = sqrt(3.0);
    double a = abs(fmod(abs(in.x), s) - s / 2);
    double b = abs(fmod(abs(in.y), 3.0) - 1.5);
    const double c = s / 2 - a;
    const double d = 1.5 - b;
    if (a * a + b * b > c * c + d * d) {
        a = c;
        b = d;
    }
    return {a, b, atan2(b, a) < half_turn / 6};
}
/// Where a hexagon's pattern lies: a <= sqrt(3)/2, b <= 3/2.
Interval within_hexagon(const In<Interval>& in, double most) {
    return {0, most, in.x.maybe_nan || in.x.has_infinity() || in.y.maybe_nan || in.y.has_infinity()};
}
IntervalSlope within_hexagon(const In<IntervalSlope>& in, double most) {
    const bool nan = in.x.value.maybe_nan || in.x.value.has_infinity() || in.y.value.maybe_nan ||
                     in.y.value.has_infinity();
    return {{0, most, nan}, Interval::everything()};
}
template <class T>
T hex_x(In<T>& in) {
    if constexpr (!std::is_same_v<T, double>)
        return within_hexagon(in, 1.7321);
    else {
        const Hex h = hexagon(in);
        return h.flat ? h.a : h.a * cos(half_turn / 3) + h.b * sin(half_turn / 3);
    }
}
template <class T>
T hex_y(In<T>& in) {
    if constexpr (!std::is_same_v<T, double>)
        return within_hexagon(in, 1.5001);
    else {
        const Hex h = hexagon(in);
        return h.flat ? h.b : abs(-h.a * sin(half_turn / 3) + h.b * cos(half_turn / 3));
    }
}

template <class T>
T mesh1(In<T>& in) {
    const T* P = in.P;
    const auto gap = [&](const T& u, const T& p) { return abs(positive_mod(u, 2 * p) - p) * P[2]; };
    const T cx = P[3] * cos(half_turn * in.x / P[0]);
    const T cz = P[3] * cos(half_turn * in.z / P[1]);
    const auto thread = [&](const T& across, const T& g) { return sqrt(square(P[4] * across) + square(g)); };
    const T across_x = min(thread(in.y - cz, gap(in.x, P[0])), thread(in.y + cz, gap(in.x - P[0], P[0])));
    const T across_z = min(thread(in.y + cx, gap(in.z, P[1])), thread(in.y - cx, gap(in.z - P[1], P[1])));
    return min(across_x, across_z);
}
template <class T>
T ph(In<T>& a) {
    return atan2(sqrt(a.X + a.Z), a.y);
}
template <class T>
T poly4(In<T>& a) {
    const T* P = a.P;
    const T p = P[0] + P[1] * a.y + P[2] * a.Y + P[3] * a.Y * a.y + P[4] * a.Y * a.Y;
    return sqrt(a.X + a.Z) - max(T(-5), p);
}
template <class T>
T polytubes(In<T>& a) {
    const T* P = a.P;
    const T q = P[1] + P[2] * a.y + P[3] * a.Y + P[4] * a.Y * a.y + P[5] * a.Y * a.Y;
    T nearest = 10000;
    const int count = static_cast<int>(std::clamp(known(P[0]), 0.0, 1e6));
    for (int i = 0; i < count; ++i) {
        const T angle = turn * i / P[0];
        nearest = min(nearest, sqrt(square(a.x - q * sin(angle)) + square(a.z - q * cos(angle))));
    }
    return nearest;
}
template <class T>
T quantum(In<T>& a) {
    T x = a.x;
    keep_from_axis(x, a.z, 1e-6);
    const T h = sqrt(square(x) + a.Z);
    const T c = cos(atan2(h, a.y));
    const T r = 2 * sqrt(square(h) + a.Y);
    const T q = r * r * exp(-0.33333333 * r) * (3 * c * c - 1);
    return -0.1 * (q * q - 12);
}
template <class T>
T radius(In<T>& a) {
    return sqrt(a.X + a.Y + a.Z);
}
template <class T>
T rounded_box(In<T>& a) {
    const T* P = a.P;
    const auto excess = [&](const T& u, const T& b) { return max(T(0), abs(u) - (b - P[0])); };
    return -P[0] + sqrt(square(excess(a.x, P[1])) + square(excess(a.y, P[2])) + square(excess(a.z, P[3]))) -
           1e-6;
}
template <class T>
T sphere(In<T>& a) {
    return -a.P[0] + sqrt(a.X + a.Y + a.Z);
}
template <class T>
T spikes_2d(In<T>& a) {
    return a.y - a.P[0] * cos(a.P[1] * a.x) * cos(a.P[2] * a.z) * exp(-a.P[3] * (a.X + a.Z));
}
template <class T>
T spiral(In<T>& in) {
    T x = in.x;
    const T* P = in.P;
    T r = sqrt(in.X + in.Z);
    keep_from_axis(x, in.z, 1e-6);
    r += P[0] * atan2(in.z, x) / turn;
    const T q = section(fmod(r, P[0]) - P[0] / 2, in.y, P[5]);
    r = sqrt(square(x) + in.Y + in.Z);
    return -min(P[2] - r, P[1] - min(q, r));
}
template <class T>
T superellipsoid(In<T>& a) {
    const T* P = a.P;
    const T xy = pow(pow(abs(a.x), 2 / P[0]) + pow(abs(a.y), 2 / P[0]), P[0] / P[1]);
    return 1 - pow(xy + pow(abs(a.z), 2 / P[1]), P[1] / 2);
}
template <class T>
T th(In<T>& a) {
    return atan2(a.x, a.z);
}
template <class T>
T torus(In<T>& a) {
    return -a.P[1] + sqrt(square(sqrt(a.X + a.Z) - a.P[0]) + a.Y);
}

}  // namespace

// NOLINTBEGIN(bugprone-macro-parentheses): f is the name of a template.
#define RB_SURFACE(number, parameters, f) \
    { number, parameters, f<double>, f<Interval>, f<IntervalSlope> }
// NOLINTEND(bugprone-macro-parentheses)
std::span<const InternalKind> shaped_surfaces() {
    static constexpr InternalKind kinds[] = {RB_SURFACE(6, 5, blob),
                                             RB_SURFACE(7, 4, blob2),
                                             RB_SURFACE(9, 1, comma),
                                             RB_SURFACE(10, 4, cross_ellipsoids),
                                             RB_SURFACE(17, 3, ellipsoid),
                                             RB_SURFACE(19, 4, flange_cover),
                                             RB_SURFACE(24, 10, helical_torus),
                                             RB_SURFACE(25, 7, helix1),
                                             RB_SURFACE(26, 7, helix2),
                                             RB_SURFACE(27, 1, hex_x),
                                             RB_SURFACE(28, 1, hex_y),
                                             RB_SURFACE(32, 4, isect_ellipsoids),
                                             RB_SURFACE(40, 5, mesh1),
                                             RB_SURFACE(47, 0, ph),
                                             RB_SURFACE(51, 5, poly4),
                                             RB_SURFACE(52, 6, polytubes),
                                             RB_SURFACE(53, 1, quantum),
                                             RB_SURFACE(57, 0, radius),
                                             RB_SURFACE(60, 4, rounded_box),
                                             RB_SURFACE(61, 1, sphere),
                                             RB_SURFACE(62, 5, spikes),
                                             RB_SURFACE(63, 4, spikes_2d),
                                             RB_SURFACE(64, 6, spiral),
                                             RB_SURFACE(68, 2, superellipsoid),
                                             RB_SURFACE(69, 0, th),
                                             RB_SURFACE(70, 2, torus)};
    return kinds;
}

#undef RB_SURFACE

}  // namespace rb
