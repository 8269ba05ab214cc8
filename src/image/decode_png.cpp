// Reading PNG; shares the home of libpng with png.cpp.
#include "base/diagnostics.h"
#include "image/decode.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <png.h>

#include <fmt/format.h>

namespace rb {

namespace {

[[noreturn]] void on_error(png_structp, png_const_charp message) { throw IoError(message); }
void on_warning(png_structp, png_const_charp) {}

void read_bytes(png_structp png, png_bytep to, size_t count) {
    auto& in = *static_cast<ByteReader*>(png_get_io_ptr(png));
    std::memcpy(to, in.take(count).data(), count);
}

struct Reader {
    png_structp png = nullptr;
    png_infop info = nullptr;
    explicit Reader(ByteReader& in) {
        png = png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, on_error, on_warning);
        if (png) info = png_create_info_struct(png);
        if (!info) throw IoError("out of memory");
        png_set_read_fn(png, &in, read_bytes);
    }
    ~Reader() { png_destroy_read_struct(&png, &info, nullptr); }
    Reader(const Reader&) = delete;
    Reader& operator=(const Reader&) = delete;
};

void read_palette(const Reader& reader, Image& image) {
    png_colorp colors = nullptr;
    int count = 0;
    png_get_PLTE(reader.png, reader.info, &colors, &count);
    // Indices may lie beyond the entries that the file lists.
    image.palette.assign(256, {0, 0, 0, 255});
    for (int i = 0; i < count; ++i) image.palette[i] = {colors[i].red, colors[i].green, colors[i].blue, 255};
    png_bytep alpha = nullptr;
    png_color_16p unused = nullptr;
    int alphas = 0;
    if (png_get_tRNS(reader.png, reader.info, &alpha, &alphas, &unused) == 0) return;
    for (int i = 0; i < alphas && i < 256; ++i) image.palette[i][3] = alpha[i];
}

std::optional<GammaCurve> own_curve(const Reader& reader) {
    int intent = 0;
    if (png_get_sRGB(reader.png, reader.info, &intent) != 0) return SrgbCurve{};
    double gamma = 0;
    if (png_get_gAMA(reader.png, reader.info, &gamma) != 0 && gamma > 0) return 1.0 / gamma;
    return std::nullopt;
}

}  // namespace

Image decode_png(std::string_view bytes) {
    ByteReader in(bytes);
    const Reader reader(in);
    png_read_info(reader.png, reader.info);
    const int color = png_get_color_type(reader.png, reader.info);
    const int bits = png_get_bit_depth(reader.png, reader.info);
    // deflate makes at most 1032 bytes of one; a byte holds up to 8 pixels.
    constexpr double most_packed = 1032.0 * 8.0;
    Image image = sized_image(png_get_image_width(reader.png, reader.info),
                              png_get_image_height(reader.png, reader.info),
                              png_get_channels(reader.png, reader.info), bytes, most_packed);
    image.white = bits == 16 ? 65535 : 255;
    image.curve = own_curve(reader);
    if (color == PNG_COLOR_TYPE_PALETTE) {
        read_palette(reader, image);
        png_set_packing(reader.png);
    } else if (bits < 8) {
        png_set_expand_gray_1_2_4_to_8(reader.png);
    }
    if (bits == 16 && std::endian::native == std::endian::little) png_set_swap(reader.png);
    const int passes = png_set_interlace_handling(reader.png);
    png_read_update_info(reader.png, reader.info);

    const size_t row = image.index(0, 1);
    image.samples.resize(image.index(0, image.height));
    std::vector<uint8_t> narrow(bits == 16 ? 0 : image.samples.size());
    for (int pass = 0; pass < passes; ++pass) {
        for (size_t y = 0; y < static_cast<size_t>(image.height); ++y) {
            png_read_row(reader.png,
                         bits == 16 ? reinterpret_cast<png_bytep>(image.samples.data() + y * row)
                                    : narrow.data() + y * row,
                         nullptr);
        }
    }
    if (bits != 16) std::copy(narrow.begin(), narrow.end(), image.samples.begin());
    return image;
}

}  // namespace rb
