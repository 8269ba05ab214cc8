#pragma once
#include "compile/flatten.h"
#include "compile/geometry.h"
#include "compile/slabs.h"
#include "kdtree/box_tree.h"

namespace rb {

constexpr uint32_t no_slabs = std::numeric_limits<uint32_t>::max();

/// What a ray needs of a leaf, close together.
struct Element {
    const Shape* shape = nullptr;
    uint32_t leaf = 0;
    RayMask mask = 0;
    bool in_world_space = false;
    bool tests_hits = false;
    bool is_costly = false;     ///< rays are cut to its box
    uint32_t slabs = no_slabs;  ///< index into Geometry::Parts::slabs
    float object_stretch = 1;   ///< bound on how lengths grow from world to object
    float radius = std::numeric_limits<float>::infinity();  ///< of a ball around a sphere, rounded outward
    Vec3f center{0.0f};
};

/// Where a listed element is an infinite plane in world space: normal 0 means it is none.
struct PlaneTest {
    Vec3 normal{0.0};
    double distance = 0;
};

/// Bound on a hit's distance to the true surface: coordinate error times (scale * magnitude + offset).
struct ElementError {
    double scale = 1;
    double offset = 0;
};

struct Geometry::Parts {
    FlatGeometry flat;
    std::vector<Element> elements;  ///< listed ones first, then those of the tree
    std::vector<PlaneTest> planes;  ///< of the listed elements
    std::vector<Slabs> slabs;       ///< of leaves of solids that have any
    uint32_t listed = 0;            ///< infinite ones
    BoxTree tree;                   ///< numbers its elements from `listed` on
    std::vector<uint32_t> element_of_leaf;
    std::vector<ElementError> errors;  ///< by leaf
    RayMask all_masks = 0;

    /// Of a hit on a leaf, or on a member of it if it is an instance.
    ElementError error_of(uint32_t leaf, uint32_t member) const {
        return flat.leaves[leaf].instance == no_surface ? errors[leaf] : error_of_member(leaf, member);
    }
    ElementError error_of_member(uint32_t leaf, uint32_t member) const;

    /// True if no ray of the bundle can meet a listed element, as far as that is easy to tell.
    bool passes_by(uint32_t element, const RayBundle& bundle) const {
        const PlaneTest& plane = planes[element];
        return plane.normal != Vec3{0.0} && bundle.misses_plane(plane.normal, plane.distance);
    }
    /// A leaf as an element of the tree.
    uint32_t boxed(uint32_t leaf) const {
        const uint32_t element = leaf < element_of_leaf.size() ? element_of_leaf[leaf] : no_leaf;
        return element != no_leaf && element >= listed ? element - listed : BoxList::no_element;
    }
};

/// True if a box fits a box tree: finite, also in single precision.
bool fits_tree(const Bounds& box);

/// Sets up the queries over flattened solids. With `brute_force` every element is listed.
std::shared_ptr<const Geometry> make_geometry(FlatGeometry flat, bool brute_force);

}  // namespace rb
