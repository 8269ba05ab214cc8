#pragma once
#include "kdtree/kdtree.h"
#include "scene/function.h"
#include "shapes/container.h"

namespace rb {

/// What a parametric statement says.
struct ParametricData {
    std::array<FunctionPtr, 3> functions;  ///< x, y and z of two parameters
    Vec2 lo{0.0}, hi{1.0};                 ///< the parameters' range
    Container container;
    double accuracy = 0.001;
    double max_gradient = 1;

    Vec3 at(const Vec2& uv) const;
};

/// A surface given by two parameters, as far as it lies in its container. Their range is cut into a grid of
/// cells; the boxes around them (by intervals; where functions have no narrow bounds, by samples) lie in a
/// tree. Within a cell that the ray's direction sees from one side there is at most one crossing, which
/// Newton's method finds on the true surface; other cells are cut further. A crossing's `at` is (u, v).
class Parametric final : public Shape {
public:
    explicit Parametric(ParametricData data);

    std::string_view keyword() const override { return "parametric"; }
    NormalRule normal_rule() const override { return NormalRule::differences; }
    Bounds bounds() const override { return bounds_; }
    Bounds language_extent() const override { return data_.container.box; }
    bool inside(const Vec3&) const override { return false; }
    bool is_patch() const override { return true; }
    void crossings(const ShapeRay& ray, Crossings& out) const override;
    bool closest(const ShapeRay& ray, const CrossingFilter* filter, Crossing& nearest) const override;
    /// By differences over `accuracy`, as the language has it.
    Vec3 normal(const Vec3& p, const Crossing& at) const override;
    std::optional<Vec2> uv(const Vec3&, const Crossing& at) const override { return at.at; }
    /// Where the container cuts the surface, or a function's slopes have no bound, there is no mesh.
    std::optional<TriangleMesh> tessellate(double tolerance) const override;
    std::string describe() const override;

private:
    static constexpr uint32_t side = 96;  ///< cells along each parameter
    struct Cell;
    struct Grid;
    class Search;
    Cell cell(uint32_t number) const;
    Bounds box_of(const Cell& cell) const;
    template <class Take>
    void each_crossing(const ShapeRay& query, const double& t_max, Take&& take) const;

    ParametricData data_;
    std::array<bool, 3> has_narrow_bounds_{};
    std::vector<Vec3> grid_;  ///< points at the corners of the cells
    KdTree tree_;
    Bounds bounds_;
};

}  // namespace rb
