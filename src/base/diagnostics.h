#pragma once
#include "base/source.h"

#include <exception>
#include <string>
#include <string_view>
#include <vector>

namespace rb {

/// A possible error is what the reference calls so: a warning that often explains the error behind it.
enum class Severity { note, warning, possible_error, error };

/// Something to tell the user about a place in a scene. Notes carry "included from", "in expansion of macro",
/// hints.
struct Diagnostic {
    Severity severity = Severity::error;
    SourceRange where;
    std::string message;
    std::vector<Diagnostic> notes;
    bool is_unsupported = false;  ///< also listed by `Diagnostics::all_unsupported()`
};

/// The user's mistake in a scene file: unwinds to the nearest place that can go on (or to the application).
class SceneError : public std::exception {
public:
    explicit SceneError(Diagnostic diagnostic) : diagnostic_(std::move(diagnostic)) {}
    SceneError(SourceRange where, std::string message)
        : diagnostic_{Severity::error, where, std::move(message), {}} {}
    /// With a note that explains or tells what to do.
    SceneError(SourceRange where, std::string message, std::string note)
        : diagnostic_{
              Severity::error, where, std::move(message), {{Severity::note, {}, std::move(note), {}}}} {}

    const Diagnostic& diagnostic() const { return diagnostic_; }
    Diagnostic& diagnostic() { return diagnostic_; }
    const char* what() const noexcept override { return diagnostic_.message.c_str(); }

private:
    Diagnostic diagnostic_;
};

/// The machine's fault: a file that cannot be opened, read or written.
class IoError : public std::exception {
public:
    explicit IoError(std::string message) : message_(std::move(message)) {}
    const char* what() const noexcept override { return message_.c_str(); }

private:
    std::string message_;
};

/// A feature that a scene asks for and that does not work yet.
struct Unsupported {
    SourceRange where;  ///< first place
    std::string feature;
    std::string instead;  ///< what happens instead, as a sentence
    int count = 1;
};

/// Collects what is said about one scene, in order. Nothing below the application prints.
class Diagnostics {
public:
    void report(Diagnostic diagnostic);
    void warning(SourceRange where, std::string message);
    void error(SourceRange where, std::string message);

    /// Says once for each `feature` that it is not supported yet and what happens instead; later places are
    /// counted.
    void unsupported(SourceRange where, std::string_view feature, std::string_view instead);

    const std::vector<Diagnostic>& all() const { return all_; }
    const std::vector<Unsupported>& all_unsupported() const { return unsupported_; }
    int error_count() const { return errors_; }

private:
    std::vector<Diagnostic> all_;
    std::vector<Unsupported> unsupported_;
    int errors_ = 0;
};

/// Compiler style text: `file:line:column: error: message`, the source line, a caret, then the notes. Ends in
/// a newline.
std::string format(const Diagnostic& diagnostic, const SourceMap& sources);

/// The candidate closest to `word` (edit distance at most a third of its length), or an empty view.
std::string_view closest_word(std::string_view word, const std::vector<std::string_view>& candidates);

}  // namespace rb
