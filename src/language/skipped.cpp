#include "language/skipped.h"

#include "language/find_file.h"
#include "language/session.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

namespace rb {

void skip_item(BlockReader& in) {
    constexpr std::array<std::string_view, 14> types{"png",  "gif", "tga", "iff", "ppm", "pgm", "jpeg",
                                                     "tiff", "exr", "hdr", "bmp", "df3", "ttf", "sys"};
    const std::string_view word = in.at_word() ? in.peek_word() : std::string_view();
    in.skip_item();
    if (std::ranges::find(types, word) == types.end() || !in.at_text()) return;
    const SourceRange where = in.where();
    const std::string name = in.file_name();
    Session& session = *in.context().session;
    FileType type = FileType::image;
    if (word == "ttf") type = FileType::font;
    if (word == "df3") type = FileType::df3;
    if (!find_file(session, name, type, where)) {
        session.warn(where, fmt::format("Cannot find file '{}'.", name));
    }
}

}  // namespace rb
