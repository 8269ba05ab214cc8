#pragma once
#include "scene/shape.h"

namespace rb {

/// Heights over a grid, with the lowest and highest of ever larger squares of cells. Grid space: x and z
/// count columns and rows from 0, y is 0 to 65535.
class HeightGrid {
public:
    /// At least 2 x 2 heights, row after row, z = 0 first. `smooth` adds vertex normals.
    HeightGrid(int columns, int rows, std::vector<uint16_t> heights, bool smooth);

    struct Range {
        uint16_t lo = 0;
        uint16_t hi = 0;
    };

    int columns() const { return columns_; }
    int rows() const { return rows_; }
    double height(int x, int z) const { return heights_[index(x, z)]; }
    /// Of the square of 2^level cells to a side with that number; the last level has one square.
    Range range(size_t level, int x, int z) const;
    size_t top_level() const { return levels_.size(); }
    bool is_smooth() const { return !normals_.empty(); }
    /// Not unit, rounded to 16 bits as in the reference.
    Vec3 vertex_normal(int x, int z) const;

private:
    struct Level {
        int width = 0;
        std::vector<Range> ranges;
    };
    size_t index(int x, int z) const {
        return static_cast<size_t>(z) * static_cast<size_t>(columns_) + static_cast<size_t>(x);
    }
    void build_levels();
    void build_normals();

    int columns_;
    int rows_;
    std::vector<uint16_t> heights_;
    std::vector<Level> levels_;  ///< [0] is for squares of 2 x 2 cells
    std::vector<std::array<int16_t, 3>> normals_;
};

/// Two triangles a cell over a unit square, cut off below the water level; solid without end downwards.
/// A crossing's part is twice the cell's number, plus 1 for the triangle away from the cell's origin.
class HeightField final : public Shape {
public:
    /// `water` in grid space. The shape stands in the unit square until it is transformed.
    HeightField(std::shared_ptr<const HeightGrid> grid, double water);

    std::string_view keyword() const override { return "height_field"; }
    Bounds bounds() const override;
    Bounds language_extent() const override;
    Bounds solid_bounds() const override;
    bool inside(const Vec3& p) const override;
    bool is_faceted() const override { return true; }
    NormalRule normal_rule() const override {
        return grid_->is_smooth() ? NormalRule::interpolated : NormalRule::of_surface;
    }
    void crossings(const ShapeRay& ray, Crossings& out) const override;
    bool closest(const ShapeRay& ray, const CrossingFilter* filter, Crossing& nearest) const override;
    bool any(const ShapeRay& ray, const CrossingFilter* filter, Crossing& found) const override;
    Vec3 normal(const Vec3& p, const Crossing& at) const override;
    ShapePtr transformed(const Transform& map) const override;
    /// Itself; nothing where water cuts it.
    std::optional<TriangleMesh> tessellate(double tolerance) const override;
    std::string describe() const override;

private:
    struct Node;
    class Walk;
    Bounds grid_box() const;
    template <class Take>
    bool each_candidate(const ShapeRay& ray, const double& t_max, Take&& take) const;
    std::array<Vec3, 3> triangle(uint32_t part) const;
    Vec3 grid_normal(uint32_t part) const;
    bool starts_in(const ShapeRay& ray, const Vec3& origin, uint32_t part) const;

    std::shared_ptr<const HeightGrid> grid_;
    double water_;
    Affine grid_from_space_;
    Affine space_from_grid_;
};

}  // namespace rb
