#pragma once
#include <cstdint>
#include <span>

namespace rb {

/// The arguments of an internal function: a point, its squares, and the parameters P0, P1, ...
struct InternalPoint {
    double x, y, z;
    double X, Y, Z;
    const double* P;

    /// Most surfaces: P0 scales, the result stays within +-10.
    double clamped(double r) const {
        const double v = P[0] * r;
        const double high = v > -10 ? v : -10;
        return high < 10 ? high : 10;
    }
    /// The two-dimensional ones turn a curve into a surface of revolution first.
    void revolve(double p, double distance, double angle);
};

struct InternalKind {
    uint8_t number;
    uint8_t parameters;  ///< besides x, y, z
    double (*value)(InternalPoint& at);
};

std::span<const InternalKind> algebraic_surfaces();
std::span<const InternalKind> shaped_surfaces();

}  // namespace rb
