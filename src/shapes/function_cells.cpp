#include "shapes/function_cells.h"

namespace rb {

namespace {

CellSign sign_of(const Interval& v) {
    if (v.maybe_nan || (v.lo <= 0.0 && v.hi >= 0.0)) return CellSign::unclear;
    return v.hi < 0.0 ? CellSign::below : CellSign::above;
}

}  // namespace

FunctionCells::FunctionCells(const Bounds& box, Value value)
    : box_(box), step_(box.size() / static_cast<double>(side)), value_(std::move(value)) {
    look(glm::ivec3(0), side);
}

FunctionCells::~FunctionCells() {
    for (std::atomic<Block*>& block : blocks_) delete block.load();
}

glm::ivec3 FunctionCells::place_of(size_t cell) {
    const auto block = static_cast<int>(cell / block_size);
    const auto within = static_cast<int>(cell % block_size);
    const auto along = [&](int block_stride, int stride) {
        return block / block_stride % blocks_aside * block_side + within / stride % block_side;
    };
    return {along(1, 1), along(blocks_aside, block_side),
            along(blocks_aside * blocks_aside, block_side * block_side)};
}

Bounds FunctionCells::cube(const glm::ivec3& at, int width) const {
    const Vec3 lo = box_.lo + step_ * Vec3(at);
    return {lo, glm::min(lo + step_ * static_cast<double>(width), box_.hi)};
}

Bounds FunctionCells::widened_cube(const glm::ivec3& at, int width) const {
    const Bounds cell = cube(at, width);
    const Vec3 margin = 1e-9 * box_.size();
    return {cell.lo - margin, cell.hi + margin};
}

void FunctionCells::look(const glm::ivec3& at, int width) {
    const CellSign sign = sign_of(value_(widened_cube(at, width)));
    if (sign == CellSign::unclear && width > block_side) {
        const int half = width / 2;
        for (int k = 0; k < 8; ++k) look(at + half * glm::ivec3(k & 1, k >> 1 & 1, k >> 2), half);
        return;
    }
    for (int z = at.z; z < at.z + width; z += block_side) {
        for (int y = at.y; y < at.y + width; y += block_side) {
            for (int x = at.x; x < at.x + width; x += block_side) {
                const size_t block = index(x, y, z) / block_size;
                unclear_[block] = sign == CellSign::unclear;
                below_[block] = sign == CellSign::below;
            }
        }
    }
}

/// Of threads that find the same one keeps it.
FunctionCells::Block& FunctionCells::open(size_t block) const {
    auto fresh = std::make_unique<Block>();
    for (size_t i = 0; i < block_size; ++i)
        fresh->cells[i].sign = sign_of(value_(widened_cube(place_of(block * block_size + i), 1)));
    Block* known = nullptr;
    if (blocks_[block].compare_exchange_strong(known, fresh.get(), std::memory_order_acq_rel))
        return *fresh.release();
    return *known;
}

Bounds FunctionCells::hull(bool with_above, bool with_below) const {
    const auto counts = [&](CellSign s) {
        return s == CellSign::unclear || (s == CellSign::below ? with_below : with_above);
    };
    glm::ivec3 lo(side);
    glm::ivec3 hi(0);
    for (size_t block = 0; block < block_count; ++block) {
        if (!counts(sign_of_block(block))) continue;
        const glm::ivec3 at = place_of(block * block_size);
        lo = glm::min(lo, at);
        hi = glm::max(hi, at + block_side);
    }
    if (lo.x >= hi.x) return {};
    // The outer cells of the outer blocks may do without.
    const auto is_empty = [&](int axis, int layer) {
        glm::ivec3 first = lo;
        glm::ivec3 last = hi;
        first[axis] = layer;
        last[axis] = layer + 1;
        for (int z = first.z; z < last.z; ++z) {
            for (int y = first.y; y < last.y; ++y) {
                for (int x = first.x; x < last.x; ++x) {
                    if (counts(sign(index(x, y, z)))) return false;
                }
            }
        }
        return true;
    };
    for (int axis = 0; axis < 3; ++axis) {
        if (is_empty(axis, lo[axis])) ++lo[axis];
        if (is_empty(axis, hi[axis] - 1)) --hi[axis];
    }
    return {box_.lo + step_ * Vec3(lo), glm::min(box_.lo + step_ * Vec3(hi), box_.hi)};
}

LinePlace FunctionCells::along(int axis, const Bounds& box) {
    LinePlace place;
    for (int i = 0; i < 3; ++i)
        place[static_cast<size_t>(i)] = {{box.lo[i], box.hi[i]}, Interval(i == axis ? 1.0 : 0.0)};
    return place;
}

void FunctionCells::find(size_t cell, const Bound& bound, Cell& detail) const {
    const Bounds b = widened_cube(place_of(cell), 1);
    for (int axis = 0; axis < 3; ++axis) {
        const IntervalSlope v = bound(along(axis, b));
        const Interval s = v.slope.maybe_nan ? Interval::everything() : v.slope;
        constexpr float inf = std::numeric_limits<float>::infinity();
        const auto lo = std::nextafter(static_cast<float>(s.lo), -inf);
        const auto hi = std::nextafter(static_cast<float>(s.hi), inf);
        detail.ends[static_cast<size_t>(2 * axis)].store(lo, std::memory_order_relaxed);
        detail.ends[static_cast<size_t>(2 * axis + 1)].store(hi, std::memory_order_relaxed);
        if (axis == 0) detail.closer.store(sign_of(v.value), std::memory_order_relaxed);
    }
    detail.known.store(true, std::memory_order_release);
}

FunctionCells::Content FunctionCells::content(const Cell& detail, const Vec3& direction) {
    Content content{detail.closer.load(std::memory_order_relaxed), Interval(0.0)};
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
