// Baseline and progressive JPEG.
#include "base/diagnostics.h"
#include "image/decode.h"

#include <cstdio>
#include <jpeglib.h>
// Needs what the header above declares.
#include <jerror.h>

namespace rb {

namespace {

std::string message_of(j_common_ptr jpeg) {
    std::array<char, JMSG_LENGTH_MAX> text{};
    jpeg->err->format_message(jpeg, text.data());
    return text.data();
}

[[noreturn]] void on_error(j_common_ptr jpeg) { throw IoError(message_of(jpeg)); }

/// Oddities pass, as in other programs; what is missing does not.
void on_message(j_common_ptr jpeg, int level) {
    if (level < 0 && jpeg->err->msg_code == JWRN_JPEG_EOF) throw IoError("the file ends too early");
}

struct Reader {
    jpeg_error_mgr errors;
    jpeg_decompress_struct jpeg;
    explicit Reader(std::string_view bytes) {
        jpeg.err = jpeg_std_error(&errors);
        errors.error_exit = on_error;
        errors.emit_message = on_message;
        jpeg_create_decompress(&jpeg);
        jpeg_mem_src(&jpeg, reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size());
    }
    ~Reader() { jpeg_destroy_decompress(&jpeg); }
    Reader(const Reader&) = delete;
    Reader& operator=(const Reader&) = delete;
};

/// Inks, which files hold inverted, as light.
void to_rgb(const std::vector<uint8_t>& inks, std::vector<uint16_t>& light) {
    for (size_t i = 0; i < inks.size(); i += 4) {
        for (size_t c = 0; c < 3; ++c)
            light.push_back(static_cast<uint16_t>(inks[i + c] * inks[i + 3] / 255));
    }
}

}  // namespace

Image decode_jpeg(std::string_view bytes) {
    if (bytes.empty()) throw IoError("the file ends too early");
    Reader reader(bytes);
    jpeg_decompress_struct& jpeg = reader.jpeg;
    jpeg_read_header(&jpeg, TRUE);
    const bool grey = jpeg.num_components == 1;
    const bool inks = jpeg.num_components == 4;
    jpeg.out_color_space = grey ? JCS_GRAYSCALE : inks ? JCS_CMYK : JCS_RGB;
    // A block of 16 x 16 pixels whose colours do not change takes a few bits.
    constexpr double most_packed = 1024.0;
    Image image = sized_image(jpeg.image_width, jpeg.image_height, grey ? 1 : 3, bytes, most_packed);
    jpeg_start_decompress(&jpeg);
    const size_t row = static_cast<size_t>(jpeg.output_width) * static_cast<size_t>(jpeg.output_components);
    std::vector<uint8_t> pixels(row * jpeg.output_height);
    while (jpeg.output_scanline < jpeg.output_height) {
        JSAMPROW next = pixels.data() + row * jpeg.output_scanline;
        jpeg_read_scanlines(&jpeg, &next, 1);
    }
    if (inks) {
        to_rgb(pixels, image.samples);
    } else {
        image.samples.assign(pixels.begin(), pixels.end());
    }
    return image;
}

}  // namespace rb
