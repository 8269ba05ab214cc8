#pragma once
#include "compile/world.h"

namespace rb {

class Compound;  // compile/compound.h
using CompoundPtr = std::shared_ptr<const Compound>;

/// What a Compound looks like, as far as its copies agree.
struct CompoundLooks {
    std::vector<Surface>
        surfaces;  ///< in the Compound's space; Compound::texture_of_copy() where copies decide
    std::vector<WorldInterior> interiors;
    std::array<uint32_t, 2> shared_interiors{no_surface, no_surface};  ///< of opaque things without interior
    uint32_t interior_of_copy = no_surface;                            ///< stands for the copy's own
    size_t top_objects = 0;
    /// No texture of its own shows where it is, and no interior's identity matters.
    bool same_in_all_copies = true;

    bool is_shared_interior(uint32_t i) const { return i == shared_interiors[0] || i == shared_interiors[1]; }
};

/// What the surfaces and interiors of a Compound are in one of its copies: indices into the lists of the
/// world (or of the outer Compound), by the Compound's own numbers. Shared by copies that look the same.
struct InstanceLook {
    std::vector<uint32_t> surfaces;
    std::vector<uint32_t> interiors;

    friend bool operator==(const InstanceLook&, const InstanceLook&) = default;
};

/// A copy of a Compound. Where it stands is written in its leaf.
struct Instance {
    CompoundPtr compound;
    std::shared_ptr<const InstanceLook> look;
    double world_stretch = 1;  ///< bound on how lengths grow from the Compound's space to the world
};

}  // namespace rb
