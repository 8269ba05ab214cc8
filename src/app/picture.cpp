#include "app/picture.h"

#include <algorithm>
#include <memory>

namespace rb {

namespace {

/// The film holds premultiplied light; files hold straight colours. Light brighter than its coverage raises
/// alpha.
std::array<float, 4> straight(const Radiance& pixel) {
    float alpha = 1.0f - pixel.transmit;
    const float brightness = grey(pixel.rgb);
    if (brightness > alpha) alpha = std::min(1.0f, brightness);
    const float divisor = alpha == 0.0f ? 1e-6f : alpha;
    return {pixel.rgb.x / divisor, pixel.rgb.y / divisor, pixel.rgb.z / divisor, alpha};
}

}  // namespace

Dithering dithering_of(const std::optional<GammaCurve>& assumed_gamma, const Settings& settings) {
    if (!settings.dither || is_linear(settings.file_type)) return {};
    const OutputEncoding encoding(assumed_gamma, settings.file_gamma);
    return {settings.dither_method, encoding.passes_unchanged() ? Curve() : encoding.file_curve()};
}

PixelRows picture_of(const Film& film, const std::optional<GammaCurve>& assumed_gamma,
                     const Settings& settings) {
    const OutputEncoding encoding(assumed_gamma, settings.file_gamma);
    const bool linear = is_linear(settings.file_type);
    const bool as_light = linear || settings.dither;
    std::shared_ptr<const CodeTable> codes;
    if (!as_light && output_bits(settings) == 8 && !encoding.passes_unchanged())
        codes = std::make_shared<CodeTable>(encoding);
    const auto encode = [encoding, as_light, codes](float v) {
        if (codes) return static_cast<float>(codes->code(v)) / 255.0f;
        return as_light ? encoding.linear(v) : encoding.encode(v);
    };
    const bool grayscale =
        settings.grayscale && (settings.file_type == FileType::png || settings.file_type == FileType::ppm);
    const bool has_alpha = settings.alpha && !(grayscale && settings.file_type == FileType::ppm) &&
                           settings.file_type != FileType::jpeg && settings.file_type != FileType::ppm &&
                           settings.file_type != FileType::hdr;
    const auto fill = [&film, encode, grayscale, has_alpha, linear](int y, std::span<float> row) {
        float* to = row.data();
        for (int x = 0; x < film.width; ++x) {
            const Radiance& pixel = film.at(x, y);
            // OpenEXR keeps premultiplied colours.
            const bool divide = has_alpha && !linear;
            const std::array<float, 4> value =
                divide ? straight(pixel)
                       : std::array<float, 4>{pixel.rgb.x, pixel.rgb.y, pixel.rgb.z, 1.0f - pixel.transmit};
            if (grayscale) {
                *to++ = encode(grey({value[0], value[1], value[2]}));
            } else {
                for (size_t c = 0; c < 3; ++c) *to++ = encode(value[c]);
            }
            if (has_alpha) *to++ = value[3];
        }
    };
    return {film.width, film.height, (grayscale ? 1 : 3) + (has_alpha ? 1 : 0), fill};
}

}  // namespace rb
