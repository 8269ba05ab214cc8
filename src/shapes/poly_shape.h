#pragma once
#include "block/reader.h"
#include "math/roots.h"
#include "shapes/ray_shape.h"
#include "shapes/solid_mesh.h"

namespace rb {

/// Coefficients of a polynomial in x, y, z of a given order: for i = N..0 (power of x), for j = N-i..0 (of
/// y), for k = N-i-j..0 (of z).
size_t poly_size(int order);
size_t poly_index(int order, int i, int j, int k);

/// Where a polynomial in x, y and z is zero; inside it is below.
class PolyShape final : public RayShape<PolyShape>, private PointSolid {
public:
    PolyShape(std::string_view keyword, int order, std::vector<double> coefficients);

    std::string_view keyword() const override { return keyword_; }
    bool is_costly() const override { return true; }
    Bounds bounds() const override { return bounds_; }
    Bounds language_extent() const override { return Bounds::everything(); }
    bool inside(const Vec3& p) const override { return value(p) <= 0.0; }
    Vec3 normal(const Vec3& p, const Crossing& at) const override;
    std::optional<TriangleMesh> tessellate(double tolerance) const override;
    std::string describe() const override;

    template <class Sink>
    void each_crossing(const ShapeRay& query, Sink&& sink) const {
        Roots roots;
        const size_t n = find(query, roots);
        for (size_t i = 0; i < n; ++i) sink(roots[i], 0u, Vec2{0.0});
    }

private:
    using Roots = std::array<double, 3 * most_degree>;
    size_t find(const ShapeRay& query, Roots& out) const;
    double value(const Vec3& p) const;
    /// For numbers or intervals.
    template <class T>
    std::array<T, 3> gradient(const T& x, const T& y, const T& z) const;
    Vec3 gradient(const Vec3& p) const;
    std::optional<GradientBound> slopes(const Bounds& region) const override;
    bool starts_here(const ShapeRay& query) const;
    void along(const Vec3& o, const Vec3& d, std::span<double> out) const;
    void along_sparse(const Vec3& o, const Vec3& d, std::span<double> out) const;

    std::string keyword_;
    int order_;
    std::vector<double> c_;
    Bounds bounds_;
    std::vector<uint8_t> z_powers_;  ///< of each power of x and y: 1 + the highest power of z with them, or 0
};

/// Reads the coefficients of `order` in the language's order.
ShapePtr read_poly(BlockReader& in, std::string_view keyword, int order);

}  // namespace rb
