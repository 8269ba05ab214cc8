// Internal functions that are polynomials in x, y, z. Language spec 15.
#include "language/internal_functions.h"

#include <cmath>

namespace rb {

namespace {

using In = InternalPoint;

double within(double v, double limit) {
    const double high = v > -limit ? v : -limit;
    return high < limit ? high : limit;
}
double pow2(double v) { return v * v; }
double pow3(double v) { return v * v * v; }

double algbr_cyl1(In& a) {
    a.revolve(a.P[2], a.P[3], a.P[4]);
    const double r = -(a.X * std::abs(a.x) - a.X + a.Y);
    return -within(a.P[0] * r, a.P[1]);
}
double algbr_cyl2(In& a) {
    a.revolve(a.P[2], a.P[3], a.P[4]);
    const double r = -(2 * a.X * a.X - 3 * a.X * a.y + a.Y - 2 * a.Y * a.y + a.Y * a.Y);
    return within(a.P[0] * r, a.P[1]);
}
double algbr_cyl3(In& a) {
    a.revolve(a.P[2], a.P[3], a.P[4]);
    const double r = -(a.X * a.X + a.X * a.Y - 2 * a.X * a.y - a.x * a.Y + a.Y);
    return within(a.P[0] * r, a.P[1]);
}
double algbr_cyl4(In& a) {
    a.revolve(a.P[2], a.P[3], a.P[4]);
    const double r = -(a.X * a.X + a.Y * a.Y + 2 * a.X * a.Y + 3 * a.X * a.y - a.Y * a.y);
    return within(a.P[0] * r, a.P[1]);
}
double bicorn(In& a) {
    const double s = a.P[1] * a.P[1];
    return a.clamped(a.Y * (s - a.X - a.Z) - pow2(a.X + a.Z + 2 * a.P[1] * a.y - s));
}
double bifolia(In& a) { return a.clamped(-(pow2(a.X + a.Y + a.Z) - a.P[1] * (a.X + a.Z) * a.y)); }
double boy_surface(In& in) {
    const auto [x, y, z, X, Y, Z, P] = in;
    const double a = 1 - z;
    const double q = X + Y;
    const double s = std::sqrt(2.0);
    return in.clamped(
        P[1] *
        (64 * pow3(a) * pow3(z) - 48 * a * a * Z * (3 * X + 3 * Y + 2 * Z) +
         12 * a * z * (27 * q * q - 24 * Z * q + 36 * s * y * z * (Y - 3 * X) + 4 * Z * Z) +
         (9 * X + 9 * Y - 2 * Z) * (-81 * q * q - 72 * Z * q + 108 * s * x * z * (X - 3 * Y) + 4 * Z * Z)));
}
double crossed_trough(In& a) { return a.clamped(a.X * a.Z - a.y); }
double cubic_saddle(In& a) { return a.clamped(-(pow3(a.x) - pow3(a.y) - a.z)); }
double cushion(In& a) {
    return a.clamped(a.Z * a.X - a.Z * a.Z - 2 * a.z * a.X + 2 * a.Z * a.z + a.X - a.Z - pow2(a.X - a.z) -
                     a.Y * a.Y - 2 * a.X * a.Y - a.Y * a.Z + 2 * a.Y * a.z + a.Y);
}
double devils_curve(In& a) {
    return a.clamped(-(a.X * a.X + 2 * a.X * a.Z - 0.36 * a.X - a.Y * a.Y + 0.25 * a.Y + a.Z * a.Z));
}
double devils_curve_2d(In& a) {
    a.revolve(a.P[3], a.P[4], a.P[5]);
    return a.clamped(-(a.X * (a.X - pow2(a.P[1])) - a.Y * (a.Y - pow2(a.P[2]))));
}
double dupin_cyclid(In& in) {
    const auto [x, y, z, X, Y, Z, P] = in;
    const double r2 = P[5] * P[5];
    const double b = P[2] * P[2];
    const double d = P[4] * P[4];
    const double c = P[3];
    const double a = P[1];
    const double q = X + Y + Z;
    const double A = (b - d - pow2(c + a)) * (b - d - pow2(c - a));
    return in.clamped(
        -(A * q * q +
          2 * r2 * ((-d - c * c + b + a * a) * (2 * c * x + 2 * P[4] * y - r2) - 4 * P[4] * b * y) * q +
          4 * r2 * r2 * (c * x + P[4] * y) * (-r2 + P[4] * y + c * x) + 4 * r2 * r2 * a * a * Y +
          r2 * r2 * r2 * r2));
}
double enneper(In& in) {
    double z = in.z;
    if (std::abs(z) < 0.2) z = 0.2;
    const double a = (in.Y - in.X) / (2 * z) + 2 * in.Z / 9;
    const double b = (in.Y - in.X) / (4 * z);
    return in.clamped(-(pow3(a) - 6 * b * b));
}
double folium(In& a, double square) {
    return (square * (1 + (a.P[2] - 4 * a.P[1]) * a.x) + a.X * (1 + a.P[2]));
}
double folium_surface(In& a) { return a.clamped(folium(a, a.Y + a.Z)); }
double folium_surface_2d(In& a) {
    a.revolve(a.P[3], a.P[4], a.P[5]);
    return a.clamped(-folium(a, a.Y));
}
double glob(In& a) { return a.clamped(0.5 * a.X * a.X * a.x + 0.5 * a.X * a.X - (a.Y + a.Z)); }
double heart(In& a) {
    return a.clamped(-(pow3(2 * a.X + a.Y + a.Z - 1) - 0.1 * a.X * a.Z * a.z - a.Y * a.Z * a.z));
}
double hunt_surface(In& a) {
    return a.clamped(-(4 * pow3(a.X + a.Y + a.Z - 13) + 27 * pow2(3 * a.X + a.Y - 4 * a.Z - 12)));
}
double hyperbolic_torus(In& in) {
    const auto [x, y, z, X, Y, Z, P] = in;
    const double a = P[1] * P[1];
    const double b = P[2] * P[2];
    return in.clamped(-(X * X + 2 * X * Y - 2 * X * Z - 2 * (a + b) * X + Y * Y - 2 * Y * Z +
                        2 * (a - b) * Y + Z * Z + 2 * (a + b) * Z + pow2(a - b)));
}
double kampyle(In& a) {
    return a.clamped(-(a.Y + a.Z - pow2(a.P[2]) * a.X * a.X + pow2(a.P[2]) * pow2(a.P[1]) * a.X));
}
double kampyle_2d(In& a) {
    a.revolve(a.P[3], a.P[4], a.P[5]);
    return a.clamped(-(a.Y - pow2(a.P[2]) * a.X * a.X + pow3(a.P[2]) * a.P[1] * a.X));
}
double klein_bottle(In& a) {
    const double q = a.X + a.Y + a.Z;
    const double m = q - 2 * a.y - 1;
    return a.clamped(-((q + 2 * a.y - 1) * (m * m - 8 * a.Z) + 16 * a.x * a.z * m));
}
double kummer_v1(In& a) {
    return a.clamped(
        -(a.X * a.X + a.Y * a.Y + a.Z * a.Z - a.X - a.Y - a.Z - a.X * a.Y - a.X * a.Z - a.Y * a.Z + 1));
}
double kummer_v2(In& a) {
    return a.clamped(-(a.X * a.X + a.Y * a.Y + a.Z * a.Z + a.P[1] * (a.X + a.Y + a.Z) +
                       a.P[2] * (a.X * a.Y + a.X * a.Z + a.Y * a.Z) + a.P[3] * a.x * a.y * a.z - 1));
}
double lemniscate(In& a) { return a.clamped(-(a.X * a.X - a.X + a.Y + a.Z)); }
double lemniscate_2d(In& a) {
    a.revolve(a.P[3], a.P[4], a.P[5]);
    return a.clamped(-(a.Y - pow2(a.P[2]) * pow2(a.P[1]) * a.X + pow2(a.P[2]) * a.X * a.X));
}
double mitre(In& a) { return a.clamped(-(4 * a.X * (a.X + a.Y + a.Z) - a.Y * (1 - a.Y - a.Z))); }
double nodal_cubic(In& a) { return a.clamped(-(pow3(a.y) + pow3(a.z) - 6 * a.y * a.z)); }
double ovals_of_cassini(In& a) {
    return a.clamped(
        -(pow2(a.X + a.Y + a.Z + pow2(a.P[1])) - a.P[3] * pow2(a.P[1]) * (a.X + a.Z) - pow2(a.P[2])));
}
double paraboloid(In& a) { return a.clamped(-(a.X - a.y + a.Z)); }
double parabolic_torus(In& in) {
    const auto [x, y, z, X, Y, Z, P] = in;
    const double a = P[1] * P[1];
    const double b = P[2] * P[2];
    return in.clamped(-(X * X + 2 * X * Y - 2 * X * z - (a + b) * X + Y * Y - 2 * Y * z + (a - b) * Y + Z +
                        (a + b) * z + pow2(a - b)));
}
double pillow(In& a) { return a.clamped(a.X * a.X + a.Y * a.Y + a.Z * a.Z - a.X - a.Y - a.Z); }
double piriform(In& a) { return -a.clamped(-(a.X * a.X - a.X * a.x + a.Y + a.Z)); }
double piriform_2d(In& a) {
    a.revolve(a.P[4], a.P[5], a.P[6]);
    return a.clamped(-(a.Y - a.P[1] * pow2(a.P[3]) * a.X * a.x - a.P[2] * pow2(a.P[3]) * a.X * a.X));
}
double quartic_paraboloid(In& a) { return a.clamped(-(a.X * a.X + a.Z * a.Z - a.y)); }
double quartic_saddle(In& a) { return a.clamped(-(a.X * a.X - a.Z * a.Z - a.y)); }
double quartic_cylinder(In& a) {
    return a.clamped(-((a.X + a.Z) * a.Y + pow2(a.P[2]) * (a.X + a.Z) - pow2(a.P[2]) * pow2(a.P[1])));
}
double steiners_roman(In& a) { return a.clamped(-(a.X * a.Y + a.X * a.Z + a.Y * a.Z + a.x * a.y * a.z)); }
double strophoid(In& a) {
    return a.clamped(
        -((a.P[2] - a.x) * (a.Y + a.Z) - pow2(a.P[3]) * a.P[1] * a.X - pow2(a.P[3]) * a.X * a.x));
}
double strophoid_2d(In& a) {
    a.revolve(a.P[4], a.P[5], a.P[6]);
    return a.clamped(-((a.P[2] - a.x) * a.Y - pow2(a.P[3]) * a.P[1] * a.X - pow2(a.P[3]) * a.X * a.x));
}
double torus2(In& in) {
    const auto [x, y, z, X, Y, Z, P] = in;
    const double a = P[1] * P[1];
    const double b = P[2] * P[2];
    return in.clamped(-(pow2(X + Y + Z) - 2 * (a + b) * X + 2 * (a - b) * Y - 2 * (a + b) * Z + pow2(a - b)));
}
double torus_gumdrop(In& a) {
    return a.clamped(
        -(4 * (a.X * a.X + pow2(a.Y + a.Z)) + 17 * a.X * (a.Y + a.Z) - 20 * (a.X + a.Y + a.Z) + 17));
}
double umbrella(In& a) { return a.clamped(-(a.X - a.y * a.Z)); }
double witch_of_agnesi(In& a) { return a.clamped(-(a.P[1] * (a.y - 1) + (a.X + a.Z) * a.y)); }
double witch_of_agnesi_2d(In& a) {
    a.revolve(a.P[3], a.P[4], a.P[5]);
    return a.clamped(-(pow2(a.P[1]) * a.y + a.X * a.y - a.P[2]));
}

}  // namespace

std::span<const InternalKind> algebraic_surfaces() {
    static constexpr InternalKind kinds[] = {{0, 5, algbr_cyl1},
                                             {1, 5, algbr_cyl2},
                                             {2, 5, algbr_cyl3},
                                             {3, 5, algbr_cyl4},
                                             {4, 2, bicorn},
                                             {5, 2, bifolia},
                                             {8, 2, boy_surface},
                                             {11, 1, crossed_trough},
                                             {12, 1, cubic_saddle},
                                             {13, 1, cushion},
                                             {14, 1, devils_curve},
                                             {15, 6, devils_curve_2d},
                                             {16, 6, dupin_cyclid},
                                             {18, 1, enneper},
                                             {20, 3, folium_surface},
                                             {21, 6, folium_surface_2d},
                                             {22, 1, glob},
                                             {23, 1, heart},
                                             {30, 1, hunt_surface},
                                             {31, 3, hyperbolic_torus},
                                             {33, 3, kampyle},
                                             {34, 6, kampyle_2d},
                                             {35, 1, klein_bottle},
                                             {36, 1, kummer_v1},
                                             {37, 4, kummer_v2},
                                             {38, 1, lemniscate},
                                             {39, 6, lemniscate_2d},
                                             {41, 1, mitre},
                                             {42, 1, nodal_cubic},
                                             {43, 1, cushion},
                                             {44, 4, ovals_of_cassini},
                                             {45, 1, paraboloid},
                                             {46, 3, parabolic_torus},
                                             {48, 1, pillow},
                                             {49, 1, piriform},
                                             {50, 7, piriform_2d},
                                             {54, 1, quartic_paraboloid},
                                             {55, 1, quartic_saddle},
                                             {56, 3, quartic_cylinder},
                                             {65, 1, steiners_roman},
                                             {66, 4, strophoid},
                                             {67, 7, strophoid_2d},
                                             {71, 3, torus2},
                                             {72, 1, torus_gumdrop},
                                             {73, 1, umbrella},
                                             {74, 2, witch_of_agnesi},
                                             {75, 6, witch_of_agnesi_2d}};
    return kinds;
}

}  // namespace rb
