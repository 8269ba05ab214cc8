// The home of libpng.
#include "base/diagnostics.h"
#include "image/codec.h"

#include <bit>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <png.h>

#include <fmt/format.h>

namespace rb {

namespace {

// libpng reports errors by calling this, which must not return.
[[noreturn]] void on_error(png_structp, png_const_charp message) {
    throw IoError(fmt::format("cannot write the PNG file: {}", message));
}
void on_warning(png_structp, png_const_charp) {}

struct Writer {
    png_structp png = nullptr;
    png_infop info = nullptr;
    Writer() {
        png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, on_error, on_warning);
        if (png) info = png_create_info_struct(png);
        if (!info) throw IoError("cannot write the PNG file: out of memory");
    }
    ~Writer() { png_destroy_write_struct(&png, &info); }
    Writer(const Writer&) = delete;
    Writer& operator=(const Writer&) = delete;
};

void write_gamma(const Writer& writer, const OutputFormat& format) {
    if (!format.curve) return;
    switch (format.curve->kind()) {
        case Curve::Kind::srgb:
            png_set_sRGB(writer.png, writer.info, PNG_sRGB_INTENT_PERCEPTUAL);
            break;
        case Curve::Kind::linear:
            png_set_gAMA(writer.png, writer.info, 1.0);
            break;
        case Curve::Kind::power:
            png_set_gAMA(writer.png, writer.info, 1.0 / static_cast<double>(format.curve->power()));
            break;
    }
}

}  // namespace

void write_png(const PixelRows& rows, const OutputFormat& format, const std::string& path) {
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "wb"), std::fclose);
    if (!file) throw IoError(fmt::format("cannot write '{}': {}", path, std::strerror(errno)));

    Quantiser quantise(format, rows.width, rows.channels);
    const bool wide = quantise.is_wide();
    const int color = rows.channels == 1   ? PNG_COLOR_TYPE_GRAY
                      : rows.channels == 2 ? PNG_COLOR_TYPE_GRAY_ALPHA
                      : rows.channels == 4 ? PNG_COLOR_TYPE_RGB_ALPHA
                                           : PNG_COLOR_TYPE_RGB;
    const Writer writer;
    png_init_io(writer.png, file.get());
    png_set_IHDR(writer.png, writer.info, static_cast<png_uint_32>(rows.width),
                 static_cast<png_uint_32>(rows.height), wide ? 16 : 8, color, PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    write_gamma(writer, format);
    // On rendered pictures one fixed filter and level 1 cost less than a fifth of the defaults' time (an
    // eighth where textures are noisy) for about 10 % more bytes.
    png_set_filter(writer.png, PNG_FILTER_TYPE_BASE, PNG_FILTER_SUB);
    png_set_compression_level(writer.png, 1);
    png_write_info(writer.png, writer.info);
    if (wide && std::endian::native == std::endian::little) png_set_swap(writer.png);

    const size_t length = static_cast<size_t>(rows.width) * static_cast<size_t>(rows.channels);
    std::vector<float> row(length);
    std::vector<uint8_t> bytes(wide ? 0 : length);
    std::vector<uint16_t> words(wide ? length : 0);
    for (int y = 0; y < rows.height; ++y) {
        rows.fill(y, row);
        if (wide) {
            quantise.row<uint16_t>(row, words);
            png_write_row(writer.png, reinterpret_cast<png_const_bytep>(words.data()));
        } else {
            quantise.row<uint8_t>(row, bytes);
            png_write_row(writer.png, bytes.data());
        }
    }
    png_write_end(writer.png, writer.info);
    if (std::fflush(file.get()) != 0)
        throw IoError(fmt::format("cannot write '{}': {}", path, std::strerror(errno)));
}

}  // namespace rb
