#include "base/diagnostics.h"
#include "image/codec.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

#include <fmt/format.h>

namespace rb {

void write_netpbm(const PixelRows& rows, const OutputFormat& format, const std::string& path) {
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "wb"), std::fclose);
    if (!file) throw IoError(fmt::format("cannot write '{}': {}", path, std::strerror(errno)));

    Quantiser quantise(format, rows.width, rows.channels);
    const std::string header = fmt::format("P{}\n{} {}\n{}\n", rows.channels == 1 ? 5 : 6, rows.width,
                                           rows.height, quantise.greatest());
    bool written = std::fwrite(header.data(), 1, header.size(), file.get()) == header.size();
    const size_t length = static_cast<size_t>(rows.width) * static_cast<size_t>(rows.channels);
    std::vector<float> row(length);
    std::vector<uint16_t> words(length);
    std::vector<unsigned char> bytes;
    for (int y = 0; y < rows.height && written; ++y) {
        rows.fill(y, row);
        quantise.row<uint16_t>(row, words);
        bytes.clear();
        for (const uint16_t word : words) {
            if (quantise.is_wide()) bytes.push_back(static_cast<unsigned char>(word >> 8));
            bytes.push_back(static_cast<unsigned char>(word & 255));
        }
        written = std::fwrite(bytes.data(), 1, bytes.size(), file.get()) == bytes.size();
    }
    if (!written || std::fflush(file.get()) != 0)
        throw IoError(fmt::format("cannot write '{}': {}", path, std::strerror(errno)));
}

}  // namespace rb
