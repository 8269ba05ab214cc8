#include "shade/sky.h"

#include <algorithm>
#include <cmath>

namespace rb {

SkyProgram::SkyProgram(const std::optional<SkySphere>& sky, const std::optional<Color>& background,
                       const PatternSettings& settings, bool before_37, bool alpha_output)
    : has_background_(background.has_value()), before_37_(before_37) {
    if (background) background_ = *background;
    // Without alpha output a see-through background is black behind; with it mirrors show its plain colour.
    const float solid = has_background_ && !alpha_output ? 1.0f - background_.transmit : 1.0f;
    const Color opaque{background_.red * solid, background_.green * solid, background_.blue * solid, 0, 0};
    const Color open = has_background_ ? background_ : Color{0, 0, 0, 0, 1};
    ground_ = {Ground{opaque.rgb() * opacity(opaque), passed(opaque)},
               Ground{open.rgb() * opacity(open), passed(open)}};
    plain_ = {plain_background(false), plain_background(true)};
    if (!sky) return;
    emission_ = sky->emission;
    world_from_sky_ = sky->world_from_sky;
    for (size_t i = sky->pigments.size(); i-- > 0;) pigments_.emplace_back(*sky->pigments[i], settings);
}

void SkyProgram::put_background(const Rgb& filter, bool alpha, SkyLight& light) const {
    const Ground& ground = ground_[alpha ? 1 : 0];
    light.rgb += ground.light * filter;
    light.transmit = std::min(1.0f, std::abs(grey(filter * ground.passed)));
}

SkyLight SkyProgram::plain_background(bool alpha) const {
    if (before_37_) return alpha ? SkyLight{Rgb(0.0f), 1.0f} : SkyLight{background_.rgb(), 0.0f};
    SkyLight light;
    put_background(Rgb(1.0f), alpha, light);
    return light;
}

void SkyProgram::evaluate(std::span<const Vec3> directions, std::span<const uint8_t> shows_alpha,
                          std::span<SkyLight> out) const {
    Scratch::Scope memory(thread_scratch());
    const auto points = memory.take<Vec3>(directions.size());
    for (size_t i = 0; i < points.size(); ++i) points[i] = world_from_sky_.inverse_point(directions[i]);
    const auto colors = memory.take<Color>(out.size());
    const auto filters = memory.take<Color>(out.size(), Color{1, 1, 1, 1, 1});
    std::fill(out.begin(), out.end(), SkyLight{});
    const auto through = memory.take<float>(out.size(), 1.0f);
    for (const PigmentProgram& pigment : pigments_) {
        pigment.evaluate({points, nullptr, {}}, colors);
        for (size_t i = 0; i < out.size(); ++i) {
            const Color& c = colors[i];
            Color& f = filters[i];
            if (before_37_) {
                out[i].rgb += c.rgb() * (opacity(c) * through[i]);
                f = {f.red * c.red, f.green * c.green, f.blue * c.blue, f.filter * c.filter,
                     f.transmit * c.transmit};
                through[i] = std::abs(f.filter) + std::abs(f.transmit);
            } else {
                const Rgb filter = f.rgb();
                out[i].rgb += c.rgb() * opacity(c) * filter * emission_;
                const Rgb next = filter * passed(c);
                f = {next.x, next.y, next.z, 0, 0};
            }
        }
    }
    for (size_t i = 0; i < out.size(); ++i) {
        const bool alpha = shows_alpha[i] != 0;
        if (!before_37_) {
            put_background(filters[i].rgb(), alpha, out[i]);
        } else if (alpha) {
            out[i] = {Rgb(0.0f), 1.0f};
        } else {
            out[i] = {out[i].rgb * emission_ + background_.rgb() * passed(filters[i]), 0.0f};
        }
    }
}

}  // namespace rb
