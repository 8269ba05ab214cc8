#include "base/source.h"

#include <algorithm>

namespace rb {

SourceRange cover(SourceRange a, SourceRange b) {
    if (!a.known()) return b;
    if (b.file != a.file) return a;
    return {a.file, std::min(a.begin, b.begin), std::max(a.end, b.end)};
}

uint32_t SourceMap::add(std::string name, std::string text) {
    files_.push_back({std::move(name), std::move(text)});
    return static_cast<uint32_t>(files_.size());
}

std::string_view SourceMap::name(uint32_t file) const {
    return file == 0 || file > files_.size() ? std::string_view{} : std::string_view{files_[file - 1].name};
}

std::string_view SourceMap::text(uint32_t file) const {
    return file == 0 || file > files_.size() ? std::string_view{} : std::string_view{files_[file - 1].text};
}

LineColumn SourceMap::position(uint32_t file, uint32_t offset) const {
    const std::string_view all = text(file);
    const size_t end = std::min<size_t>(offset, all.size());
    LineColumn place{1, 1};
    for (size_t i = 0; i < end; ++i) {
        const bool is_crlf = all[i] == '\r' && i + 1 < all.size() && all[i + 1] == '\n';
        if (all[i] == '\n' || (all[i] == '\r' && !is_crlf)) {
            ++place.line;
            place.column = 1;
        } else {
            ++place.column;
        }
    }
    return place;
}

std::string_view SourceMap::line_at(uint32_t file, uint32_t offset) const {
    const std::string_view all = text(file);
    const size_t at = std::min<size_t>(offset, all.size());
    const size_t before = at == 0 ? std::string_view::npos : all.find_last_of("\r\n", at - 1);
    const size_t first = before == std::string_view::npos ? 0 : before + 1;
    const size_t last = std::min(all.find_first_of("\r\n", at), all.size());
    return all.substr(first, last - first);
}

}  // namespace rb
