#include "language/skipped.h"

#include "language/find_file.h"
#include "language/session.h"

#include <fmt/format.h>

namespace rb {

void skip_item(BlockReader& in) {
    const std::string_view word = in.at_word() ? in.peek_word() : std::string_view();
    in.skip_item();
    if (!names_file_type(word) || !in.at_text()) return;
    const SourceRange where = in.where();
    const std::string name = in.file_name();
    Session& session = *in.context().session;
    SoughtFile type = SoughtFile::image;
    std::string_view kind = "image file";
    if (word == "ttf") {
        type = SoughtFile::font;
        kind = "font file";
    } else if (word == "df3") {
        type = SoughtFile::df3;
        kind = "density file";
    }
    if (find_file(session, name, type, where)) return;
    throw missing_file(session, name, type, where, fmt::format("Cannot open {} {}.", kind, name));
}

}  // namespace rb
