#include "compile/surfaces.h"

#include <functional>

namespace rb {

namespace {

bool clear_somewhere(const Color& color) { return color.filter != 0.0f || color.transmit != 0.0f; }

bool opaque_pigment(const Pigment& pigment) {
    if (const auto* color = std::get_if<Color>(&pigment.source)) return !clear_somewhere(*color);
    const auto* pattern = std::get_if<PatternPtr>(&pigment.source);
    if (pattern && (*pattern)->has_colors()) return !(*pattern)->passes_light();
    if (!pattern && !pigment.average) return true;
    if (const auto* colors = std::get_if<ColorMap>(&pigment.map)) {
        for (const auto& entry : *colors) {
            if (clear_somewhere(entry.value)) return false;
        }
        return true;
    }
    if (const auto* pigments = std::get_if<BlendMap<PigmentPtr>>(&pigment.map)) {
        for (const auto& entry : *pigments) {
            if (!opaque_pigment(*entry.value)) return false;
        }
        return true;
    }
    // A pattern's own default map: asking its colour is always right.
    return false;
}

size_t mix(size_t seed, size_t value) { return (seed ^ value) * 0x9e3779b97f4a7c15ULL + (seed >> 29); }

size_t hash_of(const WornTexture& worn) {
    size_t h = std::hash<const void*>{}(worn.layers.get());
    for (const Vec3& row : worn.world_from_texture->forward.row) {
        for (int i = 0; i < 3; ++i) h = mix(h, std::hash<double>{}(row[i]));
    }
    return h;
}

size_t hash_of(const Surface& s) {
    size_t h = hash_of(s.texture);
    if (s.interior_texture) h = mix(h, hash_of(*s.interior_texture));
    h = mix(h, s.interior);
    h = mix(h, s.photons.target);
    h = mix(h, 2 * s.lights.group + (s.lights.global ? 1u : 0u));
    return mix(h, (s.uv_mapping ? 1u : 0u) + (s.double_illuminate ? 2u : 0u));
}

bool equal(const WornTexture& a, const WornTexture& b) {
    return a.layers == b.layers && a.world_from_texture == b.world_from_texture;
}

bool equal(const Surface& a, const Surface& b) {
    if (a.interior_texture.has_value() != b.interior_texture.has_value()) return false;
    if (a.interior_texture && !equal(*a.interior_texture, *b.interior_texture)) return false;
    return equal(a.texture, b.texture) && a.interior == b.interior && a.uv_mapping == b.uv_mapping &&
           a.double_illuminate == b.double_illuminate && a.lights == b.lights && a.photons == b.photons &&
           a.texture_stays == b.texture_stays && a.interior_texture_stays == b.interior_texture_stays;
}

}  // namespace

const SurfaceTable::Facts& SurfaceTable::facts(const TexturePtr& texture) {
    const auto [at, is_new] = facts_.try_emplace(texture.get());
    Facts& facts = at->second;
    if (!is_new) return facts;
    facts.texture = texture;
    for (const Texture& layer : *texture) {
        if (!layer.is_patterned() && opaque_pigment(*layer.pigment)) facts.opaque = true;
        const bool plain = !layer.is_patterned() && !layer.normal &&
                           !std::holds_alternative<PatternPtr>(layer.pigment->source) &&
                           !layer.pigment->average && layer.finish->irid_amount == 0.0f &&
                           layer.finish->crand == 0.0f;
        if (!plain) facts.same_everywhere = false;
    }
    return facts;
}

bool SurfaceTable::same_everywhere(const TexturePtr& texture) { return facts(texture).same_everywhere; }

bool SurfaceTable::opaque(const TexturePtr& texture) { return facts(texture).opaque; }

bool SurfaceTable::opaque(const Surface& surface) {
    return opaque(surface.texture.layers) &&
           (!surface.interior_texture || opaque(surface.interior_texture->layers));
}

uint32_t SurfaceTable::add(Surface surface) {
    if (facts(surface.texture.layers).same_everywhere) surface.texture.world_from_texture = {};
    if (surface.interior_texture && facts(surface.interior_texture->layers).same_everywhere) {
        surface.interior_texture->world_from_texture = {};
    }
    const size_t hash = hash_of(surface);
    const auto [first, last] = by_hash_.equal_range(hash);
    for (auto it = first; it != last; ++it) {
        if (equal(surfaces_[it->second], surface)) return it->second;
    }
    const auto index = static_cast<uint32_t>(surfaces_.size());
    surfaces_.push_back(std::move(surface));
    by_hash_.emplace(hash, index);
    return index;
}

}  // namespace rb
