// Internal functions that are polynomials in x, y, z. Language spec 15.
#include "language/internal_functions.h"

#include <cmath>

namespace rb {

namespace {

template <class T>
using In = InternalPoint<T>;

using std::abs;

template <class T>
T algbr_cyl1(In<T>& a) {
    a.revolve(a.P[2], a.P[3], a.P[4]);
    const T r = -(a.X * abs(a.x) - a.X + a.Y);
    return -within(a.P[0] * r, a.P[1]);
}
template <class T>
T algbr_cyl2(In<T>& a) {
    a.revolve(a.P[2], a.P[3], a.P[4]);
    const T r = -(2 * a.X * a.X - 3 * a.X * a.y + a.Y - 2 * a.Y * a.y + a.Y * a.Y);
    return within(a.P[0] * r, a.P[1]);
}
template <class T>
T algbr_cyl3(In<T>& a) {
    a.revolve(a.P[2], a.P[3], a.P[4]);
    const T r = -(a.X * a.X + a.X * a.Y - 2 * a.X * a.y - a.x * a.Y + a.Y);
    return within(a.P[0] * r, a.P[1]);
}
template <class T>
T algbr_cyl4(In<T>& a) {
    a.revolve(a.P[2], a.P[3], a.P[4]);
    const T r = -(a.X * a.X + a.Y * a.Y + 2 * a.X * a.Y + 3 * a.X * a.y - a.Y * a.y);
    return within(a.P[0] * r, a.P[1]);
}
template <class T>
T bicorn(In<T>& a) {
    const T s = a.P[1] * a.P[1];
    return a.clamped(a.Y * (s - a.X - a.Z) - square(a.X + a.Z + 2 * a.P[1] * a.y - s));
}
template <class T>
T bifolia(In<T>& a) {
    return a.clamped(-(square(a.X + a.Y + a.Z) - a.P[1] * (a.X + a.Z) * a.y));
}
template <class T>
T boy_surface(In<T>& in) {
    const auto [x, y, z, X, Y, Z, P] = in;
    const T a = 1 - z;
    const T q = X + Y;
    const double s = std::sqrt(2.0);
    return in.clamped(
        P[1] *
        (64 * cube(a) * cube(z) - 48 * a * a * Z * (3 * X + 3 * Y + 2 * Z) +
         12 * a * z * (27 * q * q - 24 * Z * q + 36 * s * y * z * (Y - 3 * X) + 4 * Z * Z) +
         (9 * X + 9 * Y - 2 * Z) * (-81 * q * q - 72 * Z * q + 108 * s * x * z * (X - 3 * Y) + 4 * Z * Z)));
}
template <class T>
T crossed_trough(In<T>& a) {
    return a.clamped(a.X * a.Z - a.y);
}
template <class T>
T cubic_saddle(In<T>& a) {
    return a.clamped(-(cube(a.x) - cube(a.y) - a.z));
}
template <class T>
T cushion(In<T>& a) {
    return a.clamped(a.Z * a.X - a.Z * a.Z - 2 * a.z * a.X + 2 * a.Z * a.z + a.X - a.Z - square(a.X - a.z) -
                     a.Y * a.Y - 2 * a.X * a.Y - a.Y * a.Z + 2 * a.Y * a.z + a.Y);
}
template <class T>
T devils_curve(In<T>& a) {
    return a.clamped(-(a.X * a.X + 2 * a.X * a.Z - 0.36 * a.X - a.Y * a.Y + 0.25 * a.Y + a.Z * a.Z));
}
template <class T>
T devils_curve_2d(In<T>& a) {
    a.revolve(a.P[3], a.P[4], a.P[5]);
    return a.clamped(-(a.X * (a.X - square(a.P[1])) - a.Y * (a.Y - square(a.P[2]))));
}
template <class T>
T dupin_cyclid(In<T>& in) {
    const auto [x, y, z, X, Y, Z, P] = in;
    const T r2 = P[5] * P[5];
    const T b = P[2] * P[2];
    const T d = P[4] * P[4];
    const T c = P[3];
    const T a = P[1];
    const T q = X + Y + Z;
    const T A = (b - d - square(c + a)) * (b - d - square(c - a));
    return in.clamped(
        -(A * q * q +
          2 * r2 * ((-d - c * c + b + a * a) * (2 * c * x + 2 * P[4] * y - r2) - 4 * P[4] * b * y) * q +
          4 * r2 * r2 * (c * x + P[4] * y) * (-r2 + P[4] * y + c * x) + 4 * r2 * r2 * a * a * Y +
          r2 * r2 * r2 * r2));
}
template <class T>
T enneper(In<T>& in) {
    T z = in.z;
    keep_from_zero(z);
    const T a = (in.Y - in.X) / (2 * z) + 2 * in.Z / 9;
    const T b = (in.Y - in.X) / (4 * z);
    return in.clamped(-(cube(a) - 6 * b * b));
}
template <class T>
T folium(In<T>& a, const T& across) {
    return (across * (1 + (a.P[2] - 4 * a.P[1]) * a.x) + a.X * (1 + a.P[2]));
}
template <class T>
T folium_surface(In<T>& a) {
    return a.clamped(folium(a, a.Y + a.Z));
}
template <class T>
T folium_surface_2d(In<T>& a) {
    a.revolve(a.P[3], a.P[4], a.P[5]);
    return a.clamped(-folium(a, a.Y));
}
template <class T>
T glob(In<T>& a) {
    return a.clamped(0.5 * a.X * a.X * a.x + 0.5 * a.X * a.X - (a.Y + a.Z));
}
template <class T>
T heart(In<T>& a) {
    return a.clamped(-(cube(2 * a.X + a.Y + a.Z - 1) - 0.1 * a.X * a.Z * a.z - a.Y * a.Z * a.z));
}
template <class T>
T hunt_surface(In<T>& a) {
    return a.clamped(-(4 * cube(a.X + a.Y + a.Z - 13) + 27 * square(3 * a.X + a.Y - 4 * a.Z - 12)));
}
template <class T>
T hyperbolic_torus(In<T>& in) {
    const auto [x, y, z, X, Y, Z, P] = in;
    const T a = P[1] * P[1];
    const T b = P[2] * P[2];
    return in.clamped(-(X * X + 2 * X * Y - 2 * X * Z - 2 * (a + b) * X + Y * Y - 2 * Y * Z +
                        2 * (a - b) * Y + Z * Z + 2 * (a + b) * Z + square(a - b)));
}
template <class T>
T kampyle(In<T>& a) {
    return a.clamped(-(a.Y + a.Z - square(a.P[2]) * a.X * a.X + square(a.P[2]) * square(a.P[1]) * a.X));
}
template <class T>
T kampyle_2d(In<T>& a) {
    a.revolve(a.P[3], a.P[4], a.P[5]);
    return a.clamped(-(a.Y - square(a.P[2]) * a.X * a.X + cube(a.P[2]) * a.P[1] * a.X));
}
template <class T>
T klein_bottle(In<T>& a) {
    const T q = a.X + a.Y + a.Z;
    const T m = q - 2 * a.y - 1;
    return a.clamped(-((q + 2 * a.y - 1) * (m * m - 8 * a.Z) + 16 * a.x * a.z * m));
}
template <class T>
T kummer_v1(In<T>& a) {
    return a.clamped(
        -(a.X * a.X + a.Y * a.Y + a.Z * a.Z - a.X - a.Y - a.Z - a.X * a.Y - a.X * a.Z - a.Y * a.Z + 1));
}
template <class T>
T kummer_v2(In<T>& a) {
    return a.clamped(-(a.X * a.X + a.Y * a.Y + a.Z * a.Z + a.P[1] * (a.X + a.Y + a.Z) +
                       a.P[2] * (a.X * a.Y + a.X * a.Z + a.Y * a.Z) + a.P[3] * a.x * a.y * a.z - 1));
}
template <class T>
T lemniscate(In<T>& a) {
    return a.clamped(-(a.X * a.X - a.X + a.Y + a.Z));
}
template <class T>
T lemniscate_2d(In<T>& a) {
    a.revolve(a.P[3], a.P[4], a.P[5]);
    return a.clamped(-(a.Y - square(a.P[2]) * square(a.P[1]) * a.X + square(a.P[2]) * a.X * a.X));
}
template <class T>
T mitre(In<T>& a) {
    return a.clamped(-(4 * a.X * (a.X + a.Y + a.Z) - a.Y * (1 - a.Y - a.Z)));
}
template <class T>
T nodal_cubic(In<T>& a) {
    return a.clamped(-(cube(a.y) + cube(a.z) - 6 * a.y * a.z));
}
template <class T>
T ovals_of_cassini(In<T>& a) {
    return a.clamped(
        -(square(a.X + a.Y + a.Z + square(a.P[1])) - a.P[3] * square(a.P[1]) * (a.X + a.Z) - square(a.P[2])));
}
template <class T>
T paraboloid(In<T>& a) {
    return a.clamped(-(a.X - a.y + a.Z));
}
template <class T>
T parabolic_torus(In<T>& in) {
    const auto [x, y, z, X, Y, Z, P] = in;
    const T a = P[1] * P[1];
    const T b = P[2] * P[2];
    return in.clamped(-(X * X + 2 * X * Y - 2 * X * z - (a + b) * X + Y * Y - 2 * Y * z + (a - b) * Y + Z +
                        (a + b) * z + square(a - b)));
}
template <class T>
T pillow(In<T>& a) {
    return a.clamped(a.X * a.X + a.Y * a.Y + a.Z * a.Z - a.X - a.Y - a.Z);
}
template <class T>
T piriform(In<T>& a) {
    return -a.clamped(-(a.X * a.X - a.X * a.x + a.Y + a.Z));
}
template <class T>
T piriform_2d(In<T>& a) {
    a.revolve(a.P[4], a.P[5], a.P[6]);
    return a.clamped(-(a.Y - a.P[1] * square(a.P[3]) * a.X * a.x - a.P[2] * square(a.P[3]) * a.X * a.X));
}
template <class T>
T quartic_paraboloid(In<T>& a) {
    return a.clamped(-(a.X * a.X + a.Z * a.Z - a.y));
}
template <class T>
T quartic_saddle(In<T>& a) {
    return a.clamped(-(a.X * a.X - a.Z * a.Z - a.y));
}
template <class T>
T quartic_cylinder(In<T>& a) {
    return a.clamped(-((a.X + a.Z) * a.Y + square(a.P[2]) * (a.X + a.Z) - square(a.P[2]) * square(a.P[1])));
}
template <class T>
T steiners_roman(In<T>& a) {
    return a.clamped(-(a.X * a.Y + a.X * a.Z + a.Y * a.Z + a.x * a.y * a.z));
}
template <class T>
T strophoid(In<T>& a) {
    return a.clamped(
        -((a.P[2] - a.x) * (a.Y + a.Z) - square(a.P[3]) * a.P[1] * a.X - square(a.P[3]) * a.X * a.x));
}
template <class T>
T strophoid_2d(In<T>& a) {
    a.revolve(a.P[4], a.P[5], a.P[6]);
    return a.clamped(-((a.P[2] - a.x) * a.Y - square(a.P[3]) * a.P[1] * a.X - square(a.P[3]) * a.X * a.x));
}
template <class T>
T torus2(In<T>& in) {
    const auto [x, y, z, X, Y, Z, P] = in;
    const T a = P[1] * P[1];
    const T b = P[2] * P[2];
    return in.clamped(
        -(square(X + Y + Z) - 2 * (a + b) * X + 2 * (a - b) * Y - 2 * (a + b) * Z + square(a - b)));
}
template <class T>
T torus_gumdrop(In<T>& a) {
    return a.clamped(
        -(4 * (a.X * a.X + square(a.Y + a.Z)) + 17 * a.X * (a.Y + a.Z) - 20 * (a.X + a.Y + a.Z) + 17));
}
template <class T>
T umbrella(In<T>& a) {
    return a.clamped(-(a.X - a.y * a.Z));
}
template <class T>
T witch_of_agnesi(In<T>& a) {
    return a.clamped(-(a.P[1] * (a.y - 1) + (a.X + a.Z) * a.y));
}
template <class T>
T witch_of_agnesi_2d(In<T>& a) {
    a.revolve(a.P[3], a.P[4], a.P[5]);
    return a.clamped(-(square(a.P[1]) * a.y + a.X * a.y - a.P[2]));
}

}  // namespace

// NOLINTBEGIN(bugprone-macro-parentheses): f is the name of a template.
#define RB_SURFACE(number, parameters, f) \
    { number, parameters, f<double>, f<Interval>, f<IntervalSlope> }
// NOLINTEND(bugprone-macro-parentheses)
std::span<const InternalKind> algebraic_surfaces() {
    static constexpr InternalKind kinds[] = {RB_SURFACE(0, 5, algbr_cyl1),
                                             RB_SURFACE(1, 5, algbr_cyl2),
                                             RB_SURFACE(2, 5, algbr_cyl3),
                                             RB_SURFACE(3, 5, algbr_cyl4),
                                             RB_SURFACE(4, 2, bicorn),
                                             RB_SURFACE(5, 2, bifolia),
                                             RB_SURFACE(8, 2, boy_surface),
                                             RB_SURFACE(11, 1, crossed_trough),
                                             RB_SURFACE(12, 1, cubic_saddle),
                                             RB_SURFACE(13, 1, cushion),
                                             RB_SURFACE(14, 1, devils_curve),
                                             RB_SURFACE(15, 6, devils_curve_2d),
                                             RB_SURFACE(16, 6, dupin_cyclid),
                                             RB_SURFACE(18, 1, enneper),
                                             RB_SURFACE(20, 3, folium_surface),
                                             RB_SURFACE(21, 6, folium_surface_2d),
                                             RB_SURFACE(22, 1, glob),
                                             RB_SURFACE(23, 1, heart),
                                             RB_SURFACE(30, 1, hunt_surface),
                                             RB_SURFACE(31, 3, hyperbolic_torus),
                                             RB_SURFACE(33, 3, kampyle),
                                             RB_SURFACE(34, 6, kampyle_2d),
                                             RB_SURFACE(35, 1, klein_bottle),
                                             RB_SURFACE(36, 1, kummer_v1),
                                             RB_SURFACE(37, 4, kummer_v2),
                                             RB_SURFACE(38, 1, lemniscate),
                                             RB_SURFACE(39, 6, lemniscate_2d),
                                             RB_SURFACE(41, 1, mitre),
                                             RB_SURFACE(42, 1, nodal_cubic),
                                             RB_SURFACE(43, 1, cushion),
                                             RB_SURFACE(44, 4, ovals_of_cassini),
                                             RB_SURFACE(45, 1, paraboloid),
                                             RB_SURFACE(46, 3, parabolic_torus),
                                             RB_SURFACE(48, 1, pillow),
                                             RB_SURFACE(49, 1, piriform),
                                             RB_SURFACE(50, 7, piriform_2d),
                                             RB_SURFACE(54, 1, quartic_paraboloid),
                                             RB_SURFACE(55, 1, quartic_saddle),
                                             RB_SURFACE(56, 3, quartic_cylinder),
                                             RB_SURFACE(65, 1, steiners_roman),
                                             RB_SURFACE(66, 4, strophoid),
                                             RB_SURFACE(67, 7, strophoid_2d),
                                             RB_SURFACE(71, 3, torus2),
                                             RB_SURFACE(72, 1, torus_gumdrop),
                                             RB_SURFACE(73, 1, umbrella),
                                             RB_SURFACE(74, 2, witch_of_agnesi),
                                             RB_SURFACE(75, 6, witch_of_agnesi_2d)};
    return kinds;
}

#undef RB_SURFACE

}  // namespace rb
