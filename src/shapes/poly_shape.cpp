#include "shapes/poly_shape.h"

#include "math/roots.h"
#include "shapes/poly_along.h"
#include "shapes/poly_bounds.h"

#include <algorithm>

#include <fmt/format.h>

namespace rb {

namespace {

/// A polynomial in one variable, lowest power first; none of the powers if it is zero everywhere.
class Univariate {
public:
    Univariate() {}  // NOLINT(modernize-use-equals-default): no need to fill the array

    /// Becomes itself times (a + b t).
    void multiply(double a, double b) {
        if (size_ == 0) return;
        c_[size_] = c_[size_ - 1] * b;
        for (size_t i = size_ - 1; i > 0; --i) c_[i] = c_[i] * a + c_[i - 1] * b;
        c_[0] *= a;
        ++size_;
    }
    void add(double c) {
        if (c == 0.0) return;
        if (size_ == 0) c_[size_++] = 0.0;
        c_[0] += c;
    }
    void add(const Univariate& other) {
        while (size_ < other.size_) c_[size_++] = 0.0;
        for (size_t i = 0; i < other.size_; ++i) c_[i] += other.c_[i];
    }
    std::span<const double> coefficients() const { return {c_.data(), size_}; }

private:
    size_t size_ = 0;
    std::array<double, most_degree + 2> c_;
};

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
    : keyword_(keyword), order_(order), c_(std::move(coefficients)), bounds_(poly_bounds(order_, c_)) {
    const double* c = c_.data();
    for (int i = order_; i >= 0; --i) {
        for (int j = order_ - i; j >= 0; --j) {
            const double* end = c + (order_ - i - j + 1);
            while (c < end && *c == 0.0) ++c;
            z_powers_.push_back(static_cast<uint8_t>(end - c));
            c = end;
        }
    }
}

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

template <class T>
std::array<T, 3> PolyShape::gradient(const T& x, const T& y, const T& z) const {
    const double* c = c_.data();
    T in_x = 0.0;
    T by_x = 0.0;
    T by_y = 0.0;
    T by_z = 0.0;
    for (int i = order_; i >= 0; --i) {
        T in_y = 0.0;
        T y_by_y = 0.0;
        T y_by_z = 0.0;
        for (int j = order_ - i; j >= 0; --j) {
            T in_z = 0.0;
            T z_by_z = 0.0;
            for (int k = order_ - i - j; k >= 0; --k) {
                z_by_z = z_by_z * z + in_z;
                in_z = in_z * z + T(*c++);
            }
            y_by_y = y_by_y * y + in_y;
            y_by_z = y_by_z * y + z_by_z;
            in_y = in_y * y + in_z;
        }
        by_x = by_x * x + in_x;
        by_y = by_y * x + y_by_y;
        by_z = by_z * x + y_by_z;
        in_x = in_x * x + in_y;
    }
    return {by_x, by_y, by_z};
}

Vec3 PolyShape::gradient(const Vec3& p) const {
    const auto [by_x, by_y, by_z] = gradient(p.x, p.y, p.z);
    return {by_x, by_y, by_z};
}

std::optional<GradientBound> PolyShape::slopes(const Bounds& region) const {
    const auto along = [&](int i) { return Interval(region.lo[i], region.hi[i]); };
    return GradientBound::of(gradient(along(0), along(1), along(2)));
}

std::optional<TriangleMesh> PolyShape::tessellate(double tolerance) const {
    if (!bounds_.is_finite()) return std::nullopt;
    return solid_mesh(*this, bounds_, tolerance);
}

/// The polynomial of t at o + t d, lowest power first.
void PolyShape::along(const Vec3& o, const Vec3& d, std::span<double> out) const {
    PolyAlong ray(c_.data(), o, d);
    if (order_ == 2) {
        std::ranges::copy(ray.find<2>(), out.begin());
    } else if (order_ == 3) {
        std::ranges::copy(ray.find<3>(), out.begin());
    } else if (order_ == 4) {
        std::ranges::copy(ray.find<4>(), out.begin());
    } else {
        along_sparse(o, d, out);
    }
}

/// The same for any order. What is zero costs little: most polynomials of high order are sparse.
void PolyShape::along_sparse(const Vec3& o, const Vec3& d, std::span<double> out) const {
    const double* end = c_.data();
    const uint8_t* powers = z_powers_.data();
    Univariate in_x;
    for (int i = order_; i >= 0; --i) {
        Univariate in_y;
        for (int j = order_ - i; j >= 0; --j) {
            Univariate in_z;
            end += order_ - i - j + 1;
            for (const double* c = end - *powers++; c < end; ++c) {
                in_z.multiply(o.z, d.z);
                in_z.add(*c);
            }
            in_y.multiply(o.y, d.y);
            in_y.add(in_z);
        }
        in_x.multiply(o.x, d.x);
        in_x.add(in_y);
    }
    const std::span<const double> found = in_x.coefficients();
    std::copy(found.begin(), found.end(), out.begin());
    std::fill(out.begin() + static_cast<std::ptrdiff_t>(found.size()), out.end(), 0.0);
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
    std::array<double, most_degree + 1> low;
    const auto n = static_cast<size_t>(order_);
    along(q, scale * ray.direction, {low.data(), n + 1});
    // Where the ray starts on the surface, that root is divided out.
    const size_t first = here ? 1 : 0;
    const std::span<double> from_low(low.data() + first, n + 1 - first);
    std::array<double, most_degree + 1> high;
    std::reverse_copy(from_low.begin(), from_low.end(), high.begin());
    const std::span<double> from_high(high.data(), from_low.size());
    std::array<double, most_degree> roots;
    const auto take = [&](int count, bool inverse) {
        for (size_t i = 0; i < static_cast<size_t>(count); ++i) {
            if (inverse && roots[i] == 0.0) continue;
            out[found++] = middle + scale * (inverse ? 1.0 / roots[i] : roots[i]);
        }
    };
    // The asked part of the ray, and no less: at its ends rounding decides elsewhere.
    constexpr double slack = 1e-9;
    const double from = (query.t_min - middle) / scale;
    const double to = (query.t_max - middle) / scale;
    const double lo = std::max(from - slack * std::abs(from), -middle / scale);
    const double hi = to + slack * std::abs(to);
    if (const int quick = try_solve_polynomial(from_high, lo, hi, roots); quick >= 0) {
        take(quick, false);
        return found;
    }
    const auto look = [&](std::span<const double> c, double begin, double end, bool inverse) {
        const int quick = try_solve_polynomial(c, begin, end, roots);
        take(quick >= 0 ? quick : solve_polynomial(c, begin, end, roots), inverse);
    };
    if (lo < 1.0 && hi > -1.0) look(from_high, std::max(lo, -1.0), std::min(hi, 1.0), false);
    // Beyond 1 the inverse is the parameter: the coefficients in reverse.
    if (hi > 1.0) look(from_low, 1.0 / hi, lo > 1.0 ? 1.0 / lo : 1.0, true);
    if (lo < -1.0) look(from_low, hi < -1.0 ? 1.0 / hi : -1.0, 1.0 / lo, true);
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
