#include "shade/texture_program.h"

#include "math/vec.h"

#include <algorithm>
#include <cmath>

namespace rb {

namespace {

float largest(const Rgb& c) { return std::max({c.x, c.y, c.z}); }

/// Cosine below which cosine^exponent is lost even under very bright light.
double highlight_threshold(double exponent) {
    constexpr double invisible = 1e-12;
    return exponent > 0.0 ? std::pow(invisible, 1.0 / exponent) : 0.0;
}

}  // namespace

FinishProgram::FinishProgram(const Finish& written, const TextureSettings& settings)
    : finish(written),
      brilliance(static_cast<double>(written.brilliance)),
      phong_size(static_cast<double>(written.phong_size)),
      roughness(static_cast<double>(written.roughness_exponent)) {
    own_light = written.ambient * settings.ambient_light + written.emission;
    if (!settings.highlights) finish.phong = finish.specular = 0;
    is_translucent = settings.subsurface && written.translucency.has_value();
    if (is_translucent) finish.diffuse = finish.diffuse_back = 0.0f;
    takes_light = finish.diffuse != 0.0f || finish.diffuse_back != 0.0f || finish.phong != 0.0f ||
                  finish.specular != 0.0f;
    takes_indirect_light = finish.raw_diffuse != 0.0f || finish.raw_diffuse_back != 0.0f;
    has_highlights = finish.phong > 0.0f || finish.specular > 0.0f;
    const Reflection& r = written.reflection;
    reflects = settings.quality >= 8 && (r.min != Rgb(0.0f) || r.max != Rgb(0.0f));
    reflection_importance = std::max(largest(r.min), largest(r.max));
    phong_threshold = highlight_threshold(written.phong_size);
    if (written.phong_size >= 60.0f) phong_threshold = std::max(phong_threshold, 0.0008);
    specular_threshold = highlight_threshold(written.roughness_exponent);
}

FinishProgramPtr TextureCompiler::finish(const Finish* written) {
    static const Finish plain;
    if (!written) written = &plain;
    FinishProgramPtr& known = finishes_[written];
    if (!known) known = std::make_shared<FinishProgram>(*written, settings);
    return known;
}

TextureProgram::TextureProgram(const TextureLayers& written, TextureCompiler& compiler) {
    for (size_t i = written.size(); i-- > 0;) {
        if (written[i].is_patterned()) {
            add_children(written[i], compiler);
            return;
        }
        if (layers.empty()) layers.reserve(i + 1);
        add_layer(written[i], compiler);
    }
}

void TextureProgram::add_layer(const Texture& texture, TextureCompiler& compiler) {
    static const Pigment black;
    const TextureSettings& settings = compiler.settings;
    LayerProgram layer{
        PigmentProgram(texture.pigment ? *texture.pigment : black, settings.patterns, settings.quality <= 5),
        nullptr, compiler.finish(texture.finish.get())};
    if (texture.normal && settings.quality >= 8) {
        layer.normal = std::make_shared<NormalProgram>(*texture.normal, settings.patterns);
    }
    surface_need = std::max(surface_need, layer.pigment.surface_need());
    if (layer.normal) surface_need = std::max(surface_need, layer.normal->surface_need());
    passes_light = passes_light || layer.pigment.passes_light();
    has_fresnel = has_fresnel || (layer.finish->reflects && layer.finish->finish.reflection.fresnel);
    is_matt = is_matt && surface_need != SurfaceNeed::view && !passes_light && !layer.finish->reflects &&
              layer.finish->finish.irid_amount == 0.0f;
    layers.push_back(std::move(layer));
}

void TextureProgram::add_children(const Texture& texture, TextureCompiler& compiler) {
    TextureMapProgram chosen;
    chosen.average = texture.average;
    chosen.uv_mapping = texture.uv_mapping;
    chosen.field = PatternField(texture.average ? nullptr : texture.pattern, texture.modifiers,
                                compiler.settings.patterns);
    chosen.positions = MapPositions::of(texture.map);
    surface_need =
        std::max(chosen.uv_mapping ? SurfaceNeed::place : SurfaceNeed::none, chosen.field.surface_need());
    for (const auto& entry : texture.map) {
        chosen.children.emplace_back(*entry.value, compiler);
        const TextureProgram& child = chosen.children.back();
        surface_need = std::max(surface_need, child.surface_need);
        passes_light = passes_light || child.passes_light;
        has_fresnel = has_fresnel || child.has_fresnel;
        is_matt = is_matt && child.is_matt;
    }
    is_matt = is_matt && surface_need != SurfaceNeed::view;
    map = std::make_shared<TextureMapProgram>(std::move(chosen));
}

}  // namespace rb
