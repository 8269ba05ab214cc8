// Truevision Targa 2.0. Spec: textures 6.4.
#include "base/diagnostics.h"
#include "image/decode.h"

#include <fmt/format.h>

namespace rb {

namespace {

struct TargaHeader {
    unsigned id_length, palette_kind, kind;
    unsigned palette_first, palette_size, palette_bits;
    unsigned width, height, bits, descriptor;

    bool packed() const { return kind >= 8; }
    bool has_indices() const { return kind % 8 == 1; }
    bool is_grey() const { return kind % 8 == 3; }
};

TargaHeader read_targa_header(ByteReader& in) {
    TargaHeader h;
    h.id_length = in.u8();
    h.palette_kind = in.u8();
    h.kind = in.u8();
    h.palette_first = in.u16();
    h.palette_size = in.u16();
    h.palette_bits = in.u8();
    in.skip(4);
    h.width = in.u16();
    h.height = in.u16();
    h.bits = in.u8();
    h.descriptor = in.u8();
    const unsigned plain = h.kind % 8;
    if (h.kind > 11 || plain < 1 || plain > 3) {
        throw IoError(fmt::format("Targa type {} is not known", h.kind));
    }
    const bool known =
        plain == 2 ? h.bits == 15 || h.bits == 16 || h.bits == 24 || h.bits == 32 : h.bits == 8;
    if (!known) throw IoError(fmt::format("{} bits a pixel in the Targa file", h.bits));
    return h;
}

/// RGBA; 15 and 16 bits hold 5 a channel, which the reference shifts and does not spread.
std::array<uint8_t, 4> read_color(ByteReader& in, unsigned bits) {
    if (bits <= 16) {
        const unsigned v = in.u16();
        const auto channel = [&](unsigned shift) { return static_cast<uint8_t>((v >> shift & 31u) << 3); };
        return {channel(10), channel(5), channel(0), 255};
    }
    const uint8_t blue = in.u8();
    const uint8_t green = in.u8();
    const uint8_t red = in.u8();
    return {red, green, blue, bits == 32 ? in.u8() : uint8_t{255}};
}

/// Hands out pixels one after the other, run lengths undone.
class TargaPixels {
public:
    TargaPixels(ByteReader& in, const TargaHeader& header) : in_(in), header_(header) {}

    const std::array<uint8_t, 4>& next() {
        if (!header_.packed()) return read();
        if (left_ == 0) {
            const unsigned packet = in_.u8();
            repeats_ = (packet & 128u) != 0;
            left_ = (packet & 127u) + 1;
            if (repeats_) read();
        }
        --left_;
        return repeats_ ? pixel_ : read();
    }

private:
    const std::array<uint8_t, 4>& read() {
        if (header_.bits == 8) {
            pixel_[0] = in_.u8();
        } else {
            pixel_ = read_color(in_, header_.bits);
        }
        return pixel_;
    }

    ByteReader& in_;
    const TargaHeader& header_;
    std::array<uint8_t, 4> pixel_{};
    unsigned left_ = 0;
    bool repeats_ = false;
};

std::vector<std::array<uint8_t, 4>> read_palette(ByteReader& in, const TargaHeader& h) {
    std::vector<std::array<uint8_t, 4>> palette(256, {0, 0, 0, 255});
    for (unsigned i = 0; i < h.palette_size; ++i) {
        const auto color = read_color(in, h.palette_bits);
        if (h.palette_first + i < palette.size()) palette[h.palette_first + i] = color;
    }
    return palette;
}

}  // namespace

Image decode_targa(std::string_view bytes) {
    ByteReader in(bytes);
    const TargaHeader h = read_targa_header(in);
    in.skip(h.id_length);
    constexpr double most_packed = 128.0;
    const int channels = h.bits == 8 ? 1 : h.bits == 32 ? 4 : 3;
    Image image = sized_image(h.width, h.height, channels, bytes, h.packed() ? most_packed : 1.0);
    if (h.palette_kind == 1) {
        auto palette = read_palette(in, h);
        if (h.has_indices()) image.palette = std::move(palette);
    } else if (h.has_indices()) {
        throw IoError("the palette is missing");
    }
    image.samples.resize(image.index(0, image.height));
    TargaPixels pixels(in, h);
    const bool from_top = (h.descriptor & 0x20u) != 0;
    for (int row = 0; row < image.height; ++row) {
        uint16_t* to = image.samples.data() + image.index(0, from_top ? row : image.height - 1 - row);
        for (int x = 0; x < image.width; ++x) {
            const auto& pixel = pixels.next();
            for (size_t c = 0; c < static_cast<size_t>(channels); ++c) *to++ = pixel[c];
        }
    }
    return image;
}

}  // namespace rb
