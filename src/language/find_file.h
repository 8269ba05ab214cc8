#pragma once
#include "base/diagnostics.h"

#include <optional>
#include <string>

namespace rb {

struct Session;

/// `image` stands for one of unknown type.
enum class SoughtFile {
    scene,
    include,
    data,
    font,
    df3,
    image,
    gif,
    tga,
    iff,
    ppm,
    pgm,
    png,
    jpeg,
    tiff,
    bmp,
    exr,
    hdr
};

/// The path of a file that a scene names at `where`: the working directory and the library paths, with the
/// type's usual extensions (language spec 22). What is not found is looked for again as scenes from other
/// systems mean it - backslashes, other case, and at last only the base name - with a warning, unless
/// `LoadOptions::strict`. Tells `LoadOptions::file_used`.
std::optional<std::string> find_file(Session& session, const std::string& name, SoughtFile type,
                                     SourceRange where);

/// `png`, `ttf`, ...: a word behind which a file name stands.
bool names_file_type(std::string_view word);

/// Whether the exact name is there, for the scene language's own question.
bool file_exists(const Session& session, const std::string& name);

/// An error unless the scene may write there (LoadOptions::may_write).
void check_may_write(const Session& session, const std::string& path, SourceRange where);

/// The error for a file that was not found: `message`, with a note of every place tried.
[[nodiscard]] SceneError missing_file(Session& session, const std::string& name, SoughtFile type,
                                      SourceRange where, std::string message);

}  // namespace rb
