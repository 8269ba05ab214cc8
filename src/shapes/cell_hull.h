#pragma once
#include "math/bounds.h"

namespace rb {

/// What a cell of space is to a solid.
enum class CellContent {
    none,  ///< surely nothing of it
    some,
    whole,  ///< all that matters: smaller cells would not tell more
};

/// Extends `hull` by the cells, halved `levels` times, that may hold a part of a solid: content_of(cell).
template <class ContentOf>
void add_cells(const ContentOf& content_of, const Bounds& cell, int levels, Bounds& hull) {
    if (hull.contains(cell.lo) && hull.contains(cell.hi)) return;
    const CellContent content = content_of(cell);
    if (content == CellContent::none) return;
    if (levels == 0 || content == CellContent::whole) {
        hull.include(cell);
        return;
    }
    const Vec3 middle = cell.center();
    for (int k = 0; k < 8; ++k) {
        Bounds part = cell;
        for (int i = 0; i < 3; ++i) ((k >> i & 1) ? part.lo[i] : part.hi[i]) = middle[i];
        add_cells(content_of, part, levels - 1, hull);
    }
}

}  // namespace rb
