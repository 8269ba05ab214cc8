// PBM, PGM and PPM, plain and raw (netpbm.sourceforge.net/doc).
#include "base/diagnostics.h"
#include "image/decode.h"

#include <algorithm>
#include <cctype>

namespace rb {

namespace {

class NetpbmReader {
public:
    explicit NetpbmReader(std::string_view bytes) : bytes_(bytes) {}

    /// The next decimal number of the header or of plain samples; comments run from # to the end of the line.
    uint32_t number() {
        while (at_ < bytes_.size() && !std::isdigit(peek())) {
            if (peek() == '#') {
                while (at_ < bytes_.size() && peek() != '\n') ++at_;
            } else if (!std::isspace(peek())) {
                throw IoError("a number is expected in the netpbm file");
            } else {
                ++at_;
            }
        }
        if (at_ == bytes_.size()) throw IoError("the file ends too early");
        uint32_t value = 0;
        constexpr uint32_t most = 100000000;
        while (at_ < bytes_.size() && std::isdigit(peek())) {
            value = value * 10 + static_cast<uint32_t>(bytes_[at_++] - '0');
            if (value > most) throw IoError("a number in the netpbm file is too large");
        }
        return value;
    }

    /// A bit of a plain bitmap: digits need no space between them.
    uint32_t digit() {
        while (at_ < bytes_.size() && std::isspace(peek())) ++at_;
        if (at_ == bytes_.size()) throw IoError("the file ends too early");
        return static_cast<uint32_t>(bytes_[at_++] - '0') & 1u;
    }

    /// The raw samples, behind the one space that ends the header.
    ByteReader raw() const { return ByteReader(bytes_, std::min(at_ + 1, bytes_.size())); }
    void skip(size_t count) { at_ += count; }

private:
    unsigned char peek() const { return static_cast<unsigned char>(bytes_[at_]); }

    std::string_view bytes_;
    size_t at_ = 0;
};

void read_bitmap(Image& image, NetpbmReader& in, bool plain) {
    ByteReader raw = in.raw();
    for (int y = 0; y < image.height; ++y) {
        unsigned byte = 0;
        for (int x = 0; x < image.width; ++x) {
            if (!plain && x % 8 == 0) byte = raw.u8();
            const unsigned black = plain ? in.digit() : byte >> (7 - x % 8) & 1u;
            image.samples.push_back(black ? 0 : 1);
        }
    }
}

}  // namespace

Image decode_netpbm(std::string_view bytes) {
    if (bytes.size() < 3 || bytes[0] != 'P' || bytes[1] < '1' || bytes[1] > '6') {
        throw IoError("not a PBM, PGM or PPM file");
    }
    const int kind = bytes[1] - '0';
    const bool plain = kind <= 3;
    const bool bitmap = kind == 1 || kind == 4;
    NetpbmReader in(bytes);
    in.skip(2);
    const uint32_t width = in.number();
    const uint32_t height = in.number();
    Image image = sized_image(width, height, kind % 3 == 0 ? 3 : 1, bytes, kind == 4 ? 8.0 : 1.0);
    image.white = bitmap ? 1 : in.number();
    if (image.white < 1 || image.white > 65535) throw IoError("the largest value must be 1 to 65535");
    const size_t count = image.index(0, image.height);
    image.samples.reserve(count);
    if (bitmap) {
        read_bitmap(image, in, plain);
        return image;
    }
    ByteReader raw = in.raw();
    const bool wide = image.white > 255;
    for (size_t i = 0; i < count; ++i) {
        const uint32_t value = plain ? in.number() : wide ? raw.u16_big() : raw.u8();
        image.samples.push_back(static_cast<uint16_t>(std::min(value, image.white)));
    }
    return image;
}

}  // namespace rb
