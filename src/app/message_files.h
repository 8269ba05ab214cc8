#pragma once
#include "app/settings.h"
#include "base/diagnostics.h"

#include <cstdio>
#include <memory>
#include <string_view>
#include <vector>

namespace rb {

/// The files that All_File, Debug_File and their like ask for (language spec 23.3, 24): each gets its
/// stream's messages in the reference's own form, whatever the console shows.
class MessageFiles {
public:
    /// Opens them beside the picture, empty unless Append_File is on; throws IoError if that fails or a name
    /// has a folder of its own.
    explicit MessageFiles(const Settings& settings);

    void write(MessageStream stream, std::string_view text);
    /// A warning or an error.
    void write(const Diagnostic& diagnostic, const SourceMap& sources);

private:
    struct Close {
        void operator()(std::FILE* file) const { std::fclose(file); }
    };
    struct File {
        MessageStream stream;
        std::unique_ptr<std::FILE, Close> file;
    };
    std::vector<File> files_;
};

/// "Parse Error" and the like: what a diagnostic begins with in the reference's form.
std::string_view kind_of(const Diagnostic& diagnostic);

/// Broken at blanks into lines of at most 80 characters; all but the first begin with a blank.
std::string wrapped(std::string_view text);

}  // namespace rb
