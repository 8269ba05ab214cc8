#pragma once
#include "image/file.h"

#include <cstdint>

namespace rb {

/// Samples as the file stores them: 8 or 16 bit integers, or floats (OpenEXR, HDR).
struct Samples {
    int width = 0;
    int height = 0;
    int channels = 3;
    std::vector<uint8_t> bytes;
    std::vector<uint16_t> words;
    std::vector<float> floats;
};

/// floor(clamp(v) * (2^bits - 1) + 0.5) (textures spec 10.2).
Samples quantise(const Pixels& pixels, const OutputFormat& format);

/// PNG without OpenImageIO. The default format has its own writer because loading OpenImageIO (261 shared
/// libraries on Debian 12) costs 0.2 s of CPU time, more than most small pictures; see docs/architecture.md,
/// "Image files".
void write_png(const Samples& samples, const OutputFormat& format, const std::string& path);

/// Every format through OpenImageIO, which lives in a module of its own that is loaded at the first call.
void write_with_oiio(const Samples& samples, const OutputFormat& format, const std::string& path);
Pixels read_with_oiio(const std::string& path);

}  // namespace rb
