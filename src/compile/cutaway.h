#pragma once
#include "compile/solids.h"
#include "compile/world.h"

#include <utility>

namespace rb {

/// What a leaf without texture below `cutaway_textures` shows (spec: geometry 5.6): the textures of the
/// solids that contain the point.
struct Cutaway {
    uint32_t root = 0;  ///< the outermost compound that decides which hits count
    /// Shape nodes below it that wear something, ascending, and the surfaces that show it.
    std::vector<std::pair<uint32_t, uint32_t>> worn;
    uint32_t nothing = 0;  ///< the surface where no textured solid contains the point
};

/// Adds the surfaces that the cut shows at a world point, with equal weights.
void cut_surfaces_at(const SolidForest& solids, const Cutaway& cut, const Vec3& p,
                     std::vector<SurfaceWeight>& out);

/// The outermost compound above a shape node that decides which hits count; the node itself if there is none.
uint32_t deciding_root(const SolidForest& solids, uint32_t node);

/// True if `node` stands below `root` and is looked at: of a difference that is only the first child.
bool is_looked_at(const SolidForest& solids, uint32_t node, uint32_t root);

}  // namespace rb
