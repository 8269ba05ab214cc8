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
    ShadowMemory shadows(hits.size(), program_.lights.size(), several, memory);
    const std::span<const Warp> chain = look.transform;
    const Chains enclosing{&chain, transform ? size_t{1} : size_t{0}};
    shade_rows(texture, {hits, roots, points, memory.take<float>(hits.size(), 1.0f)}, enclosing, shadows);
}

void SurfaceShader::shade_rows(const TextureProgram& texture, const Rows& rows, Chains enclosing,
                               ShadowMemory& memory) {
    if (texture.is_patterned()) {
        shade_children(texture, rows, enclosing, memory);
    } else {
        shade_layers(texture, rows, enclosing, memory);
    }
}

void SurfaceShader::shade_children(const TextureProgram& texture, const Rows& rows, Chains enclosing,
                                   ShadowMemory& shadows) {
    Scratch::Scope memory(thread_scratch());
    const SurfaceSamples surface = state_.samples();
    const PatternSamples samples{rows.points, &surface, rows.hits};
    const auto points = texture.uv_mapping ? uv_points(samples, memory) : rows.points;
    // What is mapped by surface coordinates does not follow what is around it.
    if (texture.uv_mapping) enclosing = {};
    const PatternSamples moved = samples.at(carried(texture.field, points, memory));
    const auto chains = memory.take<std::span<const Warp>>(enclosing.size() + 1, std::span<const Warp>{});
    std::copy(enclosing.begin(), enclosing.end(), chains.begin());
    chains[enclosing.size()] = texture.field.modifiers().warps;

    if (texture.average) {
        float total = 0;
        for (const float weight : texture.positions.positions) total += weight;
        const auto shares = memory.take<float>(rows.size());
        for (size_t k = 0; k < texture.children.size(); ++k) {
            const float part = total == 0.0f ? 1.0f : texture.positions.positions[k] / total;
            for (size_t i = 0; i < rows.size(); ++i) shares[i] = rows.shares[i] * part;
            shade_rows(texture.children[k], {rows.hits, rows.roots, moved.points, shares}, chains, shadows);
        }
        return;
    }
    const auto values = memory.take<double>(rows.size());
    texture.field.values(moved, values);
    const BlendParts parts = split_by_entry(texture.positions, values, memory);
    for (size_t k = 0; k < texture.children.size(); ++k) {
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
        shade_rows(texture.children[k], {hits, roots, part_points, shares}, chains, shadows);
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
                                          [](const LayerProgram& layer) { return layer.finish.reflects; });
    stack.mirrors = memory.take<MirrorRecord>(count * static_cast<size_t>(reflecting));
    const auto active = memory.take<uint32_t>(count);
    for (const LayerProgram& layer : texture.layers) {
        size_t active_count = 0;
        for (size_t i = 0; i < count; ++i) {
            if (stack.through[i] > program_.world.settings.adc_bailout) {
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
    if (layer.normal->uv_mapping()) enclosing = {};
    const bool unit_length = !layer.normal->keeps_length();
    for (const auto& chain : enclosing) normals_into(chain, unit_length, normals);
    layer.normal->perturb(samples, normals);
    for (size_t k = enclosing.size(); k-- > 0;) normals_out_of(enclosing[k], unit_length, normals);
    for (size_t i = 0; i < hits.size(); ++i) {
        normals[i] = glm::normalize(normals[i]);
        state_.seen_normals[hits[i]] = normals[i];
    }
}

Rgb SurfaceShader::own_light(const LayerProgram& layer, const LitRow& lit) const {
    return layer.finish.own_light * lit.place.pigment * lit.place.opacity + lit.light;
}

void SurfaceShader::shade_layer(const LayerProgram& layer, const Rows& rows, std::span<const uint32_t> active,
                                Chains enclosing, LayerStack& stack, ShadowMemory& shadows) {
    Scratch::Scope memory(thread_scratch());
    const size_t count = active.size();
    const auto hits = memory.take<uint32_t>(count);
    const auto points = memory.take<Vec3>(count);
    for (size_t i = 0; i < count; ++i) {
        hits[i] = rows.hits[active[i]];
        points[i] = rows.points[active[i]];
    }
    const SurfaceSamples surface = state_.samples();
    const PatternSamples samples{points, &surface, hits};
    const auto normals = memory.take<Vec3>(count);
    normals_of(layer, samples, hits, enclosing, normals);
    const auto pigments = memory.take<Color>(count);
    layer.pigment.evaluate(samples, pigments);

    const auto lit = memory.take<LitRow>(count, LitRow{});
    const FinishProgram& finish = layer.finish;
    const bool full_color_only = program_.options.quality <= 1;
    for (size_t i = 0; i < count; ++i) {
        const HitPoint& hit = state_.hits[hits[i]];
        const Color& p = pigments[i];
        LitRow& row = lit[i];
        row.hit = hits[i];
        row.root = rows.roots[active[i]];
        row.place.normal = normals[i];
        row.place.direction = hit.direction;
        row.place.pigment = p.rgb();
        row.place.opacity = program_.before_37
                                ? 1.0f - (p.filter * std::max({p.red, p.green, p.blue}) + p.transmit)
                                : opacity(p);
        row.place.crand = finish.finish.crand;
        if (finish.finish.irid_amount > 0.0f) {
            row.place.irid_thickness = film_thickness(finish, hit.point, program_.patterns.noise_generator);
        }
    }
    if (finish.takes_light && !full_color_only) light_.add(finish, lit, shadows);

    for (size_t i = 0; i < count; ++i) {
        const uint32_t row = active[i];
        if (stack.is_top) stack.top_normal[row] = normals[i];
        Rgb kept(1.0f);
        if (full_color_only) {
            stack.color[row] = lit[i].place.pigment;
        } else {
            stack.color[row] += stack.filter[row] * own_light(layer, lit[i]);
            if (finish.reflects) {
                mirror(layer, row, lit[i], rows.shares[row], stack);
                const Rgb& amount = stack.mirrors[stack.mirror_count - 1].amount;
                if (finish.finish.conserve_energy) kept = glm::min(Rgb(1.0f), Rgb(1.0f) - amount);
            }
        }
        stack.filter[row] *= passed(pigments[i]) * kept;
        stack.through[row] = std::min(1.0f, std::abs(grey(stack.filter[row])));
    }
}

void SurfaceShader::mirror(const LayerProgram& layer, uint32_t row, const LitRow& lit, float share,
                           LayerStack& stack) {
    const HitPoint& hit = state_.hits[lit.hit];
    const double cosine = -glm::dot(lit.place.direction, lit.place.normal);
    const bool fresnel = layer.finish.finish.reflection.fresnel;
    const double ior = fresnel ? secondary_.relative_ior(hit, layer.finish) : 1.0;
    const Reflectivity r = reflectivity(layer.finish, cosine, ior, lit.place.pigment);
    const float importance = state_.ray_of(hit).importance * stack.through[row] * r.importance;
    stack.mirrors[stack.mirror_count++] = {row, &layer.finish, lit.place.normal, r.amount, importance, share};
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
        if (stack.through[i] > program_.world.settings.adc_bailout && program_.options.quality >= 6) {
            total_reflection = secondary_.transmit(hit, {&texture.layers.front().finish, stack.top_normal[i],
                                                         stack.filter[i], stack.through[i], rows.shares[i]});
        }
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
