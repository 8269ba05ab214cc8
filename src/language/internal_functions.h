#pragma once
#include "math/interval_slope.h"

#include <cmath>
#include <cstdint>
#include <span>

namespace rb {

/// The number itself; of parameters as intervals, which are points, too.
inline double known(double v) { return v; }
inline double known(const Interval& v) { return v.lo; }
inline double known(const IntervalSlope& v) { return v.value.lo; }

/// v cut to [-limit, limit]; nan becomes -limit.
inline double within(double v, double limit) {
    const double high = v > -limit ? v : -limit;
    return high < limit ? high : limit;
}
Interval within(const Interval& v, const Interval& limit);
IntervalSlope within(const IntervalSlope& v, const IntervalSlope& limit);

/// On the axis x = z = 0, x becomes `small`.
inline void keep_from_axis(double& x, double z, double small) {
    if (x == 0 && z == 0) x = small;
}
void keep_from_axis(Interval& x, const Interval& z, double small);
void keep_from_axis(IntervalSlope& x, const IntervalSlope& z, double small);

/// What is nearer to 0 than 0.2 becomes 0.2.
inline void keep_from_zero(double& z) {
    if (z < 0.2 && z > -0.2) z = 0.2;
}
void keep_from_zero(Interval& z);
void keep_from_zero(IntervalSlope& z);

/// The arguments of an internal function: a point, its squares, and the parameters P0, P1, ... T is double,
/// Interval (a box of points; its parameters are points) or IntervalSlope (a piece of a line).
template <class T>
struct InternalPoint {
    T x, y, z;
    T X, Y, Z;
    const T* P;

    explicit InternalPoint(std::span<const T> a)
        : x(a[0]), y(a[1]), z(a[2]), X(square(x)), Y(square(y)), Z(square(z)), P(a.data() + 3) {}

    /// Most surfaces: P0 scales, the result stays within +-10.
    T clamped(const T& r) const { return within(P[0] * r, T(10)); }

    /// The two-dimensional ones turn a curve into a surface of revolution first.
    void revolve(const T& p, const T& distance, const T& angle) {
        using std::cos, std::sin, std::sqrt;
        if (!(known(p) > 0)) return;
        const T u = sqrt(square(x) + square(z)) - distance;
        if (known(angle) != 0) {
            const T theta = angle * 3.14159265358979323846 / 180;
            const T turned = u * cos(theta) - y * sin(theta);
            y = u * sin(theta) + y * cos(theta);
            x = turned;
        } else {
            x = u;
        }
        X = square(x);
        Y = square(y);
    }
};

struct InternalKind {
    uint8_t number;
    uint8_t parameters;  ///< besides x, y, z
    double (*value)(InternalPoint<double>& at);
    Interval (*bound)(InternalPoint<Interval>& at);
    IntervalSlope (*bound_slope)(InternalPoint<IntervalSlope>& at);
};

std::span<const InternalKind> algebraic_surfaces();
std::span<const InternalKind> shaped_surfaces();

}  // namespace rb
