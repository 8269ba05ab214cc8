#include "image/file.h"

#include "base/diagnostics.h"
#include "base/temporary_file.h"
#include "image/codec.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>

#include <fmt/format.h>

namespace rb {

namespace {

struct Named {
    std::string_view extension;
    FileType type;
};
constexpr std::array<Named, 12> extensions{{{".png", FileType::png},
                                            {".ppm", FileType::ppm},
                                            {".pgm", FileType::ppm},
                                            {".tga", FileType::tga},
                                            {".jpg", FileType::jpeg},
                                            {".jpeg", FileType::jpeg},
                                            {".bmp", FileType::bmp},
                                            {".exr", FileType::exr},
                                            {".hdr", FileType::hdr},
                                            {".tif", FileType::tiff},
                                            {".tiff", FileType::tiff},
                                            {".tga", FileType::tga_uncompressed}}};

void copy_to_stdout(const std::string& path) {
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> in(std::fopen(path.c_str(), "rb"), std::fclose);
    if (!in) throw IoError(fmt::format("cannot read back '{}': {}", path, std::strerror(errno)));
    std::vector<char> buffer(1 << 16);
    while (const size_t got = std::fread(buffer.data(), 1, buffer.size(), in.get())) {
        if (std::fwrite(buffer.data(), 1, got, stdout) != got) {
            throw IoError(fmt::format("cannot write to standard output: {}", std::strerror(errno)));
        }
    }
    if (std::fflush(stdout) != 0) {
        throw IoError(fmt::format("cannot write to standard output: {}", std::strerror(errno)));
    }
}

}  // namespace

std::optional<FileType> file_type_for(std::string_view path) {
    std::string extension = std::filesystem::path(path).extension().string();
    std::ranges::transform(extension, extension.begin(), [](unsigned char c) { return std::tolower(c); });
    for (const Named& named : extensions) {
        if (named.extension == extension) return named.type;
    }
    return std::nullopt;
}

std::string_view extension_of(FileType type) {
    for (const Named& named : extensions) {
        if (named.type == type) return named.extension;
    }
    return "";
}

Quantiser::Quantiser(const OutputFormat& format, int width, int channels)
    : wide_(format.bits > 8 &&
            (format.type == FileType::png || format.type == FileType::ppm || format.type == FileType::tiff)) {
    const int bits = wide_ ? format.bits : std::min(format.bits, 8);
    levels_ = static_cast<float>((1 << bits) - 1);
    spread_ = format.type == FileType::ppm ? 1.0f : (wide_ ? 65535.0f : 255.0f) / levels_;
    if (format.dither.method != DitherMethod::none) dither_.emplace(format.dither, width, channels);
}

Samples samples_of(const PixelRows& rows, const OutputFormat& format) {
    Samples out{rows.width, rows.height, rows.channels, {}, {}, {}};
    const size_t length = static_cast<size_t>(rows.width) * static_cast<size_t>(rows.channels);
    const size_t size = length * static_cast<size_t>(rows.height);
    Quantiser quantise(format, rows.width, rows.channels);
    const bool floats = is_linear(format.type);
    if (floats) {
        out.floats.resize(size);
    } else if (quantise.is_wide()) {
        out.words.resize(size);
    } else {
        out.bytes.resize(size);
    }
    std::vector<float> row(length);
    for (int y = 0; y < rows.height; ++y) {
        const size_t start = static_cast<size_t>(y) * length;
        if (floats) {
            rows.fill(y, std::span(out.floats).subspan(start, length));
            continue;
        }
        rows.fill(y, row);
        if (quantise.is_wide()) {
            quantise.row<uint16_t>(row, std::span(out.words).subspan(start, length));
        } else {
            quantise.row<uint8_t>(row, std::span(out.bytes).subspan(start, length));
        }
    }
    return out;
}

PixelRows rows_of(const Pixels& pixels) {
    const auto fill = [&pixels](int y, std::span<float> row) {
        std::copy_n(pixels.at(0, y), row.size(), row.begin());
    };
    return {pixels.width, pixels.height, pixels.channels, fill};
}

void write_image(const PixelRows& rows, const OutputFormat& format, const std::string& path) {
    const bool to_stdout = path == "-";
    const std::string base =
        to_stdout ? (std::filesystem::temp_directory_path() / "renderboy-stdout").string() : path;
    TemporaryFile temporary(base);
    if (format.type == FileType::png) {
        write_png(rows, format, temporary.name());
    } else if (format.type == FileType::ppm) {
        write_netpbm(rows, format, temporary.name());
    } else {
        write_with_oiio(samples_of(rows, format), format, temporary.name());
    }
    if (to_stdout) {
        copy_to_stdout(temporary.name());
        return;
    }
    if (!temporary.put_in_place(path))
        throw IoError(fmt::format("cannot write '{}': {}", path, std::strerror(errno)));
}

Pixels read_image(const std::string& path) { return read_with_oiio(path); }

}  // namespace rb
