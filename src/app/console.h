#pragma once
#include "app/settings.h"
#include "base/diagnostics.h"

#include <chrono>
#include <cstddef>
#include <string>
#include <string_view>

namespace rb {

class MessageFiles;

/// What a command answers, on standard output, at once.
void print(std::string_view text);

/// Everything else that the program says goes to standard error through here. On a terminal: short lines and
/// one progress line with the time left. Otherwise: the lines that programs which drive POV-Ray look for
/// (tests/app/contract.txt).
class Console {
public:
    /// `verbose` shows progress.
    Console(bool verbose, bool warnings);

    /// From now on messages go to these files, too; they must outlive the console.
    void write_to(MessageFiles& files) { files_ = &files; }

    /// Text that only the files get.
    void keep(MessageStream stream, std::string_view text);
    /// What a scene says (#debug and the like); `shown`: not only in the files.
    void message(std::string_view text, bool shown);
    void banner(std::string_view phase);
    void line(std::string_view text);
    /// One diagnostic, compiler style; an error is followed by the reference's own one-line form off a
    /// terminal.
    void diagnostic(const Diagnostic& diagnostic, const SourceMap& sources);
    /// All diagnostics from number `first` on.
    void report(const Diagnostics& diagnostics, const SourceMap& sources, size_t first = 0);
    void progress(size_t done, size_t total);
    void end_progress();

private:
    bool verbose_;
    bool warnings_;
    bool terminal_;
    bool progress_open_ = false;
    MessageFiles* files_ = nullptr;
    std::chrono::steady_clock::time_point started_;
    std::chrono::steady_clock::time_point last_;
};

}  // namespace rb
