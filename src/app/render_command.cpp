#include "app/animation.h"
#include "app/commands.h"
#include "app/console.h"
#include "app/geometry_oracle.h"
#include "app/picture.h"
#include "app/statistics.h"
#include "base/parallel.h"
#include "language/load.h"

#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <iterator>

#include <fmt/format.h>

namespace rb {

namespace {

std::atomic<bool> stop_requested{false};

/// SIGINT and SIGTERM end the render after the running blocks; what is finished is written. A second signal
/// kills.
void on_signal(int signal) {
    stop_requested.store(true);
    std::signal(signal, SIG_DFL);
}

double seconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

LoadOptions load_options(const Settings& settings, const Frame& frame, Console& console,
                         GeometryOracle& oracle) {
    LoadOptions options;
    options.input_file = settings.input_file;
    if (settings.input_file == "-") {
        options.input_text = std::string(std::istreambuf_iterator<char>(std::cin), {});
        options.input_file = "stdin";
    }
    options.library_paths = settings.library_paths;
    // The reference does not look beside the scene file; here it is the last place.
    const auto folder = std::filesystem::path(settings.input_file).parent_path();
    if (!folder.empty()) options.library_paths.push_back(folder.string());
    options.declares = settings.declares;
    options.include_header = settings.include_header;
    options.image_width = settings.width;
    options.image_height = settings.height;
    options.clock = frame.clock;
    options.clock_on = settings.clock_given || frame.digits > 0;
    options.frame_number = frame.number;
    options.initial_frame = frame.initial_frame;
    options.final_frame = frame.final_frame;
    options.initial_clock = frame.initial_clock;
    options.final_clock = frame.final_clock;
    options.clock_delta = frame.clock_delta;
    options.version = settings.version;
    options.oracle = &oracle;
    options.max_tokens = settings.max_parse_steps;
    options.message = [&console](std::string_view, std::string_view text) {
        if (text.ends_with('\n')) text.remove_suffix(1);
        console.line(text);
    };
    return options;
}

RenderOptions render_options(const Settings& settings) {
    RenderOptions options;
    options.width = settings.width;
    options.height = settings.height;
    options.region = region_of(settings);
    options.block_size = settings.block_size;
    options.threads = settings.threads;
    options.antialias = settings.antialias_options;
    if (!settings.antialias) options.antialias.method = 0;
    options.antialias.jitter = settings.jitter ? settings.jitter_amount : 0.0;
    options.shading.quality = settings.quality;
    options.shading.skip_unneeded = settings.skip_unneeded;
    options.shading.alpha_output = settings.alpha;
    return options;
}

CompileOptions compile_options(const Settings& settings) {
    CompileOptions options;
    options.geometry = settings.geometry;
    options.tessellation_error_pixels = settings.tessellation_error;
    options.image_width = settings.width;
    options.image_height = settings.height;
    options.threads = settings.threads;
    options.brute_force = settings.brute_force;
    return options;
}

void report(Console& console, const Diagnostics& diagnostics, const SourceMap& sources, size_t& reported) {
    for (; reported < diagnostics.all().size(); ++reported)
        console.diagnostic(diagnostics.all()[reported], sources);
}

int dump_stage(const Settings& settings, const LoadOptions& options) {
    SourceMap sources;
    Diagnostics diagnostics;
    std::string text;
    bool loaded = true;
    switch (settings.dump) {
        case DumpStage::tokens:
            text = dump_tokens(options, sources, diagnostics);
            break;
        case DumpStage::blocks:
            text = dump_blocks(options, sources, diagnostics);
            break;
        default: {
            Scene scene;
            loaded = load_scene(options, sources, diagnostics, scene);
            if (loaded) text = dump(scene);
        }
    }
    Console console(false);
    size_t reported = 0;
    report(console, diagnostics, sources, reported);
    std::fwrite(text.data(), 1, text.size(), stdout);
    return loaded && diagnostics.error_count() == 0 ? exit_done : exit_error;
}

/// The scene of one picture; false if it has errors, which have been shown.
bool load(const LoadOptions& options, Console& console, SourceMap& sources, Diagnostics& diagnostics,
          Scene& scene) {
    size_t reported = 0;
    const bool loaded = load_scene(options, sources, diagnostics, scene);
    report(console, diagnostics, sources, reported);
    if (!loaded) console.line("Fatal error in parser: Cannot parse input.");
    return loaded;
}

void write_picture(const RenderResult& result, const Scene& scene, const Settings& settings,
                   const Frame& frame) {
    const auto& assumed = scene.settings.assumed_gamma;
    OutputFormat format;
    format.type = settings.file_type;
    format.bits = settings.bits_per_color;
    format.compression = settings.compression;
    if (assumed)
        format.curve = is_linear(settings.file_type) ? Curve(GammaCurve{1.0}) : Curve(settings.file_gamma);
    const std::string number = frame.digits > 0 ? fmt::format("{:0{}}", frame.number, frame.digits) : "";
    write_image(picture_of(result.film, assumed, settings), format, output_path(settings, number));
}

/// Reads, compiles, renders and writes one picture.
int render_frame(const Settings& settings, const Frame& frame, Console& console) {
    const RenderOptions options = render_options(settings);
    ProbeOracle oracle;
    const LoadOptions loading = load_options(settings, frame, console, oracle);

    Statistics statistics;
    auto start = std::chrono::steady_clock::now();
    console.banner("Parsing");
    SourceMap sources;
    Diagnostics diagnostics;
    Scene scene;
    if (!load(loading, console, sources, diagnostics, scene)) {
        console.line("Render failed\n");
        return exit_error;
    }
    statistics.parse_seconds = seconds_since(start);

    start = std::chrono::steady_clock::now();
    size_t reported = diagnostics.all().size();
    const World world = compile(scene, compile_options(settings), diagnostics);
    report(console, diagnostics, sources, reported);
    statistics.compile_seconds = seconds_since(start);

    start = std::chrono::steady_clock::now();
    console.banner("Rendering");
    std::signal(SIGINT, on_signal);
    std::signal(SIGTERM, on_signal);
    const RenderResult result = render(world, options, stop_requested,
                                       [&](size_t done, size_t total) { console.progress(done, total); });
    console.end_progress();
    statistics.render_seconds = seconds_since(start);

    start = std::chrono::steady_clock::now();
    if (settings.output_to_file) write_picture(result, scene, settings, frame);
    statistics.write_seconds = seconds_since(start);
    if (settings.stats_file) write_statistics(statistics, world, result, settings);
    return result.complete ? exit_done : exit_stopped;
}

}  // namespace

int run_render(const Settings& settings) {
    Console console(settings.verbose);
    for (const std::string& text : settings.without_effect) console.line(fmt::format("warning: {}", text));
    const std::vector<Frame> frames = frames_of(settings);
    if (settings.dump != DumpStage::none) {
        ProbeOracle oracle;
        return dump_stage(settings, load_options(settings, frames.front(), console, oracle));
    }
    stop_requested.store(false);
    for (const Frame& frame : frames) {
        const int code = render_frame(settings, frame, console);
        if (code == exit_stopped) console.line("Render cancelled by user\n");
        if (code != exit_done) return code;
    }
    console.line("POV-Ray finished\n");
    return exit_done;
}

int run(const std::vector<std::string>& arguments) {
    const auto say = [](std::string_view text) { std::fwrite(text.data(), 1, text.size(), stderr); };
    try {
        const CommandLine line = parse_command_line(arguments);
        switch (line.command) {
            case Command::help:
            case Command::version:
                say(line.text);
                return exit_done;
            case Command::diff:
                return run_diff(line.diff);
            case Command::render:
                return run_render(line.settings);
        }
    } catch (const UsageError& error) {
        std::string words = "renderboy";
        for (const std::string& argument : arguments) words += " " + argument;
        say(fmt::format("error: {}\nProblem with option setting\n{}\nFailed to parse command-line option\n",
                        error.what(), words));
    } catch (const IoError& error) {
        say(fmt::format("error: {}\nRender failed\n\n", error.what()));
    } catch (const std::bad_alloc&) {
        say("error: out of memory\nRender failed\n\n");
    } catch (const std::exception& error) {
        say(fmt::format("internal error: {}\nRender failed\n\n", error.what()));
    }
    return exit_error;
}

}  // namespace rb
