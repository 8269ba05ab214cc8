#include "base/whole_file.h"

#include <filesystem>
#include <fstream>

namespace rb {

std::optional<std::string> read_whole_file(const std::string& path) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(path, error)) return std::nullopt;
    std::ifstream in(path, std::ios::binary);
    if (!in) return std::nullopt;
    const auto size = std::filesystem::file_size(path, error);
    if (error || size > 0xfffffff0u) return std::nullopt;
    std::string text(static_cast<size_t>(size), '\0');
    in.read(text.data(), static_cast<std::streamsize>(text.size()));
    text.resize(static_cast<size_t>(in.gcount()));
    return text;
}

}  // namespace rb
