// height_field { IMAGE [water_level F] [smooth] }        IMAGE: a picture file, or function W, H { ... }
//   (manual 3.5.1.6)
#include "shapes/height_field_shape.h"
#include "shapes/registry.h"

#include <cmath>

#include <fmt/format.h>

namespace rb {

namespace {

/// Truncated, by the lower 16 bits.
uint16_t height(double v) {
    constexpr double period = 65536.0;
    const double whole = std::fmod(std::trunc(v), period);
    return std::isfinite(whole) ? static_cast<uint16_t>(static_cast<int32_t>(whole)) : uint16_t{0};
}

/// What the reference makes of pixels, measured (spec: geometry 11.2).
class HeightReader {
public:
    explicit HeightReader(const ImageSource& source)
        : image_(*source.image), to_16_bits_(65535.0 / image_.white) {
        if (source.gamma) curve_ = Curve(*source.gamma);
        decodes_ = source.gamma.has_value();
    }

    uint16_t at(int x, int y) const {
        const size_t i = image_.index(x, y);
        if (image_.has_palette()) return static_cast<uint16_t>(image_.samples[i] * 256);
        const bool grey = image_.channels <= 2;
        if (!image_.floats.empty()) {
            const double red = static_cast<double>(image_.floats[i]);
            return bytes_height(red, grey ? red : static_cast<double>(image_.floats[i + 1]));
        }
        return grey ? grey_height(i) : color_height(i);
    }

private:
    /// Red is the high byte, green the low one.
    static uint16_t bytes_height(double red, double green) { return height(255.0 * (256.0 * red + green)); }

    double decoded(size_t i) const {
        return static_cast<double>(
            curve_.decode(static_cast<float>(image_.samples[i]) / static_cast<float>(image_.white)));
    }
    double wide(size_t i) const { return to_16_bits_ * image_.samples[i]; }

    uint16_t grey_height(size_t i) const {
        constexpr double white = 65535.0;
        const bool narrow = image_.white == 255 && image_.channels == 1;
        if (narrow && (decodes_ || image_.type == ImageType::png)) {
            // Stored as bytes again, and for PNG by way of three channels.
            const float v = decodes_ ? static_cast<float>(decoded(i)) : image_.samples[i] / 255.0f;
            const float mean = image_.type == ImageType::png ? 0.297f * v + 0.589f * v + 0.114f * v : v;
            return static_cast<uint16_t>(257 * static_cast<int>(mean * 255.0f));
        }
        return height(decodes_ ? white * decoded(i) : wide(i));
    }

    uint16_t color_height(size_t i) const {
        if (image_.white == 255 && !decodes_) {
            return static_cast<uint16_t>(256 * image_.samples[i] + image_.samples[i + 1]);
        }
        const auto share = [&](size_t c) {
            return decodes_ ? decoded(i + c) : static_cast<double>(image_.samples[i + c]) / image_.white;
        };
        if (image_.white <= 255) return bytes_height(share(0), share(1));
        constexpr double white = 65535.0;
        return height(white * (0.297 * share(0) + 0.589 * share(1) + 0.114 * share(2)));
    }

    const Image& image_;
    double to_16_bits_;
    Curve curve_;
    bool decodes_ = false;
};

std::vector<uint16_t> heights_of(const ImageSource& source) {
    const Image& image = *source.image;
    std::vector<uint16_t> heights;
    heights.reserve(static_cast<size_t>(image.width) * static_cast<size_t>(image.height));
    const HeightReader reader(source);
    for (int y = image.height - 1; y >= 0; --y) {
        for (int x = 0; x < image.width; ++x) heights.push_back(reader.at(x, y));
    }
    return heights;
}

ShapePtr read(BlockReader& in) {
    const SourceRange at = in.where();
    const ImageSource source = in.context().take_image(in);
    const int width = source.image->width;
    const int depth = source.image->height;
    if (width < 2 || depth < 2) {
        in.fail_at(at,
                   fmt::format("A height field needs at least 2 x 2 heights, not {} x {}.", width, depth));
    }
    double water = 0;
    bool smooth = false;
    for (;;) {
        if (in.take_word("water_level")) {
            water = in.number();
            constexpr int bytes_until = 200;
            if (in.context().language_version < bytes_until) water /= 256.0;
        } else if (in.take_word("smooth")) {
            smooth = true;
        } else {
            break;
        }
    }
    constexpr double full = 65536.0;
    return std::make_shared<HeightField>(
        std::make_shared<const HeightGrid>(width, depth, heights_of(source), smooth), full * water);
}

}  // namespace

namespace shapes {
extern const ShapeKind height_field;
const ShapeKind height_field{"height_field", read,
                             "height_field { function 7, 6 { 0.5 + 0.3*sin(5*x)*cos(4*y) } }"};
}  // namespace shapes

}  // namespace rb
