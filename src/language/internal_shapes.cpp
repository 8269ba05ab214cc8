// Internal functions that are not polynomials. Language spec 15.
#include "language/internal_functions.h"

#include <algorithm>
#include <cmath>

namespace rb {

namespace {

using In = InternalPoint;
constexpr double turn = 6.283185307179586477;
constexpr double half_turn = turn / 2;

double sqr(double v) { return v * v; }

double positive_mod(double v, double m) {
    const double r = std::fmod(v, m);
    return r < 0 ? r + m : r;
}

/// The cross section of a helix or spiral: a circle for 1, a square for 0, superellipses between.
double section(double u, double w, double power) {
    if (power == 1) return std::sqrt(u * u + w * w);
    if (power != 0) {
        return std::pow(std::pow(std::abs(u), 2 / power) + std::pow(std::abs(w), 2 / power), power / 2);
    }
    return std::max(std::abs(u), std::abs(w));
}

struct Three {
    double a, b, c;
};
Three ellipsoid_terms(const In& in, double flat, double steep) {
    return {std::exp(-steep * (flat * in.X + flat * in.Y + in.Z)),
            std::exp(-steep * (flat * in.X + in.Y + flat * in.Z)),
            std::exp(-steep * (in.X + flat * in.Y + flat * in.Z))};
}

double blob(In& a) {
    const double h = a.P[0] / 2;
    const double p = std::min(1.0, (sqr(a.x + h) + a.Y + a.Z) * sqr(a.P[2]));
    const double q = std::min(1.0, (sqr(a.x - h) + a.Y + a.Z) * sqr(a.P[4]));
    return -(a.P[1] * sqr(1 - p) + a.P[3] * sqr(1 - q));
}
double blob2(In& a) {
    return a.P[3] - a.P[2] * (std::exp(-a.P[1] * (a.X + a.Y + a.Z)) +
                              std::exp(-a.P[1] * (sqr(a.x - a.P[0]) + a.Y + a.Z)));
}
double comma(In& in) {
    double x = in.x;
    if (x == 0 && in.z == 0) x = 1e-4;
    const double half = in.P[0] / 2;
    const double angle = std::atan2(in.z, x);
    const double r = std::sqrt(sqr(x + in.P[0] / 4) + in.Z);
    const double q = std::min(in.z, std::cos(angle / 2) * half - std::sqrt(sqr(r - 0.75 * in.P[0]) + in.Y));
    return -std::max(q, half - std::sqrt(sqr(x - half) + in.Z + in.Y));
}
double cross_ellipsoids(In& a) {
    const Three e = ellipsoid_terms(a, a.P[0], a.P[1]);
    return a.P[3] - a.P[2] * std::max({e.a, e.b, e.c});
}
double flange_cover(In& a) {
    const Three e = ellipsoid_terms(a, a.P[0], a.P[1]);
    return a.P[3] - a.P[2] * (e.a + e.b + e.c);
}
double isect_ellipsoids(In& a) {
    const Three e = ellipsoid_terms(a, a.P[0], a.P[1]);
    return a.P[3] - a.P[2] * std::min({e.a, e.b, e.c});
}
double spikes(In& a) {
    const Three e = ellipsoid_terms(a, a.P[0], a.P[1]);
    return -a.P[2] * (a.P[4] * std::exp(-a.P[3] * (a.X + a.Y + a.Z)) - e.a - e.b - e.c);
}
double ellipsoid(In& a) { return std::sqrt(sqr(a.P[0]) * a.X + sqr(a.P[1]) * a.Y + sqr(a.P[2]) * a.Z); }

double helical_torus(In& in) {
    double x = in.x;
    const double* P = in.P;
    const double q = std::sqrt(in.X + in.Z);
    if (x == 0 && in.z == 0) x = 1e-6;
    const double phi = std::atan2(x, in.z);
    double tau = std::atan2(q - P[0], in.y);
    const double r = std::sqrt(sqr(q - P[0]) + in.Y);
    double theta = positive_mod(P[1] * phi + P[2] * tau, turn);
    tau = std::atan2(P[8] * (theta - half_turn), r - P[5]);
    tau = P[3] * std::cos(P[7] * tau + P[9] * phi) + P[4];
    const double a = P[4] + P[5] - P[0] - q;
    theta -= half_turn;
    tau -= std::min(std::sqrt(sqr(r - P[5]) + P[6] * theta * theta), r + P[5]);
    return -std::max(a, tau);
}
double helix1(In& in) {
    double x = in.x;
    const double* P = in.P;
    const double r = std::sqrt(in.X + in.Z);
    if (x == 0 && in.z == 0) x = 1e-6;
    const double theta = positive_mod(P[0] * std::atan2(in.z, x) + P[0] * P[1] * in.y, turn);
    double w = (theta - half_turn) / P[4] / (P[1] * P[0]);
    double u = r - P[3];
    if (P[5] != 1 && P[6] != 0) {
        const double angle = P[6] * half_turn / 180;
        const double turned = u * std::cos(angle) - w * std::sin(angle);
        w = u * std::sin(angle) + w * std::cos(angle);
        u = turned;
    }
    return -P[2] + std::min(P[3] + r, section(u, w, P[5]));
}
double helix2(In& in) {
    const double* P = in.P;
    const double c = std::cos(P[1] * in.y);
    const double s = std::sin(P[1] * in.y);
    const double a = in.x - P[3] * c;
    const double b = in.z - P[3] * s;
    return section(a * c + b * s, -a * s + b * c, P[5]) - P[2];
}

struct Hex {
    double a, b;
    bool flat;
};
Hex hexagon(const In& in) {
    const double s = std::sqrt(3.0);
    double a = std::abs(std::fmod(std::abs(in.x), s) - s / 2);
    double b = std::abs(std::fmod(std::abs(in.y), 3.0) - 1.5);
    const double c = s / 2 - a;
    const double d = 1.5 - b;
    if (a * a + b * b > c * c + d * d) {
        a = c;
        b = d;
    }
    return {a, b, std::atan2(b, a) < half_turn / 6};
}
double hex_x(In& in) {
    const Hex h = hexagon(in);
    return h.flat ? h.a : h.a * std::cos(half_turn / 3) + h.b * std::sin(half_turn / 3);
}
double hex_y(In& in) {
    const Hex h = hexagon(in);
    return h.flat ? h.b : std::abs(-h.a * std::sin(half_turn / 3) + h.b * std::cos(half_turn / 3));
}

double mesh1(In& in) {
    const double* P = in.P;
    const auto gap = [&](double u, double p) { return std::abs(positive_mod(u, 2 * p) - p) * P[2]; };
    const double cx = P[3] * std::cos(half_turn * in.x / P[0]);
    const double cz = P[3] * std::cos(half_turn * in.z / P[1]);
    const auto thread = [&](double across, double g) { return std::sqrt(sqr(P[4] * across) + g * g); };
    return std::min({thread(in.y - cz, gap(in.x, P[0])), thread(in.y + cz, gap(in.x - P[0], P[0])),
                     thread(in.y + cx, gap(in.z, P[1])), thread(in.y - cx, gap(in.z - P[1], P[1]))});
}
double ph(In& a) { return std::atan2(std::sqrt(a.X + a.Z), a.y); }
double poly4(In& a) {
    const double* P = a.P;
    const double p = P[0] + P[1] * a.y + P[2] * a.Y + P[3] * a.Y * a.y + P[4] * a.Y * a.Y;
    return std::sqrt(a.X + a.Z) - std::max(-5.0, p);
}
double polytubes(In& a) {
    const double* P = a.P;
    const double q = P[1] + P[2] * a.y + P[3] * a.Y + P[4] * a.Y * a.y + P[5] * a.Y * a.Y;
    double nearest = 10000;
    const int count = static_cast<int>(std::clamp(P[0], 0.0, 1e6));
    for (int i = 0; i < count; ++i) {
        const double angle = turn * i / P[0];
        nearest =
            std::min(nearest, std::sqrt(sqr(a.x - q * std::sin(angle)) + sqr(a.z - q * std::cos(angle))));
    }
    return nearest;
}
double quantum(In& a) {
    double x = a.x;
    if (x == 0 && a.z == 0) x = 1e-6;
    const double h = std::sqrt(x * x + a.Z);
    const double c = std::cos(std::atan2(h, a.y));
    const double r = 2 * std::sqrt(h * h + a.Y);
    const double q = r * r * std::exp(-0.33333333 * r) * (3 * c * c - 1);
    return -0.1 * (q * q - 12);
}
double radius(In& a) { return std::sqrt(a.X + a.Y + a.Z); }
double rounded_box(In& a) {
    const double* P = a.P;
    const auto excess = [&](double u, double b) { return std::max(0.0, std::abs(u) - (b - P[0])); };
    return -P[0] + std::sqrt(sqr(excess(a.x, P[1])) + sqr(excess(a.y, P[2])) + sqr(excess(a.z, P[3]))) - 1e-6;
}
double sphere(In& a) { return -a.P[0] + std::sqrt(a.X + a.Y + a.Z); }
double spikes_2d(In& a) {
    return a.y - a.P[0] * std::cos(a.P[1] * a.x) * std::cos(a.P[2] * a.z) * std::exp(-a.P[3] * (a.X + a.Z));
}
double spiral(In& in) {
    double x = in.x;
    const double* P = in.P;
    double r = std::sqrt(in.X + in.Z);
    if (x == 0 && in.z == 0) x = 1e-6;
    r += P[0] * std::atan2(in.z, x) / turn;
    const double q = section(std::fmod(r, P[0]) - P[0] / 2, in.y, P[5]);
    r = std::sqrt(x * x + in.Y + in.Z);
    return -std::min(P[2] - r, P[1] - std::min(q, r));
}
double superellipsoid(In& a) {
    const double* P = a.P;
    const double xy =
        std::pow(std::pow(std::abs(a.x), 2 / P[0]) + std::pow(std::abs(a.y), 2 / P[0]), P[0] / P[1]);
    return 1 - std::pow(xy + std::pow(std::abs(a.z), 2 / P[1]), P[1] / 2);
}
double th(In& a) { return std::atan2(a.x, a.z); }
double torus(In& a) { return -a.P[1] + std::sqrt(sqr(std::sqrt(a.X + a.Z) - a.P[0]) + a.Y); }

}  // namespace

void InternalPoint::revolve(double p, double distance, double angle) {
    if (!(p > 0)) return;
    const double u = std::sqrt(x * x + z * z) - distance;
    const double theta = angle * half_turn / 180;
    if (theta != 0) {
        const double turned = u * std::cos(theta) - y * std::sin(theta);
        y = u * std::sin(theta) + y * std::cos(theta);
        x = turned;
    } else {
        x = u;
    }
    X = x * x;
    Y = y * y;
}

std::span<const InternalKind> shaped_surfaces() {
    static constexpr InternalKind kinds[] = {
        {6, 5, blob},       {7, 4, blob2},         {9, 1, comma},           {10, 4, cross_ellipsoids},
        {17, 3, ellipsoid}, {19, 4, flange_cover}, {24, 10, helical_torus}, {25, 7, helix1},
        {26, 7, helix2},    {27, 1, hex_x},        {28, 1, hex_y},          {32, 4, isect_ellipsoids},
        {40, 5, mesh1},     {47, 0, ph},           {51, 5, poly4},          {52, 6, polytubes},
        {53, 1, quantum},   {57, 0, radius},       {60, 4, rounded_box},    {61, 1, sphere},
        {62, 5, spikes},    {63, 4, spikes_2d},    {64, 6, spiral},         {68, 2, superellipsoid},
        {69, 0, th},        {70, 2, torus}};
    return kinds;
}

}  // namespace rb
