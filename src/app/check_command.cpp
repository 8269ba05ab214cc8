// renderboy check: reads a scene as a render would, and says what the picture would lack.
#include "app/commands.h"
#include "app/geometry_oracle.h"
#include "app/scene_input.h"

#include <set>

#include <fmt/format.h>

namespace rb {

namespace {

/// One line: place, feature, what happens instead.
std::string line_of(const Unsupported& missing, const SourceMap& sources) {
    std::string line;
    if (missing.where.known()) {
        const LineColumn place = sources.position(missing.where.file, missing.where.begin);
        line = fmt::format("{}:{}:{}: ", sources.name(missing.where.file), place.line, place.column);
    }
    line += fmt::format("{}: {}", missing.feature, missing.instead);
    if (missing.count > 1) line += fmt::format(" ({} places)", missing.count);
    return line + "\n";
}

/// Every file once, in the order in which they were first used.
class FileList {
public:
    void add(const std::string& path) {
        if (seen_.insert(path).second) print(path + "\n");
    }

private:
    std::set<std::string> seen_;
};

}  // namespace

int run_check(const Settings& settings) {
    Console console(settings.verbose, settings.warning_console);
    const std::vector<AnimationFrame> frames = frames_of(settings);
    SourceMap sources;
    Diagnostics diagnostics;
    ProbeOracle oracle(diagnostics);
    LoadOptions options = load_options(settings, frames.front(), console, oracle);
    FileList files;
    if (settings.list_files) {
        for (const std::string& path : settings.ini_files) files.add(path);
        options.file_used = [&](const std::string& path) { files.add(path); };
    }
    Scene scene;
    const bool loaded = load_scene(options, sources, diagnostics, scene);
    for (const Diagnostic& diagnostic : diagnostics.all()) {
        if (!diagnostic.is_unsupported) console.diagnostic(diagnostic, sources);
    }
    if (!loaded) console.line("Fatal error in parser: Cannot parse input.");
    if (settings.list_files) return loaded ? exit_done : exit_error;
    for (const std::string& text : settings.without_effect) print(text + "\n");
    for (const Unsupported& missing : diagnostics.all_unsupported()) print(line_of(missing, sources));
    const bool complete = diagnostics.all_unsupported().empty() && settings.without_effect.empty();
    return loaded && complete ? exit_done : exit_error;
}

}  // namespace rb
