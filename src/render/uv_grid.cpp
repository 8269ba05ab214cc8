#include "render/uv_grid.h"

#include <algorithm>
#include <cmath>

namespace rb {

namespace {

constexpr size_t most_cells_along = 1024;
/// Entries for each triangle; with more the grid is made coarser.
constexpr size_t most_entries = 16;

double cross(const Vec2& a, const Vec2& b) { return a.x * b.y - a.y * b.x; }

}  // namespace

UvGrid::UvGrid(std::span<const Vec2> uvs, Triangles triangles) : uvs_(uvs), triangles_(triangles) {
    while (side_ * side_ < triangles_.size() && side_ < most_cells_along) side_ *= 2;
    while (side_ > 1 && entry_count() > most_entries * triangles_.size()) side_ /= 2;
    fill();
}

std::optional<UvGrid::Place> UvGrid::find(const Vec2& uv) const {
    const size_t cell = cell_of(uv.y) * side_ + cell_of(uv.x);
    for (uint32_t i = begins_[cell]; i < begins_[cell + 1]; ++i) {
        if (const auto place = place_in(listed_[i], uv)) return place;
    }
    return std::nullopt;
}

std::optional<UvGrid::Place> UvGrid::find_slowly(const Vec2& uv) const {
    for (uint32_t triangle = 0; triangle < triangles_.size(); ++triangle) {
        if (const auto place = place_in(triangle, uv)) return place;
    }
    return std::nullopt;
}

std::optional<UvGrid::Place> UvGrid::place_in(uint32_t triangle, const Vec2& uv) const {
    const auto& corners = triangles_[triangle];
    const Vec2& a = uvs_[corners[0]];
    const Vec2 to_b = uvs_[corners[1]] - a;
    const Vec2 to_c = uvs_[corners[2]] - a;
    const double area = cross(to_b, to_c);
    if (area == 0.0) return std::nullopt;
    const Vec2 to_uv = uv - a;
    const double b = cross(to_uv, to_c) / area;
    const double c = cross(to_b, to_uv) / area;
    if (!(b >= 0.0 && c >= 0.0 && b + c <= 1.0)) return std::nullopt;
    return Place{triangle, b, c};
}

size_t UvGrid::cell_of(double coordinate) const {
    const double place = coordinate * static_cast<double>(side_);
    if (!(place > 0.0)) return 0;
    return static_cast<size_t>(std::min(place, static_cast<double>(side_ - 1)));
}

UvGrid::Cells UvGrid::cells_of(uint32_t triangle) const {
    const auto& corners = triangles_[triangle];
    const Vec2& a = uvs_[corners[0]];
    const Vec2& b = uvs_[corners[1]];
    const Vec2& c = uvs_[corners[2]];
    const Vec2 lo = glm::min(glm::min(a, b), c);
    const Vec2 hi = glm::max(glm::max(a, b), c);
    const double length = std::max(hi.x - lo.x, hi.y - lo.y);
    // Rounding places points in slivers (and what is not finite) far from where they are.
    constexpr double sliver = 1e-7;
    if (!(std::abs(cross(b - a, c - a)) > sliver * length * length)) return {0, 0, side_ - 1, side_ - 1};
    constexpr double rounding = 1e-6;
    const double size = std::max({length, std::abs(lo.x), std::abs(lo.y), std::abs(hi.x), std::abs(hi.y)});
    const Vec2 slack{rounding * size};
    return {cell_of(lo.x - slack.x), cell_of(lo.y - slack.y), cell_of(hi.x + slack.x),
            cell_of(hi.y + slack.y)};
}

size_t UvGrid::entry_count() const {
    size_t count = 0;
    for (uint32_t triangle = 0; triangle < triangles_.size(); ++triangle) {
        const Cells cells = cells_of(triangle);
        count += (cells.x1 - cells.x0 + 1) * (cells.y1 - cells.y0 + 1);
    }
    return count;
}

void UvGrid::fill() {
    const auto each_entry = [&](auto&& visit) {
        for (uint32_t triangle = 0; triangle < triangles_.size(); ++triangle) {
            const Cells cells = cells_of(triangle);
            for (size_t y = cells.y0; y <= cells.y1; ++y) {
                for (size_t x = cells.x0; x <= cells.x1; ++x) visit(y * side_ + x, triangle);
            }
        }
    };
    begins_.assign(side_ * side_ + 1, 0);
    each_entry([&](size_t cell, uint32_t) { ++begins_[cell + 1]; });
    for (size_t cell = 0; cell < side_ * side_; ++cell) begins_[cell + 1] += begins_[cell];
    listed_.resize(begins_.back());
    std::vector<uint32_t> next(begins_.begin(), begins_.end() - 1);
    each_entry([&](size_t cell, uint32_t triangle) { listed_[next[cell]++] = triangle; });
}

}  // namespace rb
