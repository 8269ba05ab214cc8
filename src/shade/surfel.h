#pragma once
#include "compile/world.h"

#include <vector>

namespace rb {

/// A patch of a matt surface, as a ray that gathers meets it. Its light is the same from everywhere.
struct Surfel {
    Vec3 point{0.0};
    Vec3 normal{0.0};  ///< unit, turned towards the ray
    uint32_t leaf = no_leaf;
    uint32_t member = 0;
    uint32_t look = 0;
    double size = 0;  ///< length of the patch that the ray stands for
    Rgb light{0.0f};  ///< radiance that leaves it
};

/// Knows the light of surfels. Safe to ask from many threads.
class SurfelLight {
public:
    virtual ~SurfelLight() = default;

    /// False, and `light` untouched, if nothing is known of it; its own `light` is not looked at.
    virtual bool find(const Surfel& surfel, Rgb& light) const = 0;
};

/// How rays that gather make use of surfels.
struct SurfelUse {
    const SurfelLight* known = nullptr;    ///< never null
    double spread = 0;                     ///< size of surfels per length of the rays
    std::vector<Surfel>* fresh = nullptr;  ///< takes those that had to be shaded; may be null
};

}  // namespace rb
