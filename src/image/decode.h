#pragma once
#include "scene/image.h"

#include <string_view>

namespace rb {

/// Decodes the bytes of a file of the given type. What OpenImageIO would turn into RGB (palettes) or round
/// (maxima other than 255 and 65535) is decoded here; it reads TIFF, OpenEXR and HDR, from the path.
/// Throws IoError saying what is wrong with the file.
Image decode_image(const std::string& path, ImageType type);

Image decode_png(std::string_view bytes);
Image decode_netpbm(std::string_view bytes);  ///< P1 to P6
Image decode_targa(std::string_view bytes);   ///< types 1, 2, 3, 9, 10, 11
Image decode_gif(std::string_view bytes);     ///< the first picture
Image decode_bmp(std::string_view bytes);     ///< without or with run lengths
Image decode_jpeg(std::string_view bytes);
Image decode_pot(std::string_view bytes);  ///< a GIF whose right half holds the low bytes

/// An image without samples, after a look at whether so small a file can hold it: no more than `most_ratio`
/// pixels a byte. Throws IoError.
Image sized_image(int64_t width, int64_t height, int channels, std::string_view bytes, double most_ratio);

/// Reads numbers from bytes; beyond the end it throws IoError("the file ends too early").
class ByteReader {
public:
    explicit ByteReader(std::string_view bytes, size_t at = 0) : bytes_(bytes), at_(at) {}

    size_t position() const { return at_; }
    void seek(size_t at);
    void skip(size_t count) { seek(at_ + count); }
    uint8_t u8();
    uint16_t u16();      ///< little-endian
    uint16_t u16_big();  ///< big-endian
    uint32_t u32();      ///< little-endian
    std::string_view take(size_t count);

private:
    std::string_view bytes_;
    size_t at_;
};

}  // namespace rb
