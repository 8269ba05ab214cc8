#include "language/find_file.h"

#include "language/session.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace rb {

namespace {

namespace fs = std::filesystem;

std::vector<std::string> extensions_of(SoughtFile type) {
    switch (type) {
        case SoughtFile::scene:
            return {".pov", ".POV"};
        case SoughtFile::include:
            return {".inc", ".INC"};
        case SoughtFile::font:
            return {".ttf", ".TTF"};
        case SoughtFile::df3:
            return {".df3", ".DF3"};
        case SoughtFile::gif:
            return {".gif", ".GIF"};
        case SoughtFile::tga:
            return {".tga", ".TGA"};
        case SoughtFile::iff:
            return {".iff", ".IFF"};
        case SoughtFile::ppm:
            return {".ppm", ".PPM"};
        case SoughtFile::pgm:
            return {".pgm", ".PGM"};
        case SoughtFile::png:
            return {".png", ".PNG"};
        case SoughtFile::jpeg:
            return {".jpg", ".JPG", ".jpeg", ".JPEG"};
        case SoughtFile::tiff:
            return {".tif", ".TIF", ".tiff", ".TIFF"};
        case SoughtFile::bmp:
            return {".bmp", ".BMP"};
        case SoughtFile::exr:
            return {".exr", ".EXR"};
        case SoughtFile::hdr:
            return {".hdr", ".HDR"};
        case SoughtFile::data:
        case SoughtFile::image:
            return {};
    }
    return {};
}

/// The name with the extensions that a file of this type may have, in the order in which they are tried.
std::vector<std::string> candidates_of(const std::string& name, SoughtFile type) {
    std::vector<std::string> names;
    const std::vector<std::string> extensions = extensions_of(type);
    const std::string own = fs::path(name).extension().string();
    const bool has_own = std::find(extensions.begin(), extensions.end(), own) != extensions.end();
    if (has_own) names.push_back(name);
    for (const std::string& extension : extensions) names.push_back(name + extension);
    if (!has_own) names.push_back(name);
    return names;
}

bool is_file(const fs::path& path) {
    std::error_code error;
    return fs::is_regular_file(path, error);
}

std::optional<std::string> find_exactly(const Session& session, const std::string& name, SoughtFile type) {
    if (!session.options.file_access) return std::nullopt;
    for (const std::string& candidate : candidates_of(name, type)) {
        if (is_file(candidate)) return candidate;
        if (fs::path(candidate).is_absolute()) continue;
        for (const std::string& folder : session.options.library_paths) {
            const fs::path path = fs::path(folder) / candidate;
            if (is_file(path)) return path.string();
        }
    }
    return std::nullopt;
}

bool same_without_case(std::string_view a, std::string_view b) {
    return std::ranges::equal(
        a, b, [](unsigned char x, unsigned char y) { return std::tolower(x) == std::tolower(y); });
}

/// The entry of `folder` that equals `name` but for case: the name itself, otherwise the first of the
/// alphabet.
std::optional<fs::path> entry_without_case(const fs::path& folder, const fs::path& name) {
    std::error_code error;
    if (fs::exists(folder / name, error)) return folder / name;
    std::optional<fs::path> best;
    fs::directory_iterator entry(folder.empty() ? fs::path(".") : folder, error);
    for (; !error && entry != fs::directory_iterator(); entry.increment(error)) {
        const fs::path found = entry->path().filename();
        if (!same_without_case(found.string(), name.string())) continue;
        if (!best || found < best->filename()) best = folder / found;
    }
    return best;
}

std::optional<std::string> find_without_case(fs::path folder, const fs::path& name) {
    for (const fs::path& part : name) {
        const auto entry = entry_without_case(folder, part);
        if (!entry) return std::nullopt;
        folder = *entry;
    }
    if (!is_file(folder)) return std::nullopt;
    return folder.string();
}

/// A name as another system writes it: `C:\pics\Wood.TGA` becomes `/pics/Wood.TGA`.
std::string portable(std::string name) {
    std::ranges::replace(name, '\\', '/');
    if (name.size() > 1 && name[1] == ':' && std::isalpha(static_cast<unsigned char>(name[0])))
        name.erase(0, 2);
    return name;
}

std::optional<std::string> find_leniently(const Session& session, const std::string& name, SoughtFile type) {
    if (!session.options.file_access) return std::nullopt;
    const fs::path meant(portable(name));
    for (const fs::path& tried : {meant, meant.filename()}) {
        for (const std::string& candidate : candidates_of(tried.string(), type)) {
            if (tried.is_absolute()) {
                if (auto path = find_without_case({}, candidate)) return path;
                continue;
            }
            if (auto path = find_without_case({}, candidate)) return path;
            for (const std::string& folder : session.options.library_paths) {
                if (auto path = find_without_case(folder, candidate)) return path;
            }
        }
    }
    return std::nullopt;
}

}  // namespace

std::optional<std::string> find_file(Session& session, const std::string& name, SoughtFile type,
                                     SourceRange where) {
    std::optional<std::string> path = find_exactly(session, name, type);
    if (!path && !session.options.strict && !name.empty()) {
        path = find_leniently(session, name, type);
        if (path && session.replaced_files.insert(name).second) {
            session.warn(where, fmt::format("Cannot find file '{}': '{}' is used instead.", name, *path));
        }
    }
    if (path && session.options.file_used) session.options.file_used(*path);
    return path;
}

bool names_file_type(std::string_view word) {
    constexpr std::array<std::string_view, 15> types{"png", "gif", "tga", "iff", "ppm", "pgm", "jpeg", "tiff",
                                                     "exr", "hdr", "bmp", "df3", "ttf", "sys", "pot"};
    return std::ranges::find(types, word) != types.end();
}

bool file_exists(const Session& session, const std::string& name) {
    return find_exactly(session, name, SoughtFile::data).has_value();
}

void check_may_write(const Session& session, const std::string& path, SourceRange where) {
    const auto& may_write = session.options.may_write;
    if (!may_write || may_write(path)) return;
    throw SceneError(where, fmt::format("Writing to {} is not allowed: only below the current directory, the "
                                        "picture's and temporary ones; --allow-write DIR allows more.",
                                        path));
}

SceneError missing_file(Session& session, const std::string& name, SoughtFile type, SourceRange where,
                        std::string message) {
    session.diagnostics.report(
        {Severity::possible_error,
         where,
         fmt::format("Cannot find file '{}', even after trying to append file type extension.", name),
         {}});
    std::string places = "in the current directory";
    for (const std::string& folder : session.options.library_paths) places += fmt::format(", '{}'", folder);
    if (fs::path(name).is_absolute() && session.options.strict) places = "nowhere else";
    std::string note =
        fmt::format("looked for '{}' {}", fmt::join(candidates_of(name, type), "', '"), places);
    if (!session.options.strict) note += ", there also without regard to case and by the base name";
    return SceneError({Severity::error, where, std::move(message), {{Severity::note, {}, note, {}}}});
}

}  // namespace rb
