#pragma once
#include "scene/function.h"
#include "scene/shape.h"
#include "shapes/function_cells.h"
#include "shapes/solid_mesh.h"

namespace rb {

/// What an isosurface statement says.
struct IsosurfaceData {
    FunctionPtr function;
    Bounds box{Vec3{-1.0}, Vec3{1.0}};  ///< the container, or the box around a sphere
    std::optional<double> radius;       ///< of a spherical container
    double threshold = 0;
    double accuracy = 0.001;
    double max_gradient = 1.1;
    bool open = false;
    size_t max_trace = 1;

    double size() const { return glm::length(box.size()); }
    double value(const Vec3& p) const;  ///< below 0 inside
    Interval bound(const Bounds& cell) const;
    bool contains(const Vec3& p) const;
};

/// True if bounds over small boxes do not shrink with the box (noise, patterns, pigments): rays step through
/// such a function by what is known of its slope.
bool has_loose_bounds(const IsosurfaceData& data);

/// True if the slope has a bound over cells of the size that rays look at; otherwise max_gradient is trusted.
bool has_bounded_slopes(const IsosurfaceData& data);

/// The steepest slope met between points of random chords near the surface: a lower bound of the right
/// max_gradient.
double steepest_slope(const IsosurfaceData& data);

/// Where a function equals its threshold within a container, whose own surface closes the solid unless
/// `open`. Part 0 is the function's surface, 1 to 6 are the container's sides (-x, +x, -y, ...), 7 its
/// sphere.
class Isosurface final : public Shape, private PointSolid {
public:
    explicit Isosurface(IsosurfaceData data);

    std::string_view keyword() const override { return "isosurface"; }
    NormalRule normal_rule() const override { return NormalRule::differences; }
    Bounds bounds() const override { return bounds_; }
    Bounds language_extent() const override { return data_.box; }
    bool inside(const Vec3& p) const override { return data_.contains(p) && data_.value(p) <= 0.0; }
    void crossings(const ShapeRay& ray, Crossings& out) const override;
    bool closest(const ShapeRay& ray, const CrossingFilter* filter, Crossing& nearest) const override;
    Vec3 normal(const Vec3& p, const Crossing& at) const override;
    /// Not of an open one.
    std::optional<TriangleMesh> tessellate(double tolerance) const override;
    std::string describe() const override;

private:
    struct Span;
    class Search;
    bool enters_container(const ShapeRay& query, Span& span) const;
    uint32_t start_part(const ShapeRay& query) const;
    /// True if the function's value at a crossing, placed with this error, is not the threshold: it jumps
    /// there.
    bool is_jump(double value, double error) const;
    Vec3 gradient(const Vec3& p) const;
    std::optional<GradientBound> slopes(const Bounds& region) const override;
    std::optional<GradientBound> container_slopes(const Bounds& region) const;
    FunctionCells::Content content_of(size_t cell, const Vec3& direction) const;
    double side_distance(const Vec3& p, uint32_t& part) const;
    template <class Take>
    void each_crossing(const ShapeRay& query, Take&& take) const;

    IsosurfaceData data_;
    bool loose_;
    double resolution_;  ///< object units: what is thinner may be missed
    FunctionCells cells_;
    Bounds bounds_;
};

}  // namespace rb
