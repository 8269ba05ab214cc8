#include "image/file.h"

#include "base/diagnostics.h"
#include "image/codec.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
#include <unistd.h>

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

/// Removes the file unless it was kept: an exception between opening and renaming leaves nothing behind.
class TemporaryFile {
public:
    explicit TemporaryFile(std::string path) : path_(std::move(path)) {}
    ~TemporaryFile() {
        if (!path_.empty()) std::remove(path_.c_str());
    }
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;
    const std::string& path() const { return path_; }
    void keep() { path_.clear(); }

private:
    std::string path_;
};

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

Samples quantise(const Pixels& pixels, const OutputFormat& format) {
    Samples out{pixels.width, pixels.height, pixels.channels, {}, {}, {}};
    if (is_linear(format.type)) {
        out.floats = pixels.values;
        return out;
    }
    const bool wide = format.bits > 8 && (format.type == FileType::png || format.type == FileType::ppm ||
                                          format.type == FileType::tiff);
    const int bits = wide ? format.bits : std::min(format.bits, 8);
    const auto levels = static_cast<float>((1 << bits) - 1);
    // Fewer bits than stored: the levels are spread over the stored range.
    const float spread = (wide ? 65535.0f : 255.0f) / levels;
    // Values are not negative, so that truncation is floor.
    const auto level = [&](float v) {
        const float clamped = v > 0.0f ? std::min(v, 1.0f) : 0.0f;  // NaN becomes 0
        const auto code = static_cast<int>(clamped * levels + 0.5f);
        return spread == 1.0f ? code : static_cast<int>(static_cast<float>(code) * spread + 0.5f);
    };
    if (wide) {
        out.words.resize(pixels.values.size());
        std::ranges::transform(pixels.values, out.words.begin(),
                               [&](float v) { return static_cast<uint16_t>(level(v)); });
    } else {
        out.bytes.resize(pixels.values.size());
        std::ranges::transform(pixels.values, out.bytes.begin(),
                               [&](float v) { return static_cast<uint8_t>(level(v)); });
    }
    return out;
}

void write_image(const Pixels& pixels, const OutputFormat& format, const std::string& path) {
    const Samples samples = quantise(pixels, format);
    const bool to_stdout = path == "-";
    const std::string base =
        to_stdout ? (std::filesystem::temp_directory_path() / "renderboy-stdout").string() : path;
    TemporaryFile temporary(fmt::format("{}.{}.part", base, getpid()));
    if (format.type == FileType::png) {
        write_png(samples, format, temporary.path());
    } else {
        write_with_oiio(samples, format, temporary.path());
    }
    if (to_stdout) {
        copy_to_stdout(temporary.path());
        return;
    }
    if (std::rename(temporary.path().c_str(), path.c_str()) != 0) {
        throw IoError(fmt::format("cannot write '{}': {}", path, std::strerror(errno)));
    }
    temporary.keep();
}

Pixels read_image(const std::string& path) { return read_with_oiio(path); }

}  // namespace rb
