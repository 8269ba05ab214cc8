#include "app/console.h"

#include "app/message_files.h"

#include <cstdio>
#include <cstdlib>
#include <unistd.h>

#include <fmt/format.h>

namespace rb {

namespace {

using namespace std::chrono_literals;
constexpr auto redraw_interval = 100ms;

void write(std::string_view text) { std::fwrite(text.data(), 1, text.size(), stderr); }

std::string duration_text(double seconds) {
    const auto whole = static_cast<long>(seconds + 0.5);
    if (whole < 60) return fmt::format("{} s", whole);
    if (whole < 3600) return fmt::format("{}:{:02} min", whole / 60, whole % 60);
    return fmt::format("{}:{:02} h", whole / 3600, whole / 60 % 60);
}

bool is_terminal() {
    const char* term = std::getenv("TERM");
    return isatty(STDERR_FILENO) == 1 && term && std::string_view(term) != "dumb" && !std::getenv("CI");
}

}  // namespace

void print(std::string_view text) {
    std::fwrite(text.data(), 1, text.size(), stdout);
    std::fflush(stdout);
}

Console::Console(bool verbose, bool warnings)
    : verbose_(verbose), warnings_(warnings), terminal_(is_terminal()) {}

void Console::keep(MessageStream stream, std::string_view text) {
    if (files_) files_->write(stream, text);
}

void Console::message(std::string_view text, bool shown) {
    keep(MessageStream::debug, text);
    if (text.ends_with('\n')) text.remove_suffix(1);
    if (shown) line(text);
}

void Console::banner(std::string_view phase) {
    started_ = last_ = std::chrono::steady_clock::now();
    if (!terminal_) line(fmt::format("{:=<76}", fmt::format("==== [{}...] ", phase)));
}

void Console::line(std::string_view text) {
    end_progress();
    write(text);
    write("\n");
}

void Console::diagnostic(const Diagnostic& diagnostic, const SourceMap& sources) {
    if (files_) files_->write(diagnostic, sources);
    if (!warnings_ && diagnostic.severity != Severity::error) return;
    end_progress();
    write(format(diagnostic, sources));
    if (terminal_ || diagnostic.severity == Severity::note) return;
    // Problem matchers of editors rely on how these lines are broken.
    const std::string_view kind = kind_of(diagnostic);
    if (diagnostic.where.known()) {
        const LineColumn place = sources.position(diagnostic.where.file, diagnostic.where.begin);
        line(wrapped(fmt::format("File '{}' line {}: {}: {}", sources.name(diagnostic.where.file), place.line,
                                 kind, diagnostic.message)));
    } else {
        line(wrapped(fmt::format("{}: {}", kind, diagnostic.message)));
    }
}

void Console::report(const Diagnostics& diagnostics, const SourceMap& sources, size_t first) {
    for (size_t i = first; i < diagnostics.all().size(); ++i) diagnostic(diagnostics.all()[i], sources);
}

void Console::progress(size_t done, size_t total) {
    if (!verbose_ || total == 0) return;
    const auto now = std::chrono::steady_clock::now();
    if (done < total && now - last_ < redraw_interval) return;
    last_ = now;
    const double share = static_cast<double>(done) / static_cast<double>(total);
    if (terminal_) {
        const double elapsed = std::chrono::duration<double>(now - started_).count();
        const double left = share > 0 ? elapsed / share - elapsed : 0;
        write(fmt::format("\r\033[Krendering {:3.0f} %  {} so far, {} left", 100 * share,
                          duration_text(elapsed), duration_text(left)));
    } else {
        write(fmt::format("Rendered {} of {} pixels ({}%)\r", done, total, static_cast<int>(100 * share)));
    }
    progress_open_ = true;
    std::fflush(stderr);
}

void Console::end_progress() {
    if (!progress_open_) return;
    write(terminal_ ? "\r\033[K" : "\n");
    progress_open_ = false;
}

}  // namespace rb
