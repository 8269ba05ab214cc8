// Windows and OS/2 bitmaps of 1, 4, 8, 24 and 32 bits, 4 and 8 also with run lengths.
#include "base/diagnostics.h"
#include "image/decode.h"

#include <fmt/format.h>

namespace rb {

namespace {

struct BmpHeader {
    uint32_t data = 0;
    uint32_t size = 0;  ///< of the second header
    int64_t width = 0;
    int64_t height = 0;
    bool from_top = false;
    unsigned bits = 0;
    uint32_t compression = 0;
    uint32_t colors = 0;
};

BmpHeader read_bmp_header(ByteReader& in) {
    if (in.take(2) != "BM") throw IoError("not a BMP file");
    BmpHeader h;
    in.skip(8);
    h.data = in.u32();
    h.size = in.u32();
    constexpr uint32_t old_size = 12;
    constexpr uint32_t new_size = 40;
    if (h.size == old_size) {
        h.width = in.u16();
        h.height = in.u16();
        in.skip(2);
        h.bits = in.u16();
    } else if (h.size >= new_size) {
        h.width = static_cast<int32_t>(in.u32());
        h.height = static_cast<int32_t>(in.u32());
        in.skip(2);
        h.bits = in.u16();
        h.compression = in.u32();
        in.skip(12);
        h.colors = in.u32();
    } else {
        throw IoError("the header of the BMP file is damaged");
    }
    if (h.height < 0) {
        h.height = -h.height;
        h.from_top = true;
    }
    const bool known = h.bits == 1 || h.bits == 4 || h.bits == 8 || h.bits == 24 || h.bits == 32;
    const bool packed = (h.bits == 8 && h.compression == 1) || (h.bits == 4 && h.compression == 2);
    if (!known || (h.compression != 0 && !packed)) {
        throw IoError(fmt::format("{} bits with compression {} in the BMP file", h.bits, h.compression));
    }
    return h;
}

void read_palette(ByteReader& in, const BmpHeader& h, Image& image) {
    constexpr size_t old_size = 12;
    in.seek(14 + size_t{h.size});
    const size_t most = size_t{1} << h.bits;
    image.palette.assign(most, {0, 0, 0, 255});
    const size_t count = h.colors > 0 && h.colors < most ? h.colors : most;
    for (size_t i = 0; i < count; ++i) {
        for (const size_t c : {2, 1, 0}) image.palette[i][c] = in.u8();
        if (h.size != old_size) in.skip(1);
    }
}

void read_rows(ByteReader& in, const BmpHeader& h, Image& image) {
    const size_t row_bytes = (static_cast<size_t>(image.width) * h.bits + 31) / 32 * 4;
    for (int row = 0; row < image.height; ++row) {
        ByteReader from(in.take(row_bytes));
        uint16_t* to = image.samples.data() + image.index(0, h.from_top ? row : image.height - 1 - row);
        unsigned byte = 0;
        for (int x = 0; x < image.width; ++x) {
            if (h.bits >= 24) {
                for (const int c : {2, 1, 0}) to[c] = from.u8();
                if (h.bits == 32) from.skip(1);
                to += 3;
                continue;
            }
            const int per_byte = 8 / static_cast<int>(h.bits);
            if (x % per_byte == 0) byte = from.u8();
            const unsigned shift = h.bits * static_cast<unsigned>(per_byte - 1 - x % per_byte);
            *to++ = static_cast<uint16_t>(byte >> shift & ((1u << h.bits) - 1));
        }
    }
}

/// Run lengths; places that they leave out stay index 0.
class BmpRuns {
public:
    BmpRuns(ByteReader& in, const BmpHeader& h, Image& image) : in_(in), bits_(h.bits), image_(image) {}

    void unpack() {
        for (;;) {
            const unsigned count = in_.u8();
            const unsigned value = in_.u8();
            if (count > 0) {
                for (unsigned i = 0; i < count; ++i) put(half(value, i));
            } else if (value == 0) {
                x_ = 0;
                ++y_;
            } else if (value == 1) {
                return;
            } else if (value == 2) {
                x_ += in_.u8();
                y_ += in_.u8();
            } else {
                copy(value);
            }
        }
    }

private:
    unsigned half(unsigned byte, unsigned i) const {
        return bits_ == 8 ? byte : i % 2 == 0 ? byte >> 4 : byte & 15u;
    }
    void put(unsigned index) {
        if (x_ < image_.width && y_ < image_.height)
            image_.samples[image_.index(x_, image_.height - 1 - y_)] = static_cast<uint16_t>(index);
        ++x_;
    }
    void copy(unsigned count) {
        const size_t size = bits_ == 8 ? count : (count + 1) / 2;
        const std::string_view bytes = in_.take(size);
        for (unsigned i = 0; i < count; ++i)
            put(half(static_cast<uint8_t>(bytes[bits_ == 8 ? i : i / 2]), i));
        if (size % 2 != 0) in_.skip(1);
    }

    ByteReader& in_;
    unsigned bits_;
    Image& image_;
    int x_ = 0;
    int y_ = 0;
};

}  // namespace

Image decode_bmp(std::string_view bytes) {
    ByteReader in(bytes);
    const BmpHeader h = read_bmp_header(in);
    constexpr double most_packed = 256.0;
    Image image =
        sized_image(h.width, h.height, h.bits >= 24 ? 3 : 1, bytes, h.compression ? most_packed : 8.0);
    if (h.bits <= 8) read_palette(in, h, image);
    image.samples.resize(image.index(0, image.height));
    in.seek(h.data);
    if (h.compression != 0) {
        BmpRuns(in, h, image).unpack();
    } else {
        read_rows(in, h, image);
    }
    return image;
}

}  // namespace rb
