// GIF 87a and 89a: the first picture.
#include "base/diagnostics.h"
#include "image/decode.h"

#include <algorithm>

namespace rb {

namespace {

using Palette = std::vector<std::array<uint8_t, 4>>;

Palette read_palette(ByteReader& in, unsigned flags) {
    Palette palette(size_t{2} << (flags & 7u));
    for (auto& entry : palette) {
        for (size_t c = 0; c < 3; ++c) entry[c] = in.u8();
        entry[3] = 255;
    }
    return palette;
}

void skip_blocks(ByteReader& in) {
    while (const uint8_t size = in.u8()) in.skip(size);
}

std::string joined_blocks(ByteReader& in) {
    std::string data;
    while (const uint8_t size = in.u8()) data += in.take(size);
    return data;
}

/// LZW with growing codes, least significant bit first.
class GifCodes {
public:
    GifCodes(std::string_view data, unsigned bits) : data_(data), least_(bits + 1), clear_(1u << bits) {
        reset();
    }

    /// Appends indices until there are `count`; throws IoError if the data end before.
    void unpack(std::vector<uint16_t>& out, size_t count) {
        while (out.size() < count) {
            const unsigned code = next_code();
            if (code == clear_) {
                reset();
            } else if (code == clear_ + 1) {
                throw IoError("the file ends too early");
            } else {
                take(code, out, count);
            }
        }
    }

private:
    static constexpr unsigned most_codes = 4096;
    static constexpr unsigned none = most_codes;

    void reset() {
        width_ = least_;
        next_ = clear_ + 2;
        before_ = none;
    }

    unsigned next_code() {
        while (held_ < width_) {
            if (at_ == data_.size()) throw IoError("the file ends too early");
            buffer_ |= static_cast<uint32_t>(static_cast<uint8_t>(data_[at_++])) << held_;
            held_ += 8;
        }
        const unsigned code = buffer_ & ((1u << width_) - 1);
        buffer_ >>= width_;
        held_ -= width_;
        return code;
    }

    void take(unsigned code, std::vector<uint16_t>& out, size_t count) {
        if (code > next_ || (code == next_ && before_ == none)) throw IoError("the GIF data are damaged");
        std::array<uint8_t, most_codes + 1> text;
        size_t size = 0;
        unsigned at = code == next_ ? before_ : code;
        if (code == next_) size = 1;
        while (at >= clear_ + 2) {
            text[size++] = last_[at];
            at = prefix_[at];
        }
        text[size++] = static_cast<uint8_t>(at);
        const uint8_t first = text[size - 1];
        if (code == next_) text[0] = first;
        for (size_t i = size; i > 0 && out.size() < count; --i) out.push_back(text[i - 1]);
        if (before_ != none && next_ < most_codes) {
            prefix_[next_] = static_cast<uint16_t>(before_);
            last_[next_++] = first;
            if (next_ == 1u << width_ && width_ < 12) ++width_;
        }
        before_ = code;
    }

    std::string_view data_;
    unsigned least_;
    unsigned clear_;
    size_t at_ = 0;
    uint32_t buffer_ = 0;
    unsigned held_ = 0;
    unsigned width_ = 0;
    unsigned next_ = 0;
    unsigned before_ = none;
    std::array<uint16_t, most_codes> prefix_{};
    std::array<uint8_t, most_codes> last_{};
};

/// Every 8th row, those halfway between, ...
void interlaced_to_rows(Image& image) {
    const std::vector<uint16_t> stored = image.samples;
    struct Pass {
        int first, step;
    };
    int from = 0;
    for (const Pass pass : {Pass{0, 8}, Pass{4, 8}, Pass{2, 4}, Pass{1, 2}}) {
        for (int y = pass.first; y < image.height; y += pass.step) {
            std::copy_n(stored.begin() + static_cast<std::ptrdiff_t>(image.index(0, from++)), image.width,
                        image.samples.begin() + static_cast<std::ptrdiff_t>(image.index(0, y)));
        }
    }
}

Image read_picture(ByteReader& in, std::string_view bytes, const Palette& shared) {
    in.skip(4);
    const int width = in.u16();
    const int height = in.u16();
    const unsigned flags = in.u8();
    constexpr double most_packed = 4096.0;
    Image image = sized_image(width, height, 1, bytes, most_packed);
    image.palette = (flags & 0x80u) != 0 ? read_palette(in, flags) : shared;
    if (image.palette.empty()) throw IoError("the palette is missing");
    const unsigned bits = in.u8();
    if (bits < 1 || bits > 8) throw IoError("the GIF data are damaged");
    const std::string data = joined_blocks(in);
    GifCodes(data, bits).unpack(image.samples, image.index(0, height));
    if ((flags & 0x40u) != 0) interlaced_to_rows(image);
    return image;
}

}  // namespace

Image decode_gif(std::string_view bytes) {
    if (!bytes.starts_with("GIF87a") && !bytes.starts_with("GIF89a")) throw IoError("not a GIF file");
    ByteReader in(bytes, 6);
    in.skip(4);
    const unsigned flags = in.u8();
    in.skip(2);
    Palette palette;
    if ((flags & 0x80u) != 0) palette = read_palette(in, flags);
    std::optional<size_t> clear;
    for (;;) {
        const uint8_t kind = in.u8();
        if (kind == ',') break;
        if (kind != '!') throw IoError("no picture in the GIF file");
        if (in.u8() == 0xf9) {
            ByteReader control(in);
            if (control.u8() >= 4) {
                const bool is_clear = (control.u8() & 1u) != 0;
                control.skip(2);
                if (is_clear) clear = control.u8();
            }
        }
        skip_blocks(in);
    }
    Image image = read_picture(in, bytes, palette);
    if (clear && *clear < image.palette.size()) image.palette[*clear][3] = 0;
    return image;
}

Image decode_pot(std::string_view bytes) {
    const Image gif = decode_gif(bytes);
    if (gif.width % 2 != 0) throw IoError("the width of a POT file must be even");
    Image image;
    image.width = gif.width / 2;
    image.height = gif.height;
    image.white = 65535;
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            const unsigned high = gif.samples[gif.index(x, y)];
            const unsigned low = gif.samples[gif.index(x + image.width, y)];
            image.samples.push_back(static_cast<uint16_t>(high << 8 | low));
        }
    }
    return image;
}

}  // namespace rb
