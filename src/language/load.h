#pragma once
#include "base/diagnostics.h"
#include "language/oracle.h"
#include "scene/image.h"
#include "scene/scene.h"

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace rb {

/// What the command line says about reading a scene.
struct LoadOptions {
    std::string input_file;
    /// The text itself (tests, standard input); `input_file` is then only its name.
    std::optional<std::string> input_text;
    std::vector<std::string> library_paths;
    std::vector<std::pair<std::string, std::variant<double, std::string>>> declares;
    std::optional<std::string> include_header;
    int image_width = 160;
    int image_height = 120;
    double clock = 0;
    bool clock_on = false;
    int frame_number = 0;
    int initial_frame = 0;
    int final_frame = 0;
    double initial_clock = 0;
    double final_clock = 0;
    double clock_delta = 0;
    std::optional<double> version;
    GeometryOracle* oracle = nullptr;
    std::shared_ptr<ImageFiles> images;  ///< null: no picture file can be read
    /// Text of #debug, #warning, #render and #statistics, by stream name.
    std::function<void(std::string_view stream, std::string_view text)> message;
    /// Gives up after so many tokens (0: never), so that a loop without end is an error.
    uint64_t max_tokens = 0;
    /// Only exact file names and what the reference accepts; otherwise trifles are warnings.
    bool strict = false;
    /// Told of every file that is found, as often as it is asked for.
    std::function<void(const std::string& path)> file_used;
    /// Whether #fopen may write to this path; absent: it may.
    std::function<bool(const std::string& path)> may_write;
    bool file_access = true;        ///< false: the scene neither finds, reads nor writes files (fuzzing)
    bool quick_expressions = true;  ///< false: leave everything to the grammars (slow; for tests)
    bool number_runs = true;        ///< false: read long lists token by token (slow; for tests)
};

/// Reads a scene into `out`; false if errors were reported.
bool load_scene(const LoadOptions& options, SourceMap& sources, Diagnostics& diagnostics, Scene& out);

/// The tokens of the input after all directives, one a line, and the generic blocks of its statements.
std::string dump_tokens(const LoadOptions& options, SourceMap& sources, Diagnostics& diagnostics);
std::string dump_blocks(const LoadOptions& options, SourceMap& sources, Diagnostics& diagnostics);

/// All words that the language reserves (for completion, tests).
std::vector<std::string_view> reserved_words();

}  // namespace rb
