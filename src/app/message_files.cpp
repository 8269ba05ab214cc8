#include "app/message_files.h"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

namespace rb {

namespace {

/// The last lines of the file up to the end of the place.
std::string context_of(const SourceRange& where, const SourceMap& sources) {
    constexpr int lines = 5;
    const std::string_view before = sources.text(where.file).substr(0, where.end);
    size_t begin = before.size();
    for (int i = 0; i < lines && begin != 0 && begin != std::string_view::npos; ++i) {
        begin = before.rfind('\n', begin - 1);
    }
    begin = begin == std::string_view::npos || begin == 0 ? 0 : begin + 1;
    return fmt::format("File Context ({} lines):\n{}\n", lines, before.substr(begin));
}

}  // namespace

std::string_view kind_of(const Diagnostic& diagnostic) {
    switch (diagnostic.severity) {
        case Severity::error:
            return "Parse Error";
        case Severity::possible_error:
            return "Possible Parse Error";
        default:
            return "Parse Warning";
    }
}

std::string wrapped(std::string_view text) {
    constexpr size_t width = 80;
    std::string out;
    while (out.size() + text.size() > 0) {
        const size_t room = out.empty() ? width : width - 1;
        const size_t blank = text.size() > room ? text.rfind(' ', room) : std::string_view::npos;
        if (!out.empty()) out += "\n ";
        if (blank == std::string_view::npos || blank == 0) return out += text;
        out += text.substr(0, blank);
        text.remove_prefix(blank + 1);
    }
    return out;
}

MessageFiles::MessageFiles(const Settings& settings) {
    namespace fs = std::filesystem;
    const fs::path folder = fs::path(output_path(settings, "")).parent_path();
    for (size_t i = 0; i < settings.message_files.size(); ++i) {
        const std::string& name = settings.message_files[i];
        if (name.empty()) continue;
        if (name.find('/') != std::string::npos) {
            throw IoError("Stream output files must reside in same directory as image output file.");
        }
        const std::string path = (folder / name).string();
        std::FILE* const file = std::fopen(path.c_str(), settings.append_files ? "a" : "w");
        if (!file) throw IoError(fmt::format("Cannot open file '{}' for messages.", path));
        files_.push_back({static_cast<MessageStream>(i), std::unique_ptr<std::FILE, Close>(file)});
    }
}

void MessageFiles::write(MessageStream stream, std::string_view text) {
    for (const File& f : files_) {
        if (f.stream != stream && f.stream != MessageStream::all) continue;
        std::fwrite(text.data(), 1, text.size(), f.file.get());
        if (!text.ends_with('\n')) std::fputc('\n', f.file.get());
        std::fflush(f.file.get());
    }
}

void MessageFiles::write(const Diagnostic& diagnostic, const SourceMap& sources) {
    if (files_.empty() || diagnostic.severity == Severity::note) return;
    const bool is_error = diagnostic.severity == Severity::error;
    std::string text;
    if (diagnostic.where.known()) {
        const LineColumn place = sources.position(diagnostic.where.file, diagnostic.where.begin);
        text = fmt::format("File: {}  Line: {}\n", sources.name(diagnostic.where.file), place.line);
        if (is_error) text += context_of(diagnostic.where, sources);
    }
    text += wrapped(fmt::format("{}: {}", kind_of(diagnostic), diagnostic.message));
    write(is_error ? MessageStream::fatal : MessageStream::warning, text);
}

}  // namespace rb
