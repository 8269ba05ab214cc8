#pragma once
#include "image/dither.h"
#include "image/gamma.h"
#include "image/pixels.h"

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace rb {

enum class FileType { png, ppm, tga, tga_uncompressed, jpeg, bmp, exr, hdr, tiff };

/// File type for a name's extension; empty if unknown.
std::optional<FileType> file_type_for(std::string_view path);
/// Extension with its dot.
std::string_view extension_of(FileType type);
/// OpenEXR and HDR hold linear, unclamped light; all others hold encoded values clamped to 0..1.
constexpr bool is_linear(FileType type) { return type == FileType::exr || type == FileType::hdr; }

struct OutputFormat {
    FileType type = FileType::png;
    int bits = 8;         ///< per channel, 5..16; stored as 8 or 16
    Dithering dither;     ///< not of formats that hold linear light
    int compression = 0;  ///< JPEG quality 1..100, 0: the format's default
    /// Transfer curve of the values, written into the file's metadata; empty: unknown.
    std::optional<Curve> curve;
};

/// A picture that is made while it is written: `fill` is called once for each row, top to bottom.
struct PixelRows {
    int width = 0;
    int height = 0;
    int channels = 3;
    std::function<void(int y, std::span<float> row)> fill;
};

/// The rows of a picture that is there already, and stays while they are used.
PixelRows rows_of(const Pixels& pixels);

/// Writes to a temporary name beside `path` and renames it, so that a reader never sees half a picture and a
/// failure leaves an old file untouched. `path` "-" writes to standard output. Throws IoError.
void write_image(const PixelRows& rows, const OutputFormat& format, const std::string& path);

/// Reads any picture as 3 or 4 channels of 0..1 (float formats unclamped), undecoded. Throws IoError.
Pixels read_image(const std::string& path);

}  // namespace rb
