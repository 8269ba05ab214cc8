#include "patterns/pigment_program.h"

#include "patterns/registry.h"

#include <algorithm>
#include <optional>
#include <vector>

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

double term_of(const Color& c, int term) { return c.terms()[static_cast<size_t>(term)]; }

void include(const Interval& more, std::optional<Interval>& all) { all = all ? hull(*all, more) : more; }

/// With what single precision may have made of it, where values up to `largest` are mixed.
Interval widened(const Interval& v, double largest) {
    const double slack = 1e-6 * largest;
    return {v.lo - slack, v.hi + slack, v.maybe_nan};
}

bool usable(const Color& quick) {
    return quick.red != -1.0f && quick.green != -1.0f && quick.blue != -1.0f && quick.filter != -1.0f &&
           quick.transmit != -1.0f;
}

}  // namespace

/// Pattern and map, with what the map holds.
struct PigmentProgram::Map {
    enum class Kind { picture, colors, children, average };

    /// True if there is something to choose from.
    bool take(const Pigment& pigment, const PatternSettings& settings);
    void evaluate(const PatternSamples& samples, std::span<Color> out) const;
    IntervalSlope bound(const LinePlace& place, int term) const;
    Interval range(int term) const;

    Kind kind = Kind::colors;
    bool uv_mapping = false;
    PatternField field;
    MapPositions positions;
    std::vector<Color> colors;
    std::vector<PigmentProgram> children;

private:
    void set_children(const BlendMap<PigmentPtr>& map, const PatternSettings& settings);
    void set_colors(const ColorMap& map);
    void evaluate_colors(const PatternSamples& carried, std::span<Color> out) const;
    void evaluate_children(const PatternSamples& carried, std::span<Color> out) const;
    void evaluate_average(const PatternSamples& carried, std::span<Color> out) const;
    Color color_at(double value) const;
    IntervalSlope bound_colors(const IntervalSlope& at, int term) const;
};

PigmentProgram::PigmentProgram(const Pigment& pigment, const PatternSettings& settings, bool quick) {
    if (quick && pigment.quick_color && usable(*pigment.quick_color)) {
        color_ = *pigment.quick_color;
    } else if (const auto* color = std::get_if<Color>(&pigment.source)) {
        color_ = *color;
    } else {
        auto map = std::make_shared<Map>();
        if (map->take(pigment, settings)) map_ = std::move(map);
    }
}

bool PigmentProgram::Map::take(const Pigment& pigment, const PatternSettings& settings) {
    const auto* pattern = std::get_if<PatternPtr>(&pigment.source);
    if (pigment.average) {
        kind = Kind::average;
    } else if (!pattern || !*pattern) {
        return false;
    }
    uv_mapping = pigment.uv_mapping;
    field = PatternField(pigment.average ? nullptr : *pattern, pigment.modifiers, settings);
    if (field.has_colors()) {
        kind = Kind::picture;
        return true;
    }
    if (const auto* map = std::get_if<BlendMap<PigmentPtr>>(&pigment.map); map && !map->empty()) {
        set_children(*map, settings);
    } else if (const auto* list = std::get_if<ColorMap>(&pigment.map); list && !list->empty()) {
        set_colors(*list);
    } else if (pigment.average) {
        return false;
    } else {
        set_colors(default_map_of(**pattern));
    }
    return true;
}

void PigmentProgram::Map::set_children(const BlendMap<PigmentPtr>& map, const PatternSettings& settings) {
    positions = MapPositions::of(map);
    bool plain = true;
    for (const auto& entry : map) {
        children.emplace_back(*entry.value, settings);
        plain = plain && children.back().is_constant();
    }
    if (kind == Kind::average) return;
    kind = plain ? Kind::colors : Kind::children;
    if (!plain) return;
    for (const PigmentProgram& child : children) colors.push_back(child.constant());
    children.clear();
}

void PigmentProgram::Map::set_colors(const ColorMap& map) {
    positions = MapPositions::of(map);
    for (const auto& entry : map) {
        colors.push_back(entry.value);
        if (kind != Kind::average) continue;
        Pigment plain;
        plain.source = entry.value;
        children.emplace_back(plain, PatternSettings{});
    }
}

bool PigmentProgram::passes_light() const {
    const auto passes = [](const Color& c) { return c.filter != 0.0f || c.transmit != 0.0f; };
    if (!map_) return passes(color_);
    return map_->field.passes_light() || std::any_of(map_->colors.begin(), map_->colors.end(), passes) ||
           std::any_of(map_->children.begin(), map_->children.end(),
                       [](const PigmentProgram& child) { return child.passes_light(); });
}

SurfaceNeed PigmentProgram::surface_need() const {
    if (!map_) return SurfaceNeed::none;
    SurfaceNeed need =
        std::max(map_->uv_mapping ? SurfaceNeed::place : SurfaceNeed::none, map_->field.surface_need());
    for (const PigmentProgram& child : map_->children) need = std::max(need, child.surface_need());
    return need;
}

void PigmentProgram::evaluate(const PatternSamples& samples, std::span<Color> out) const {
    if (map_) return map_->evaluate(samples, out);
    std::fill(out.begin(), out.end(), color_);
}

void PigmentProgram::Map::evaluate(const PatternSamples& samples, std::span<Color> out) const {
    Scratch::Scope memory(thread_scratch());
    const auto points = uv_mapping ? uv_points(samples, memory) : samples.points;
    const PatternSamples moved = samples.at(carried(field, points, memory));
    switch (kind) {
        case Kind::picture:
            return field.colors(moved, out);
        case Kind::colors:
            return evaluate_colors(moved, out);
        case Kind::children:
            return evaluate_children(moved, out);
        case Kind::average:
            return evaluate_average(moved, out);
    }
}

void PigmentProgram::Map::evaluate_colors(const PatternSamples& moved, std::span<Color> out) const {
    Scratch::Scope memory(thread_scratch());
    const auto values = memory.take<double>(out.size());
    field.values(moved, values);
    for (size_t i = 0; i < out.size(); ++i) out[i] = color_at(values[i]);
}

Color PigmentProgram::Map::color_at(double value) const {
    const MapPlace place = positions.find(value);
    const Color& a = colors[place.first];
    if (place.first == place.second) return a;
    const Color& b = colors[place.second];
    const auto t = static_cast<float>(place.t);
    return {a.red + t * (b.red - a.red), a.green + t * (b.green - a.green), a.blue + t * (b.blue - a.blue),
            a.filter + t * (b.filter - a.filter), a.transmit + t * (b.transmit - a.transmit)};
}

void PigmentProgram::Map::evaluate_children(const PatternSamples& moved, std::span<Color> out) const {
    Scratch::Scope memory(thread_scratch());
    const auto values = memory.take<double>(out.size());
    field.values(moved, values);
    const BlendParts parts = split_by_entry(positions, values, memory);
    std::fill(out.begin(), out.end(), Color{});
    for (size_t k = 0; k < children.size(); ++k) {
        const auto rows = parts.rows_of(k);
        if (rows.empty()) continue;
        Scratch::Scope part_memory(thread_scratch());
        const auto part = part_memory.take<Color>(rows.size());
        children[k].evaluate(gather(moved, rows, part_memory), part);
        const auto weights = parts.weights_of(k);
        for (size_t i = 0; i < rows.size(); ++i) out[rows[i]] = out[rows[i]] + part[i] * weights[i];
    }
}

void PigmentProgram::Map::evaluate_average(const PatternSamples& moved, std::span<Color> out) const {
    Scratch::Scope memory(thread_scratch());
    const auto part = memory.take<Color>(out.size());
    std::fill(out.begin(), out.end(), Color{});
    float total = 0;
    for (size_t k = 0; k < children.size(); ++k) {
        const float weight = positions.positions[k];
        total += weight;
        children[k].evaluate(moved, part);
        for (size_t i = 0; i < out.size(); ++i) out[i] = out[i] + part[i] * weight;
    }
    if (total == 0.0f) return;
    for (Color& color : out) color = color * (1.0f / total);
}

IntervalSlope PigmentProgram::bound(const LinePlace& place, int term) const {
    return map_ ? map_->bound(place, term) : IntervalSlope(term_of(color_, term));
}

Interval PigmentProgram::range(int term) const {
    return map_ ? map_->range(term) : Interval(term_of(color_, term));
}

IntervalSlope PigmentProgram::Map::bound(const LinePlace& place, int term) const {
    if (kind == Kind::colors && positions.sorted) {
        const IntervalSlope at = field.bound(place);
        if (!at.value.maybe_nan) return bound_colors(at, term);
    }
    return IntervalSlope::jumping(range(term));
}

/// Whatever the pattern gives; nothing is known of pictures, nor of averages, whose weights may be negative.
Interval PigmentProgram::Map::range(int term) const {
    if (kind != Kind::colors && kind != Kind::children) return Interval::everything();
    std::optional<Interval> all;
    for (const Color& color : colors) include(term_of(color, term), all);
    for (const PigmentProgram& child : children) include(child.range(term), all);
    return widened(*all, abs(*all).hi);
}

/// Over the pieces of the map that the pattern's values meet.
IntervalSlope PigmentProgram::Map::bound_colors(const IntervalSlope& at, int term) const {
    const Interval& v = at.value;
    if (v.is_point()) return term_of(color_at(v.lo), term);
    const auto value = [&](size_t k) { return term_of(colors[k], term); };
    const auto position = [&](size_t k) { return double{positions.positions[k]}; };
    const size_t last = colors.size() - 1;
    std::optional<Interval> values;
    std::optional<Interval> slopes;
    double largest = 0.0;
    const auto include_level = [&](size_t k) {
        include(value(k), values);
        include(0.0, slopes);
    };
    if (v.lo < position(0)) include_level(0);
    if (v.hi > position(last)) include_level(last);
    for (size_t k = 1; k <= last; ++k) {
        const double from = position(k - 1);
        const double to = position(k);
        if (v.hi < from || v.lo > to) continue;
        largest = std::max({largest, std::abs(value(k - 1)), std::abs(value(k))});
        if (from == to) {
            include(hull(value(k - 1), value(k)), values);
            if (value(k - 1) != value(k)) include(Interval::everything(), slopes);
            continue;
        }
        const Interval slope = (Interval(value(k)) - value(k - 1)) / (Interval(to) - from);
        const Interval part = Interval(std::max(v.lo, from), std::min(v.hi, to)) - from;
        include(value(k - 1) + part * slope, values);
        include(slope, slopes);
    }
    return chain(widened(*values, largest), *slopes, at);
}

}  // namespace rb
