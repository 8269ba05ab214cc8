#include "app/write_access.h"

#include <algorithm>
#include <cstdlib>

namespace rb {

namespace fs = std::filesystem;

namespace {

/// Absolute, without links, dots and a slash at the end; what does not exist yet is taken as it is written.
fs::path resolved(const fs::path& path) {
    std::error_code error;
    fs::path out = fs::weakly_canonical(fs::absolute(path, error), error).lexically_normal();
    return out.has_filename() ? out : out.parent_path();
}

}  // namespace

WriteAccess::WriteAccess(const Settings& settings) {
    std::vector<fs::path> folders{".", "/tmp", "/var/tmp"};
    if (const char* temporary = std::getenv("TMPDIR"); temporary && *temporary)
        folders.emplace_back(temporary);
    folders.insert(folders.end(), settings.allow_write.begin(), settings.allow_write.end());
    const fs::path picture = fs::path(output_path(settings, "")).parent_path();
    if (settings.output_to_file && !picture.empty()) folders.push_back(picture);
    for (const fs::path& folder : folders) roots_.push_back(resolved(folder));
}

bool WriteAccess::allows(const std::string& path) const {
    const fs::path file = resolved(path);
    return std::ranges::any_of(roots_, [&](const fs::path& root) {
        const auto [end, _] = std::mismatch(root.begin(), root.end(), file.begin(), file.end());
        return end == root.end();
    });
}

}  // namespace rb
