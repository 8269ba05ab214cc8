#include "shapes/poly_shape.h"

#include "math/roots.h"

#include <algorithm>

#include <fmt/format.h>

namespace rb {

namespace {

using Univariate = std::array<double, most_degree + 1>;  ///< lowest power first

/// p * (a + b t) + q, for p of degree `degree` - 1.
void multiply_add(Univariate& p, size_t degree, double a, double b, const Univariate& q) {
    for (size_t i = degree; i > 0; --i) p[i] = p[i] * a + p[i - 1] * b + q[i];
    p[0] = p[0] * a + q[0];
}

}  // namespace

size_t poly_size(int order) {
    const auto n = static_cast<size_t>(order);
    return (n + 1) * (n + 2) * (n + 3) / 6;
}

size_t poly_index(int order, int i, int j, int k) {
    const auto a = static_cast<size_t>(order - i);
    const size_t b = a - static_cast<size_t>(j);
    const size_t c = b - static_cast<size_t>(k);
    return a * (a + 1) * (a + 2) / 6 + b * (b + 1) / 2 + c;
}

PolyShape::PolyShape(std::string_view keyword, int order, std::vector<double> coefficients)
    : keyword_(keyword), order_(order), c_(std::move(coefficients)) {}

double PolyShape::value(const Vec3& p) const {
    const double* c = c_.data();
    double in_x = 0.0;
    for (int i = order_; i >= 0; --i) {
        double in_y = 0.0;
        for (int j = order_ - i; j >= 0; --j) {
            double in_z = 0.0;
            for (int k = order_ - i - j; k >= 0; --k) in_z = in_z * p.z + *c++;
            in_y = in_y * p.y + in_z;
        }
        in_x = in_x * p.x + in_y;
    }
    return in_x;
}

Vec3 PolyShape::gradient(const Vec3& p) const {
    const double* c = c_.data();
    double in_x = 0.0;
    Vec3 g{0.0};
    for (int i = order_; i >= 0; --i) {
        double in_y = 0.0;
        double y_by_y = 0.0;
        double y_by_z = 0.0;
        for (int j = order_ - i; j >= 0; --j) {
            double in_z = 0.0;
            double z_by_z = 0.0;
            for (int k = order_ - i - j; k >= 0; --k) {
                z_by_z = z_by_z * p.z + in_z;
                in_z = in_z * p.z + *c++;
            }
            y_by_y = y_by_y * p.y + in_y;
            y_by_z = y_by_z * p.y + z_by_z;
            in_y = in_y * p.y + in_z;
        }
        g = {g.x * p.x + in_x, g.y * p.x + y_by_y, g.z * p.x + y_by_z};
        in_x = in_x * p.x + in_y;
    }
    return g;
}

/// The polynomial of t at o + t d, lowest power first.
void PolyShape::along(const Vec3& o, const Vec3& d, std::span<double> out) const {
    const double* c = c_.data();
    Univariate in_x{};
    for (int i = order_; i >= 0; --i) {
        Univariate in_y{};
        for (int j = order_ - i; j >= 0; --j) {
            Univariate in_z{};
            size_t degree = 0;
            for (int k = order_ - i - j; k >= 0; --k) {
                multiply_add(in_z, degree++, o.z, d.z, {*c++});
            }
            multiply_add(in_y, static_cast<size_t>(order_ - i), o.y, d.y, in_z);
        }
        multiply_add(in_x, static_cast<size_t>(order_), o.x, d.x, in_y);
    }
    std::copy_n(in_x.begin(), out.size(), out.begin());
}

bool PolyShape::starts_here(const ShapeRay& query) const {
    if (query.starts_on_surface) return true;
    if (!(query.origin_error > 0.0)) return false;
    return std::abs(value(query.ray.origin)) <= query.origin_error * glm::length(gradient(query.ray.origin));
}

size_t PolyShape::find(const ShapeRay& query, Roots& out) const {
    size_t found = 0;
    const Ray& ray = query.ray;
    const bool here = starts_here(query);
    const double length = glm::length(ray.direction);
    // The parameter is 0 where the ray passes the coordinates' origin, and 1 as far from there.
    const double middle = here ? 0.0 : -glm::dot(ray.origin, ray.direction) / (length * length);
    const Vec3 q = ray.at(middle);
    const double scale = std::max(glm::length(q), 1.0) / length;
    Univariate low{};
    const auto n = static_cast<size_t>(order_);
    along(q, scale * ray.direction, {low.data(), n + 1});
    // Where the ray starts on the surface, that root is divided out.
    const size_t first = here ? 1 : 0;
    const std::span<double> from_low(low.data() + first, n + 1 - first);
    Univariate high{};
    std::reverse_copy(from_low.begin(), from_low.end(), high.begin());
    const std::span<double> from_high(high.data(), from_low.size());
    std::array<double, most_degree> roots{};
    const auto take = [&](int count, bool inverse) {
        for (size_t i = 0; i < static_cast<size_t>(count); ++i) {
            if (inverse && roots[i] == 0.0) continue;
            out[found++] = middle + scale * (inverse ? 1.0 / roots[i] : roots[i]);
        }
    };
    const double start = -middle / scale;
    if (start < 1.0) take(solve_polynomial(from_high, std::max(start, -1.0), 1.0, roots), false);
    // Beyond 1 the inverse is the parameter: the coefficients in reverse.
    take(solve_polynomial(from_low, 0.0, std::min(1.0, start > 1.0 ? 1.0 / start : 1.0), roots), true);
    if (start < -1.0) take(solve_polynomial(from_low, -1.0, 1.0 / start, roots), true);
    return found;
}

Vec3 PolyShape::normal(const Vec3& p, const Crossing&) const {
    const Vec3 n = gradient(p);
    return n == Vec3{0.0} ? Vec3{1, 0, 0} : n;
}

ShapePtr read_poly(BlockReader& in, std::string_view keyword, int order) {
    std::vector<double> coefficients;
    in.numbers(poly_size(order), 1, coefficients);
    return std::make_shared<PolyShape>(keyword, order, std::move(coefficients));
}

std::string PolyShape::describe() const {
    std::string text = fmt::format("order {}:", order_);
    for (const double c : c_) text += fmt::format(" {}", c);
    return text;
}

}  // namespace rb
