#include "shapes/function_cells.h"

namespace rb {

FunctionCells::FunctionCells(const Bounds& box, const std::function<Interval(const Bounds&)>& value)
    : box_(box), step_(box.size() / static_cast<double>(side)) {
    look(value, 0, 0, 0, side);
    uint16_t places = 0;
    for (size_t i = 0; i < count; ++i) {
        if (unclear_[i]) place_[i] = places++;
    }
    slopes_ = std::make_unique<Slopes[]>(places);
}

Bounds FunctionCells::cube(int x, int y, int z, int width) const {
    const Vec3 lo = box_.lo + step_ * Vec3(x, y, z);
    return {lo, glm::min(lo + step_ * static_cast<double>(width), box_.hi)};
}

Bounds FunctionCells::widened_cube(int x, int y, int z, int width) const {
    const Bounds cell = cube(x, y, z, width);
    const Vec3 margin = 1e-9 * box_.size();
    return {cell.lo - margin, cell.hi + margin};
}

void FunctionCells::look(const std::function<Interval(const Bounds&)>& value, int x, int y, int z,
                         int width) {
    const Interval v = value(widened_cube(x, y, z, width));
    const bool is_clear = !v.maybe_nan && (v.lo > 0.0 || v.hi < 0.0);
    if (!is_clear && width > 1) {
        const int half = width / 2;
        for (int k = 0; k < 8; ++k)
            look(value, x + (k & 1) * half, y + (k >> 1 & 1) * half, z + (k >> 2) * half, half);
        return;
    }
    for (int k = z; k < z + width; ++k) {
        for (int j = y; j < y + width; ++j) {
            for (int i = x; i < x + width; ++i) {
                unclear_[index(i, j, k)] = !is_clear;
                below_[index(i, j, k)] = is_clear && v.hi < 0.0;
            }
        }
    }
}

Bounds FunctionCells::hull(bool with_above, bool with_below) const {
    Bounds hull;
    for (int z = 0; z < side; ++z) {
        for (int y = 0; y < side; ++y) {
            for (int x = 0; x < side; ++x) {
                const CellSign s = sign(index(x, y, z));
                if ((s == CellSign::above && !with_above) || (s == CellSign::below && !with_below)) continue;
                hull.include(cube(x, y, z, 1));
            }
        }
    }
    return hull;
}

void FunctionCells::find_slopes(size_t cell, const Bound& bound, Slopes& slopes) const {
    const auto number = static_cast<int>(cell);
    const Bounds b = widened_cube(number % side, number / side % side, number / (side * side), 1);
    for (int axis = 0; axis < 3; ++axis) {
        std::array<IntervalSlope, 3> place;
        for (int i = 0; i < 3; ++i)
            place[static_cast<size_t>(i)] = {{b.lo[i], b.hi[i]}, Interval(i == axis ? 1.0 : 0.0)};
        Interval s = bound(place).slope;
        if (s.maybe_nan) s = Interval::everything();
        constexpr float inf = std::numeric_limits<float>::infinity();
        const auto lo = std::nextafter(static_cast<float>(s.lo), -inf);
        const auto hi = std::nextafter(static_cast<float>(s.hi), inf);
        slopes.ends[static_cast<size_t>(2 * axis)].store(lo, std::memory_order_relaxed);
        slopes.ends[static_cast<size_t>(2 * axis + 1)].store(hi, std::memory_order_relaxed);
    }
    slopes.known.store(true, std::memory_order_release);
}

Interval FunctionCells::slope(size_t cell, const Vec3& direction, const Bound& bound) const {
    Slopes& slopes = slopes_[place_[cell]];
    if (!slopes.known.load(std::memory_order_acquire)) find_slopes(cell, bound, slopes);
    Interval sum(0.0);
    for (int i = 0; i < 3; ++i) {
        const auto end = [&](int k) {
            return static_cast<double>(
                slopes.ends[static_cast<size_t>(2 * i + k)].load(std::memory_order_relaxed));
        };
        sum += Interval(end(0), end(1)) * Interval(direction[i]);
    }
    return sum;
}

}  // namespace rb
