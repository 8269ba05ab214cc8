#include "image/decode.h"

#include "base/diagnostics.h"
#include "base/whole_file.h"
#include "image/codec.h"

#include <fmt/format.h>

namespace rb {

namespace {

Image decode(std::string_view bytes, ImageType type) {
    switch (type) {
        case ImageType::png:
            return decode_png(bytes);
        case ImageType::jpeg:
            return decode_jpeg(bytes);
        case ImageType::ppm:
        case ImageType::pgm:
            return decode_netpbm(bytes);
        case ImageType::tga:
            return decode_targa(bytes);
        case ImageType::gif:
            return decode_gif(bytes);
        case ImageType::bmp:
            return decode_bmp(bytes);
        case ImageType::pot:
            return decode_pot(bytes);
        default:
            throw IoError("files of this type cannot be read");
    }
}

bool is_for_oiio(ImageType type) {
    return type == ImageType::tiff || type == ImageType::exr || type == ImageType::hdr;
}

}  // namespace

Image decode_image(const std::string& path, ImageType type) {
    Image image;
    if (is_for_oiio(type)) {
        image = read_samples_with_oiio(path, type);
    } else {
        const auto bytes = read_whole_file(path);
        if (!bytes) throw IoError(fmt::format("cannot read '{}'", path));
        try {
            image = decode(*bytes, type);
        } catch (const IoError& error) {
            throw IoError(fmt::format("cannot read '{}': {}", path, error.what()));
        }
    }
    image.type = type;
    return image;
}

Image sized_image(int64_t width, int64_t height, int channels, std::string_view bytes, double most_ratio) {
    constexpr int64_t longest = 1 << 20;
    constexpr int64_t most_pixels = 1 << 28;
    if (width < 1 || height < 1 || width > longest || height > longest || width * height > most_pixels) {
        throw IoError(fmt::format("a picture of {} x {} pixels", width, height));
    }
    if (static_cast<double>(width * height) > most_ratio * static_cast<double>(bytes.size())) {
        throw IoError("the file ends too early");
    }
    Image image;
    image.width = static_cast<int>(width);
    image.height = static_cast<int>(height);
    image.channels = channels;
    return image;
}

void ByteReader::seek(size_t at) {
    if (at > bytes_.size()) throw IoError("the file ends too early");
    at_ = at;
}

std::string_view ByteReader::take(size_t count) {
    if (count > bytes_.size() - at_) throw IoError("the file ends too early");
    const std::string_view taken = bytes_.substr(at_, count);
    at_ += count;
    return taken;
}

uint8_t ByteReader::u8() { return static_cast<uint8_t>(take(1)[0]); }

uint16_t ByteReader::u16() {
    const unsigned low = u8();
    return static_cast<uint16_t>(low | unsigned{u8()} << 8);
}

uint16_t ByteReader::u16_big() {
    const unsigned high = u8();
    return static_cast<uint16_t>(high << 8 | unsigned{u8()});
}

uint32_t ByteReader::u32() {
    const uint32_t low = u16();
    return low | uint32_t{u16()} << 16;
}

}  // namespace rb
