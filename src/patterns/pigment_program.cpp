#include "patterns/pigment_program.h"

#include "patterns/registry.h"

#include <algorithm>

namespace rb {

namespace {

ColorMap default_map_of(const Pattern& pattern) {
    const PatternKind* kind = find_pattern(pattern.keyword());
    if (kind && kind->list_size > 0) {
        ColorMap list;
        for (const Color& color : kind->default_list)
            list.push_back({static_cast<float>(list.size()), color});
        if (!list.empty()) return list;
    }
    if (kind && kind->default_map && pattern.takes_default_map()) return kind->default_map();
    return {{0.0f, {0, 0, 0, 0, 0}}, {1.0f, {1, 1, 1, 0, 0}}};
}

bool usable(const Color& quick) {
    return quick.red != -1.0f && quick.green != -1.0f && quick.blue != -1.0f && quick.filter != -1.0f &&
           quick.transmit != -1.0f;
}

}  // namespace

PigmentProgram::PigmentProgram(const Pigment& pigment, const PatternSettings& settings, bool quick) {
    if (quick && pigment.quick_color && usable(*pigment.quick_color)) {
        color_ = *pigment.quick_color;
        return;
    }
    if (const auto* color = std::get_if<Color>(&pigment.source)) {
        color_ = *color;
        return;
    }
    uv_mapping_ = pigment.uv_mapping;
    if (pigment.average) {
        field_ = PatternField(nullptr, pigment.modifiers, settings);
        kind_ = Kind::average;
    } else if (const auto* pattern = std::get_if<PatternPtr>(&pigment.source); pattern && *pattern) {
        field_ = PatternField(*pattern, pigment.modifiers, settings);
    } else {
        return;
    }
    use_map(pigment, settings);
}

void PigmentProgram::use_map(const Pigment& pigment, const PatternSettings& settings) {
    if (const auto* map = std::get_if<BlendMap<PigmentPtr>>(&pigment.map); map && !map->empty()) {
        if (kind_ != Kind::average) kind_ = Kind::children;
        positions_ = MapPositions::of(*map);
        bool plain = true;
        for (const auto& entry : *map) {
            children_.emplace_back(*entry.value, settings);
            plain = plain && children_.back().is_constant();
        }
        if (kind_ == Kind::children && plain) {
            for (const PigmentProgram& child : children_) colors_.push_back(child.constant());
            children_.clear();
            kind_ = Kind::colors;
        }
        return;
    }
    if (const auto* map = std::get_if<ColorMap>(&pigment.map); map && !map->empty()) {
        set_colors(*map);
    } else if (kind_ == Kind::average) {
        kind_ = Kind::constant;
    } else {
        set_colors(default_map_of(*std::get<PatternPtr>(pigment.source)));
    }
}

void PigmentProgram::set_colors(const ColorMap& map) {
    if (kind_ != Kind::average) kind_ = Kind::colors;
    positions_ = MapPositions::of(map);
    for (const auto& entry : map) {
        colors_.push_back(entry.value);
        if (kind_ != Kind::average) continue;
        Pigment plain;
        plain.source = entry.value;
        children_.emplace_back(plain, PatternSettings{});
    }
}

bool PigmentProgram::passes_light() const {
    const auto passes = [](const Color& c) { return c.filter != 0.0f || c.transmit != 0.0f; };
    return (kind_ == Kind::constant && passes(color_)) ||
           std::any_of(colors_.begin(), colors_.end(), passes) ||
           std::any_of(children_.begin(), children_.end(),
                       [](const PigmentProgram& child) { return child.passes_light(); });
}

bool PigmentProgram::needs_surface() const {
    return uv_mapping_ || field_.needs_surface() ||
           std::any_of(children_.begin(), children_.end(),
                       [](const PigmentProgram& child) { return child.needs_surface(); });
}

void PigmentProgram::evaluate(const PatternSamples& samples, std::span<Color> out) const {
    if (kind_ == Kind::constant) {
        std::fill(out.begin(), out.end(), color_);
        return;
    }
    Scratch::Scope memory(thread_scratch());
    const auto points = uv_mapping_ ? uv_points(samples, memory) : samples.points;
    const PatternSamples moved = samples.at(carried(field_, points, memory));
    switch (kind_) {
        case Kind::colors:
            return evaluate_colors(moved, out);
        case Kind::children:
            return evaluate_children(moved, out);
        default:
            return evaluate_average(moved, out);
    }
}

void PigmentProgram::evaluate_colors(const PatternSamples& moved, std::span<Color> out) const {
    Scratch::Scope memory(thread_scratch());
    const auto values = memory.take<double>(out.size());
    field_.values(moved, values);
    for (size_t i = 0; i < out.size(); ++i) {
        const MapPlace place = positions_.find(values[i]);
        const Color& a = colors_[place.first];
        if (place.first == place.second) {
            out[i] = a;
            continue;
        }
        const Color& b = colors_[place.second];
        const auto t = static_cast<float>(place.t);
        out[i] = {a.red + t * (b.red - a.red), a.green + t * (b.green - a.green),
                  a.blue + t * (b.blue - a.blue), a.filter + t * (b.filter - a.filter),
                  a.transmit + t * (b.transmit - a.transmit)};
    }
}

void PigmentProgram::evaluate_children(const PatternSamples& moved, std::span<Color> out) const {
    Scratch::Scope memory(thread_scratch());
    const auto values = memory.take<double>(out.size());
    field_.values(moved, values);
    const BlendParts parts = split_by_entry(positions_, values, memory);
    std::fill(out.begin(), out.end(), Color{});
    for (size_t k = 0; k < children_.size(); ++k) {
        const auto rows = parts.rows_of(k);
        if (rows.empty()) continue;
        Scratch::Scope part_memory(thread_scratch());
        const auto colors = part_memory.take<Color>(rows.size());
        children_[k].evaluate(gather(moved, rows, part_memory), colors);
        const auto weights = parts.weights_of(k);
        for (size_t i = 0; i < rows.size(); ++i) out[rows[i]] = out[rows[i]] + colors[i] * weights[i];
    }
}

void PigmentProgram::evaluate_average(const PatternSamples& moved, std::span<Color> out) const {
    Scratch::Scope memory(thread_scratch());
    const auto colors = memory.take<Color>(out.size());
    std::fill(out.begin(), out.end(), Color{});
    float total = 0;
    for (size_t k = 0; k < children_.size(); ++k) {
        const float weight = positions_.positions[k];
        total += weight;
        children_[k].evaluate(moved, colors);
        for (size_t i = 0; i < out.size(); ++i) out[i] = out[i] + colors[i] * weight;
    }
    if (total == 0.0f) return;
    for (Color& color : out) color = color * (1.0f / total);
}

}  // namespace rb
