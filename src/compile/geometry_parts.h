#pragma once
#include "compile/flatten.h"
#include "compile/geometry.h"
#include "kdtree/kdtree.h"

namespace rb {

/// What a ray needs of a leaf, close together.
struct Element {
    const Shape* shape = nullptr;
    uint32_t leaf = 0;
    uint8_t mask = 0;
    bool in_world_space = false;
    bool tests_hits = false;
    float object_stretch = 1;  ///< bound on how lengths grow from world to object
    /// Ball around what can be hit, a little enlarged; infinite radius where there is none.
    Vec3 center{0.0};
    double radius = std::numeric_limits<double>::infinity();
};

/// Bound on a hit's distance to the true surface: coordinate error times (scale * magnitude + offset).
struct ElementError {
    double scale = 1;
    double offset = 0;
};

struct Geometry::Parts {
    FlatGeometry flat;
    std::vector<Element> listed;  ///< infinite ones, or all when they are few: no tree
    std::vector<Element> treed;   ///< numbered as in `tree`
    KdTree tree;
    std::vector<uint32_t> element_of_leaf;  ///< index into listed, then treed
    std::vector<ElementError> errors;       ///< by leaf
    uint8_t all_masks = 0;
};

/// Sets up the queries over flattened solids. With `brute_force` every element is listed.
std::shared_ptr<const Geometry> make_geometry(FlatGeometry flat, bool brute_force);

}  // namespace rb
