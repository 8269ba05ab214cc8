#include "patterns/texels.h"

#include <algorithm>
#include <cmath>

namespace rb {

namespace {

/// Of files that say nothing themselves; linear where their numbers are taken as they are.
Curve usual_curve(ImageType type, const Texels::Decoding& decoding) {
    switch (type) {
        case ImageType::png:
        case ImageType::jpeg:
        case ImageType::tga:
        case ImageType::gif:
        case ImageType::bmp:
            return decoding.guesses_srgb ? Curve(SrgbCurve{}) : decoding.working;
        case ImageType::exr:
        case ImageType::hdr:
            return Curve();
        default:
            return decoding.working;
    }
}

}  // namespace

Texels::Texels(const ImageSource& source, const Decoding& decoding) : image_(source.image) {
    if (source.gamma) {
        file_ = Curve(*source.gamma);
        if (decoding.is_color && decoding.converts) working_ = decoding.working;
    } else if (decoding.is_color && decoding.converts) {
        file_ = image_->curve ? Curve(*image_->curve) : usual_curve(image_->type, decoding);
        working_ = decoding.working;
    }
    converts_ = !file_.same_as(working_);
    has_alpha_ = image_->channels == 2 || image_->channels == 4;
    premultiplied_ = has_alpha_ && (image_->type == ImageType::tiff || image_->type == ImageType::exr);
    divides_by_alpha_ = source.premultiplied && has_alpha_ && !premultiplied_ && decoding.is_color;
    if (image_->has_palette()) {
        fill_palette();
    } else if (image_->floats.empty()) {
        fill_table();
    }
}

float Texels::decoded_float(float value) const {
    return converts_ ? working_.encode(file_.decode(value)) : value;
}

void Texels::fill_table() {
    const auto white = static_cast<float>(image_->white);
    table_.reserve(image_->white + 1);
    for (uint32_t k = 0; k <= image_->white; ++k)
        table_.push_back(decoded_float(static_cast<float>(k) / white));
    if (image_->type != ImageType::png || image_->channels != 1 || image_->white > 255) return;
    // The reference stores these as bytes again, by way of three equal channels.
    for (float& v : table_) v = std::trunc((0.297f * v + 0.589f * v + 0.114f * v) * 255.0f) / 255.0f;
}

void Texels::fill_palette() {
    for (const auto& entry : image_->palette) {
        const auto share = [&](size_t c) { return static_cast<float>(entry[c]) / 255.0f; };
        palette_.push_back({decoded_float(share(0)), decoded_float(share(1)), decoded_float(share(2)), 0.0f,
                            1.0f - share(3)});
        has_alpha_ = has_alpha_ || entry[3] != 255;
    }
}

void Texels::set_filter(size_t entry, float filter) { palette_[entry].filter = filter; }
void Texels::set_transmit(size_t entry, float transmit) { palette_[entry].transmit = transmit; }

void Texels::filter_all(float filter) {
    filter_all_ = filter;
    for (Color& entry : palette_) entry.filter = filter;
}

void Texels::transmit_all(float transmit) {
    transmit_all_ = transmit;
    for (Color& entry : palette_) entry.transmit = transmit;
}

bool Texels::passes_light() const {
    const auto passes = [](const Color& c) { return c.filter != 0.0f || c.transmit != 0.0f; };
    return has_alpha_ || filter_all_ != 0.0f || transmit_all_ != 0.0f ||
           std::ranges::any_of(palette_, passes);
}

Color Texels::at(int x, int y) const {
    const size_t i = image_->index(x, y);
    if (!palette_.empty()) {
        const size_t entry = image_->samples[i];
        return entry < palette_.size() ? palette_[entry] : Color{};
    }
    const bool grey = image_->channels <= 2;
    Color out{decoded(i), grey ? 0.0f : decoded(i + 1), grey ? 0.0f : decoded(i + 2), filter_all_,
              transmit_all_};
    if (grey) out.green = out.blue = out.red;
    if (!has_alpha_) return out;
    const size_t a = i + static_cast<size_t>(image_->channels) - 1;
    const float alpha = image_->floats.empty()
                            ? static_cast<float>(image_->samples[a]) / static_cast<float>(image_->white)
                            : image_->floats[a];
    if (divides_by_alpha_ && alpha != 0.0f) {
        out.red /= alpha;
        out.green /= alpha;
        out.blue /= alpha;
    }
    out.transmit += 1.0f - alpha;
    return out;
}

Color Texels::divided(const Color& mixed) const {
    const float alpha = 1.0f - (mixed.transmit - transmit_all_);
    constexpr float least = 1e-6f;
    if (!premultiplied_ || alpha <= least) return mixed;
    return {mixed.red / alpha, mixed.green / alpha, mixed.blue / alpha, mixed.filter, mixed.transmit};
}

uint32_t Texels::index(int x, int y) const {
    const size_t i = image_->index(x, y);
    if (image_->has_palette()) return image_->samples[i];
    return static_cast<uint32_t>(std::clamp(255.0f * decoded(i), 0.0f, 65535.0f));
}

}  // namespace rb
