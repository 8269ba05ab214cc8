#include "scene/media.h"

#include <algorithm>

namespace rb {

MediaPtr transformed(const MediaPtr& media, const Transform& map) {
    const auto is_plain = [](const DensityPtr& d) { return std::holds_alternative<Color>(d->source); };
    if (map.is_identity() || std::ranges::all_of(media->densities, is_plain)) return media;
    auto out = std::make_shared<Media>(*media);
    for (DensityPtr& density : out->densities) {
        if (is_plain(density)) continue;
        auto moved = std::make_shared<Density>(*density);
        moved->modifiers = transformed(moved->modifiers, map);
        density = std::move(moved);
    }
    return out;
}

std::vector<MediaPtr> transformed(std::vector<MediaPtr> media, const Transform& map) {
    for (MediaPtr& m : media) m = transformed(m, map);
    return media;
}

}  // namespace rb
