#include "shapes/julia_orbit.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace rb {

namespace {

using Complex = std::complex<double>;

/// A hypercomplex number is a pair of complex ones, and functions act on each.
struct Pair {
    Complex a, b;
};
Pair pair_of(const Quaternion& q) { return {{q.x - q.w, q.y + q.z}, {q.x + q.w, q.y - q.z}}; }
Quaternion quaternion_of(const Pair& p) {
    return {0.5 * (p.a.real() + p.b.real()), 0.5 * (p.a.imag() + p.b.imag()), 0.5 * (p.a.imag() - p.b.imag()),
            0.5 * (p.b.real() - p.a.real())};
}

Quaternion product(const Quaternion& p, const Quaternion& q) {
    return {p.x * q.x - p.y * q.y - p.z * q.z + p.w * q.w, p.y * q.x + p.x * q.y - p.w * q.z - p.z * q.w,
            p.z * q.x - p.w * q.y + p.x * q.z - p.y * q.w, p.w * q.x + p.z * q.y + p.y * q.z + p.x * q.w};
}

Complex apply(JuliaFunction f, const Complex& z, const Complex& exponent) {
    switch (f) {
        case JuliaFunction::sqr:
        case JuliaFunction::cube:
            return z * z;
        case JuliaFunction::exp:
            return std::exp(z);
        case JuliaFunction::ln:
            return std::log(z);
        case JuliaFunction::reciprocal:
            return 1.0 / z;
        case JuliaFunction::sin:
            return std::sin(z);
        case JuliaFunction::asin:
            return std::asin(z);
        case JuliaFunction::sinh:
            return std::sinh(z);
        case JuliaFunction::asinh:
            return std::asinh(z);
        case JuliaFunction::cos:
            return std::cos(z);
        case JuliaFunction::acos:
            return std::acos(z);
        case JuliaFunction::cosh:
            return std::cosh(z);
        case JuliaFunction::acosh:
            return std::acosh(z);
        case JuliaFunction::tan:
            return std::tan(z);
        case JuliaFunction::atan:
            return std::atan(z);
        case JuliaFunction::tanh:
            return std::tanh(z);
        case JuliaFunction::atanh:
            return std::atanh(z);
        case JuliaFunction::pwr:
            return z == Complex{0.0} ? Complex{0.0} : std::exp(exponent * std::log(z));
    }
    return z;
}

}  // namespace

JuliaFormula::JuliaFormula(const JuliaRule& rule) : JuliaRule(rule) {
    if (algebra == JuliaAlgebra::hypercomplex) {
        radius_ = 4.0;
        escape_ = radius_ * radius_;
    } else {
        radius_ = std::min(2.0, 1.0 + glm::length(c) + 1e-7);
        escape_ = radius_ * radius_ + 1e-7;
    }
}

Quaternion JuliaFormula::function_value(const Quaternion& q) const {
    if (algebra == JuliaAlgebra::quaternion) {
        const double d = q.y * q.y + q.z * q.z + q.w * q.w;
        if (function == JuliaFunction::cube) {
            const double f = 3.0 * q.x * q.x - d;
            return {q.x * (q.x * q.x - 3.0 * d), f * q.y, f * q.z, f * q.w};
        }
        return {q.x * q.x - d, 2.0 * q.x * q.y, 2.0 * q.x * q.z, 2.0 * q.x * q.w};
    }
    if (has_reach()) return product(q, q);
    const Pair p = pair_of(q);
    return quaternion_of({apply(function, p.a, exponent), apply(function, p.b, exponent)});
}

Quaternion JuliaFormula::next(const Quaternion& q) const { return function_value(q) + c; }

size_t JuliaFormula::escape_step(Quaternion q) const {
    const double limit = escape();
    for (size_t i = 0; i < steps; ++i) {
        if (!(glm::dot(q, q) <= limit)) return i;
        q = next(q);
    }
    return steps;
}

double JuliaFormula::excess(Quaternion q, size_t step) const {
    for (size_t i = 0; i < step; ++i) q = next(q);
    return glm::dot(q, q) - escape();
}

Vec3 JuliaFormula::quaternion_normal(const Quaternion& start) const {
    std::array<Quaternion, 3> n{Quaternion{1, 0, 0, 0}, Quaternion{0, 1, 0, 0}, Quaternion{0, 0, 1, 0}};
    Quaternion q = start;
    for (size_t i = 0; i < steps; ++i) {
        const double d = q.y * q.y + q.z * q.z + q.w * q.w;
        for (Quaternion& v : n) {
            const double across = v.y * q.y + v.z * q.z + v.w * q.w;
            if (function == JuliaFunction::cube) {
                const double a = 2.0 * across;
                const double b = 6.0 * q.x * v.x - a;
                const double f = 3.0 * q.x * q.x - d;
                v = {3.0 * (v.x * (q.x * q.x - d) - q.x * a), v.y * f + q.y * b, v.z * f + q.z * b,
                     v.w * f + q.w * b};
            } else {
                v = {v.x * q.x - across, v.x * q.y + v.y * q.x, v.x * q.z + v.z * q.x, v.x * q.w + v.w * q.x};
            }
        }
        q = next(q);
    }
    return {glm::dot(n[0], q), glm::dot(n[1], q), glm::dot(n[2], q)};
}

Vec3 JuliaFormula::hypercomplex_normal(const Quaternion& start) const {
    Quaternion p = start;
    Quaternion q = start;
    for (size_t i = 1; i <= steps; ++i) {
        q = next(q);
        if (i == steps) break;
        if (has_reach()) {
            p = product(q, p);
        } else if (function == JuliaFunction::reciprocal) {
            const Pair r = pair_of(q);
            p = product(p, quaternion_of({-1.0 / (r.a * r.a), -1.0 / (r.b * r.b)}));
        } else {
            p = product(function_value(q), p);
        }
    }
    return {p.x * q.x + p.y * q.y + p.z * q.z + p.w * q.w, -p.y * q.x + p.x * q.y - p.w * q.z + p.z * q.w,
            -p.z * q.x - p.w * q.y + p.x * q.z + p.y * q.w};
}

Vec3 JuliaFormula::normal(const Quaternion& q) const {
    Vec3 n = algebra == JuliaAlgebra::quaternion ? quaternion_normal(q) : hypercomplex_normal(q);
    const double largest = std::max({std::abs(n.x), std::abs(n.y), std::abs(n.z)});
    return largest > 0.0 && std::isfinite(largest) ? n / largest : Vec3{1, 0, 0};
}

}  // namespace rb
