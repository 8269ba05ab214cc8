#include "shapes/function_cells.h"

namespace rb {

namespace {

CellSign sign_of(const Interval& v) {
    if (v.maybe_nan || (v.lo <= 0.0 && v.hi >= 0.0)) return CellSign::unclear;
    return v.hi < 0.0 ? CellSign::below : CellSign::above;
}

}  // namespace

FunctionCells::FunctionCells(const Bounds& box, const std::function<Interval(const Bounds&)>& value)
    : box_(box), step_(box.size() / static_cast<double>(side)) {
    look(value, 0, 0, 0, side);
    uint16_t places = 0;
    for (size_t i = 0; i < count; ++i) {
        if (unclear_[i]) place_[i] = places++;
    }
    details_ = std::make_unique<Detail[]>(places);
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
    const CellSign sign = sign_of(value(widened_cube(x, y, z, width)));
    if (sign == CellSign::unclear && width > 1) {
        const int half = width / 2;
        for (int k = 0; k < 8; ++k)
            look(value, x + (k & 1) * half, y + (k >> 1 & 1) * half, z + (k >> 2) * half, half);
        return;
    }
    for (int k = z; k < z + width; ++k) {
        for (int j = y; j < y + width; ++j) {
            for (int i = x; i < x + width; ++i) {
                unclear_[index(i, j, k)] = sign == CellSign::unclear;
                below_[index(i, j, k)] = sign == CellSign::below;
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

void FunctionCells::find(size_t cell, const Bound& bound, Detail& detail) const {
    const auto number = static_cast<int>(cell);
    const Bounds b = widened_cube(number % side, number / side % side, number / (side * side), 1);
    for (int axis = 0; axis < 3; ++axis) {
        std::array<IntervalSlope, 3> place;
        for (int i = 0; i < 3; ++i)
            place[static_cast<size_t>(i)] = {{b.lo[i], b.hi[i]}, Interval(i == axis ? 1.0 : 0.0)};
        const IntervalSlope v = bound(place);
        const Interval s = v.slope.maybe_nan ? Interval::everything() : v.slope;
        constexpr float inf = std::numeric_limits<float>::infinity();
        const auto lo = std::nextafter(static_cast<float>(s.lo), -inf);
        const auto hi = std::nextafter(static_cast<float>(s.hi), inf);
        detail.ends[static_cast<size_t>(2 * axis)].store(lo, std::memory_order_relaxed);
        detail.ends[static_cast<size_t>(2 * axis + 1)].store(hi, std::memory_order_relaxed);
        if (axis == 0) detail.sign.store(sign_of(v.value), std::memory_order_relaxed);
    }
    detail.known.store(true, std::memory_order_release);
}

FunctionCells::Content FunctionCells::content(const Detail& detail, const Vec3& direction) {
    Content content{detail.sign.load(std::memory_order_relaxed), Interval(0.0)};
    if (content.sign != CellSign::unclear) return content;
    for (int i = 0; i < 3; ++i) {
        const auto end = [&](int k) {
            return static_cast<double>(
                detail.ends[static_cast<size_t>(2 * i + k)].load(std::memory_order_relaxed));
        };
        content.slope += Interval(end(0), end(1)) * Interval(direction[i]);
    }
    return content;
}

}  // namespace rb
