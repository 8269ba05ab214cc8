#pragma once
#include "compile/world.h"

#include <unordered_map>

namespace rb {

/// Gives equal looks one Surface: thousands of copies of a declared object share it, so shading can group by
/// it.
class SurfaceTable {
public:
    explicit SurfaceTable(std::vector<Surface>& surfaces) : surfaces_(surfaces) {}

    /// Index of an equal surface, or of the new one. The transform of a texture that is the same everywhere
    /// is dropped first.
    uint32_t add(Surface surface);

    /// No light passes such a texture (spec: shading 6.2, "opaque").
    bool opaque(const TexturePtr& texture);
    bool opaque(const Surface& surface);
    /// Such a texture shows one colour and no place.
    bool same_everywhere(const TexturePtr& texture);

private:
    struct Facts {
        TexturePtr texture;  ///< stays, so that its address cannot become another one's
        bool opaque = false;
        bool same_everywhere = true;
    };
    const Facts& facts(const TexturePtr& texture);

    std::vector<Surface>& surfaces_;
    std::unordered_multimap<size_t, uint32_t> by_hash_;
    std::unordered_map<const TextureLayers*, Facts> facts_;
};

}  // namespace rb
