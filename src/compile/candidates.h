#pragma once
#include "kdtree/box_list.h"

namespace rb {

/// What the rays of a bundle may meet: a few elements that are tried one by one. Made by
/// Geometry::candidates(); a query with it gives the same answer as without.
struct Candidates {
    static constexpr size_t most_listed = 4;
    std::array<uint32_t, most_listed> listed;  ///< infinite elements
    size_t listed_count = 0;
    BoxList boxes;

    bool none() const { return listed_count == 0 && boxes.is_empty(); }
};

}  // namespace rb
