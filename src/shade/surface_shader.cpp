#include "shade/surface_shader.h"

#include <algorithm>
#include <cmath>

namespace rb {

/// A part of a group: which hits, at which pattern points, and how much each counts in a blend.
struct SurfaceShader::Rows {
    std::span<const uint32_t> hits;   ///< indices into StreamState::hits
    std::span<const uint32_t> roots;  ///< rows of the group
    std::span<const Vec3> points;
    std::span<const float> shares;

    size_t size() const { return hits.size(); }
};

/// What the layers of a texture have done so far, per row.
struct SurfaceShader::LayerStack {
    std::span<Rgb> color;
    std::span<Rgb> filter;
    std::span<float> through;
    std::span<Vec3> top_normal;
    std::span<MirrorRecord> mirrors;  ///< as many as there may be
    size_t mirror_count = 0;
    bool is_top = true;
};

void SurfaceShader::shade(const Look& look, std::span<const uint32_t> hits) {
    Scratch::Scope memory(thread_scratch());
    const TextureProgram& texture = program_.textures[look.texture];
    const auto roots = memory.take<uint32_t>(hits.size());
    const auto points = memory.take<Vec3>(hits.size());
    const auto* transform = look.transform.empty() ? nullptr : &std::get<Transform>(look.transform.front());
    for (size_t i = 0; i < hits.size(); ++i) {
        const HitPoint& hit = state_.hits[hits[i]];
        roots[i] = static_cast<uint32_t>(i);
        points[i] = hit.point;
        if (hit.uv_mapping) {
            const Vec2& uv = state_.uv[hits[i]];
            points[i] = {uv.x, uv.y, 0.0};
        }
        if (transform) points[i] = transform->inverse_point(points[i]);
    }
    const bool several = texture.is_patterned() || texture.layers.size() > 1;
    lights_ = program_.light_lists[look.lights];
    ShadowMemory shadows(hits.size(), lights_.size(), several, memory);
    if (state_.indirect) indirect_.begin(hits.size(), memory);
    const std::span<const Warp> chain = look.transform;
    const Chains enclosing{&chain, transform ? size_t{1} : size_t{0}};
    shade_rows(texture, {hits, roots, points, memory.take<float>(hits.size(), 1.0f)}, enclosing, shadows);
}

void SurfaceShader::shade_rows(const TextureProgram& texture, const Rows& rows, Chains enclosing,
                               ShadowMemory& memory) {
    if (state_.indirect) indirect_.leave_texture(rows.roots);
    if (texture.is_patterned()) {
        shade_children(texture, rows, enclosing, memory);
    } else if (texture.layers.size() == 1 && state_.limits.adc_bailout < 1.0f) {
        shade_single(texture.layers.front(), rows, enclosing, memory);
    } else {
        shade_layers(texture, rows, enclosing, memory);
    }
}

void SurfaceShader::shade_children(const TextureProgram& texture, const Rows& rows, Chains enclosing,
                                   ShadowMemory& shadows) {
    Scratch::Scope memory(thread_scratch());
    const TextureMapProgram& map = *texture.map;
    const SurfaceSamples surface = state_.samples();
    const PatternSamples samples{rows.points, &surface, rows.hits};
    const PatternSamples moved = map.moved(samples, memory);
    const auto chains = memory.take<std::span<const Warp>>(enclosing.size() + 1, std::span<const Warp>{});
    std::copy(enclosing.begin(), enclosing.end(), chains.begin());
    chains[enclosing.size()] = map.field.modifiers().warps;

    if (map.average) {
        float total = 0;
        for (const float weight : map.positions.positions) total += weight;
        const auto shares = memory.take<float>(rows.size());
        for (size_t k = 0; k < map.children.size(); ++k) {
            const float part = total == 0.0f ? 1.0f : map.positions.positions[k] / total;
            for (size_t i = 0; i < rows.size(); ++i) shares[i] = rows.shares[i] * part;
            shade_rows(map.children[k], {rows.hits, rows.roots, moved.points, shares}, chains, shadows);
        }
        return;
    }
    const auto values = memory.take<double>(rows.size());
    map.field.values(moved, values);
    const BlendParts parts = split_by_entry(map.positions, values, memory);
    // The later of two entries first, as its normals are what the patterns of the other one see (slope).
    for (size_t k = map.children.size(); k-- > 0;) {
        const auto chosen = parts.rows_of(k);
        if (chosen.empty()) continue;
        Scratch::Scope part_memory(thread_scratch());
        const auto hits = part_memory.take<uint32_t>(chosen.size());
        const auto roots = part_memory.take<uint32_t>(chosen.size());
        const auto part_points = part_memory.take<Vec3>(chosen.size());
        const auto shares = part_memory.take<float>(chosen.size());
        const auto weights = parts.weights_of(k);
        for (size_t i = 0; i < chosen.size(); ++i) {
            hits[i] = rows.hits[chosen[i]];
            roots[i] = rows.roots[chosen[i]];
            part_points[i] = moved.points[chosen[i]];
            shares[i] = rows.shares[chosen[i]] * weights[i];
        }
        shade_rows(map.children[k], {hits, roots, part_points, shares}, chains, shadows);
    }
}

void SurfaceShader::shade_layers(const TextureProgram& texture, const Rows& rows, Chains enclosing,
                                 ShadowMemory& shadows) {
    Scratch::Scope memory(thread_scratch());
    const size_t count = rows.size();
    LayerStack stack;
    stack.color = memory.take<Rgb>(count, Rgb(0.0f));
    stack.filter = memory.take<Rgb>(count, Rgb(1.0f));
    stack.through = memory.take<float>(count, 1.0f);
    stack.top_normal = memory.take<Vec3>(count);
    const auto reflecting = std::count_if(texture.layers.begin(), texture.layers.end(),
                                          [](const LayerProgram& layer) { return layer.finish->reflects; });
    stack.mirrors = memory.take<MirrorRecord>(count * static_cast<size_t>(reflecting));
    const auto active = memory.take<uint32_t>(count);
    for (const LayerProgram& layer : texture.layers) {
        size_t active_count = 0;
        for (size_t i = 0; i < count; ++i) {
            if (stack.through[i] > state_.limits.adc_bailout) {
                active[active_count++] = static_cast<uint32_t>(i);
            }
        }
        if (active_count == 0) break;
        shade_layer(layer, rows, active.first(active_count), enclosing, stack, shadows);
        stack.is_top = false;
    }
    for (size_t i = 0; i < count; ++i) {
        const HitPoint& hit = state_.hits[rows.hits[i]];
        state_.slots[state_.ray_of(hit).slot].rgb += hit.weight * rows.shares[i] * stack.color[i];
    }
    send_on(texture, rows, stack);
}

void SurfaceShader::normals_of(const LayerProgram& layer, const PatternSamples& samples,
                               std::span<const uint32_t> hits, Chains enclosing, std::span<Vec3> normals) {
    for (size_t i = 0; i < hits.size(); ++i) normals[i] = state_.hits[hits[i]].normal;
    if (!layer.normal) return;
    const bool unit_length = !layer.normal->keeps_length();
    for (const auto& chain : enclosing) normals_into(chain, unit_length, normals);
    layer.normal->perturb(samples, normals);
    for (size_t k = enclosing.size(); k-- > 0;) normals_out_of(enclosing[k], unit_length, normals);
    for (size_t i = 0; i < hits.size(); ++i) {
        normals[i] = glm::normalize(normals[i]);
        if (program_.needs_samples) state_.seen_normals[hits[i]] = normals[i];
    }
}

Rgb SurfaceShader::own_light(const LayerProgram& layer, const LitRow& lit) const {
    if (program_.options.quality <= 1) return lit.place.pigment;
    return layer.finish->own_light * lit.place.pigment * lit.place.opacity + lit.light;
}

/// Normals, pigments and direct light of one layer.
SurfaceShader::LitLayer SurfaceShader::light_layer(const LayerProgram& layer, const Rows& rows,
                                                   Chains enclosing, ShadowMemory& shadows,
                                                   std::span<const Rgb> filters, Scratch::Scope& memory) {
    const size_t count = rows.size();
    const LitLayer layer_rows{memory.take<LitRow>(count), memory.take<Color>(count)};
    Scratch::Scope scratch(thread_scratch());
    const SurfaceSamples surface = state_.samples();
    const PatternSamples samples{rows.points, &surface, rows.hits};
    const auto normals = scratch.take<Vec3>(count);
    normals_of(layer, samples, rows.hits, enclosing, normals);
    layer.pigment.evaluate(samples, layer_rows.pigments);

    const FinishProgram& finish = *layer.finish;
    for (size_t i = 0; i < count; ++i) {
        const HitPoint& hit = state_.hits[rows.hits[i]];
        const Color& p = layer_rows.pigments[i];
        LitRow& row = layer_rows.lit[i];
        row.hit = rows.hits[i];
        row.root = rows.roots[i];
        row.double_illuminate = hit.double_illuminate;
        row.place.normal = normals[i];
        row.place.direction = hit.direction;
        row.place.pigment = p.rgb();
        row.place.opacity = program_.before_37
                                ? 1.0f - (p.filter * std::max({p.red, p.green, p.blue}) + p.transmit)
                                : opacity(p);
        if (finish.finish.irid_amount > 0.0f) {
            row.place.irid_thickness = film_thickness(finish, hit.point, program_.patterns.noise_generator);
        }
        row.light = Rgb(0.0f);
    }
    if (finish.takes_light && program_.options.quality > 1 && state_.wants_light) {
        light_.add(finish, layer_rows.lit, lights_, shadows);
        if (program_.shows_photons()) photons_.add(finish, layer_rows.lit);
    }
    if (finish.is_translucent && state_.wants_light) {
        for (LitRow& row : layer_rows.lit) {
            const HitPoint& hit = state_.hits[row.hit];
            row.light += subsurface_.at(hit, row.place.normal, finish, row.place.pigment,
                                        secondary_.relative_ior(hit, finish), lights_);
        }
    }
    if (state_.indirect && finish.takes_indirect_light) indirect_.add(finish, layer_rows.lit, filters);
    return layer_rows;
}

/// What a translucent body lets through of what is behind it.
void SurfaceShader::go_straight_through(const LayerProgram& layer, const LitRow& lit, const Rgb& weight) {
    const HitPoint& hit = state_.hits[lit.hit];
    const auto passage = subsurface_.straight_through(hit, lit.place.normal, *layer.finish, lit.place.pigment,
                                                      secondary_.relative_ior(hit, *layer.finish));
    if (passage) secondary_.pass_on(hit, passage->exit, passage->direction, weight * passage->left);
}

/// A texture of a single layer, which most are: nothing to stack.
void SurfaceShader::shade_single(const LayerProgram& layer, const Rows& rows, Chains enclosing,
                                 ShadowMemory& shadows) {
    Scratch::Scope memory(thread_scratch());
    const auto [lit, pigments] = light_layer(layer, rows, enclosing, shadows, {}, memory);
    for (size_t i = 0; i < rows.size(); ++i) {
        const HitPoint& hit = state_.hits[rows.hits[i]];
        state_.slots[state_.ray_of(hit).slot].rgb += hit.weight * rows.shares[i] * own_light(layer, lit[i]);
    }
    if (layer.finish->is_translucent) {
        for (size_t i = 0; i < rows.size(); ++i) go_straight_through(layer, lit[i], Rgb(rows.shares[i]));
    }
    const bool mirrors = layer.finish->reflects;
    for (size_t i = 0; i < rows.size(); ++i) {
        const bool clear = pigments[i].filter != 0.0f || pigments[i].transmit != 0.0f;
        if (!clear && !mirrors) continue;
        const HitPoint& hit = state_.hits[rows.hits[i]];
        const Vec3& normal = lit[i].place.normal;
        MirrorRecord mirror;
        if (mirrors) mirror = mirror_of(layer, lit[i], 1.0f, rows.shares[i]);
        const Rgb filter = passed(pigments[i]) * kept(layer, mirror);
        const float through = std::min(1.0f, std::abs(grey(filter)));
        bool total_reflection = false;
        if (through > state_.limits.adc_bailout && program_.options.quality >= 6 &&
            state_.may_refract(rows.hits[i])) {
            total_reflection =
                secondary_.transmit(hit, {layer.finish.get(), normal, filter, through, rows.shares[i]});
        }
        if (mirror.amount != Rgb(0.0f) && !total_reflection && state_.may_reflect(rows.hits[i]))
            secondary_.reflect(hit, mirror);
    }
}

void SurfaceShader::shade_layer(const LayerProgram& layer, const Rows& rows, std::span<const uint32_t> active,
                                Chains enclosing, LayerStack& stack, ShadowMemory& shadows) {
    Scratch::Scope memory(thread_scratch());
    const size_t count = active.size();
    Rows chosen = rows;
    if (count < rows.size()) {
        const auto hits = memory.take<uint32_t>(count);
        const auto roots = memory.take<uint32_t>(count);
        const auto points = memory.take<Vec3>(count);
        for (size_t i = 0; i < count; ++i) {
            hits[i] = rows.hits[active[i]];
            roots[i] = rows.roots[active[i]];
            points[i] = rows.points[active[i]];
        }
        chosen = {hits, roots, points, {}};
    }
    std::span<Rgb> filters;
    if (state_.indirect) {
        filters = memory.take<Rgb>(count);
        for (size_t i = 0; i < count; ++i) filters[i] = stack.filter[active[i]];
    }
    const auto [lit, pigments] = light_layer(layer, chosen, enclosing, shadows, filters, memory);
    for (size_t i = 0; i < count; ++i) {
        const uint32_t row = active[i];
        if (stack.is_top) stack.top_normal[row] = lit[i].place.normal;
        if (program_.options.quality <= 1) {
            stack.color[row] = lit[i].place.pigment;
        } else {
            stack.color[row] += stack.filter[row] * own_light(layer, lit[i]);
        }
        if (layer.finish->is_translucent)
            go_straight_through(layer, lit[i], stack.filter[row] * rows.shares[row]);
        MirrorRecord mirror;
        if (layer.finish->reflects) {
            mirror = mirror_of(layer, lit[i], stack.through[row], rows.shares[row]);
            mirror.row = row;
            stack.mirrors[stack.mirror_count++] = mirror;
        }
        stack.filter[row] *= passed(pigments[i]) * kept(layer, mirror);
        stack.through[row] = std::min(1.0f, std::abs(grey(stack.filter[row])));
    }
}

/// `through`: what the layers above let through.
MirrorRecord SurfaceShader::mirror_of(const LayerProgram& layer, const LitRow& lit, float through,
                                      float share) const {
    const HitPoint& hit = state_.hits[lit.hit];
    const double cosine = -glm::dot(lit.place.direction, lit.place.normal);
    const bool fresnel = layer.finish->finish.reflection.fresnel;
    const double ior = fresnel ? secondary_.relative_ior(hit, *layer.finish) : 1.0;
    const Reflectivity r = reflectivity(*layer.finish, cosine, ior, lit.place.pigment);
    float importance = state_.ray_of(hit).importance * through * r.importance;
    // Measured: mirrored photons are given up by the square.
    if (state_.carries_photons) importance *= r.importance;
    return {0, layer.finish.get(), lit.place.normal, r.amount, importance, share};
}

/// What a mirror leaves for the light from below it.
Rgb SurfaceShader::kept(const LayerProgram& layer, const MirrorRecord& mirror) {
    if (!layer.finish->finish.conserve_energy) return Rgb(1.0f);
    return glm::min(Rgb(1.0f), Rgb(1.0f) - mirror.amount);
}

void SurfaceShader::send_on(const TextureProgram& texture, const Rows& rows, const LayerStack& stack) {
    // Mirrors were noted layer by layer; rays leave hit by hit, so that their order does not depend on the
    // rest of the batch.
    Scratch::Scope memory(thread_scratch());
    const auto next = memory.take<size_t>(stack.mirror_count);
    const auto first = memory.take<size_t>(rows.size(), stack.mirror_count);
    for (size_t k = stack.mirror_count; k-- > 0;) {
        next[k] = first[stack.mirrors[k].row];
        first[stack.mirrors[k].row] = k;
    }
    for (size_t i = 0; i < rows.size(); ++i) {
        const HitPoint& hit = state_.hits[rows.hits[i]];
        bool total_reflection = false;
        if (stack.through[i] > state_.limits.adc_bailout && program_.options.quality >= 6 &&
            state_.may_refract(rows.hits[i])) {
            total_reflection =
                secondary_.transmit(hit, {texture.layers.front().finish.get(), stack.top_normal[i],
                                          stack.filter[i], stack.through[i], rows.shares[i]});
        }
        if (!state_.may_reflect(rows.hits[i])) continue;
        for (size_t k = first[i]; k < stack.mirror_count; k = next[k]) {
            const MirrorRecord& mirror = stack.mirrors[k];
            if (mirror.amount == Rgb(0.0f)) continue;
            const Vec3 apart = glm::abs(mirror.normal - stack.top_normal[i]);
            if (total_reflection && max_component(apart) < 1e-10) continue;
            secondary_.reflect(hit, mirror);
        }
    }
}

}  // namespace rb
