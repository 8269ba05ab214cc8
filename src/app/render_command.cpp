#include "app/animation.h"
#include "app/commands.h"
#include "app/console.h"
#include "app/create_ini.h"
#include "app/explanation.h"
#include "app/geometry_oracle.h"
#include "app/message_files.h"
#include "app/picture.h"
#include "app/picture_state.h"
#include "app/scene_input.h"
#include "app/shell_commands.h"
#include "app/statistics.h"
#include "base/parallel.h"
#include "language/load.h"
#include "render/preview.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <unistd.h>

#include <fmt/format.h>

namespace rb {

namespace {

std::atomic<bool> stop_requested{false};
std::atomic<bool> is_rendering{false};

/// SIGINT and SIGTERM end the render after the running blocks; what is finished is written. A second signal
/// kills. Before that there is nothing to keep.
void on_signal(int signal) {
    stop_requested.store(true);
    std::signal(signal, SIG_DFL);
    if (is_rendering.load()) return;
    constexpr std::string_view last_words = "\nRender cancelled by user\n\n";
    [[maybe_unused]] const auto written = write(STDERR_FILENO, last_words.data(), last_words.size());
    _exit(exit_stopped);
}

double seconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

RenderOptions render_options(const Settings& settings) {
    RenderOptions options;
    options.width = settings.width;
    options.height = settings.height;
    options.region = region_of(settings);
    options.block_size = settings.block_size;
    options.threads = settings.threads;
    options.seed = settings.seed;
    options.antialias = settings.antialias_options;
    if (!settings.antialias) options.antialias.method = 0;
    options.antialias.jitter = settings.jitter ? settings.jitter_amount : 0.0;
    options.shading.quality = settings.quality;
    options.shading.skip_unneeded = settings.skip_unneeded;
    options.shading.alpha_output = settings.alpha;
    options.shading.area_lights = settings.area_lights;
    options.gi = settings.gi;
    if (settings.radiosity_from_file) options.radiosity_files.load = settings.radiosity_file;
    if (settings.radiosity_to_file) options.radiosity_files.save = settings.radiosity_file;
    options.gi_error = settings.gi_error;
    options.view_surfels = settings.view_surfels;
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
    options.instances = settings.instances;
    return options;
}

int dump_stage(const Settings& settings, const AnimationFrame& frame, Console& console) {
    SourceMap sources;
    Diagnostics diagnostics;
    ProbeOracle oracle(diagnostics);
    const LoadOptions options = load_options(settings, frame, console, oracle);
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
    console.report(diagnostics, sources);
    print(text);
    return loaded && diagnostics.error_count() == 0 ? exit_done : exit_error;
}

/// The scene of one picture; false if it has errors, which have been shown.
bool load(const LoadOptions& options, Console& console, SourceMap& sources, Diagnostics& diagnostics,
          Scene& scene) {
    const bool loaded = load_scene(options, sources, diagnostics, scene);
    console.report(diagnostics, sources);
    if (!loaded) console.line("Fatal error in parser: Cannot parse input.");
    return loaded;
}

std::string picture_path(const Settings& settings, const AnimationFrame& frame) {
    const std::string number = frame.digits > 0 ? fmt::format("{:0{}}", frame.number, frame.digits) : "";
    return output_path(settings, number);
}

void write_picture(const Film& film, const GlobalSettings& scene, const Settings& settings,
                   const AnimationFrame& frame) {
    const auto& assumed = scene.assumed_gamma;
    OutputFormat format;
    format.type = settings.file_type;
    format.bits = output_bits(settings);
    format.compression = settings.compression;
    format.dither = dithering_of(assumed, settings);
    if (assumed)
        format.curve = is_linear(settings.file_type) ? Curve(GammaCurve{1.0}) : Curve(settings.file_gamma);
    write_image(picture_of(film, assumed, settings), format, picture_path(settings, frame));
}

/// What decides a picture besides the texts read.
std::string identity_words(const Settings& settings, const AnimationFrame& frame) {
    std::string words = fmt::format("frame {} clock {}", frame.number, frame.clock);
    for (const auto& [name, value] : settings.given) {
        constexpr std::array<std::string_view, 4> free{"continue_trace", "work_threads", "verbose",
                                                       "display"};
        if (std::ranges::find(free, name) == free.end()) words += fmt::format("\n{}={}", name, value);
    }
    if (settings.view_surfels) words += "\nsurfels";
    words +=
        fmt::format("\nseed {} area lights {} error {} of {} gi {} {}", settings.seed,
                    static_cast<int>(settings.area_lights), settings.antialias_options.error,
                    settings.antialias_options.max_samples, static_cast<int>(settings.gi), settings.gi_error);
    return words;
}

/// Takes up what an interrupted run left, if that is asked for and fits.
void prepare(PictureState& state, uint64_t identity, const Settings& settings, Console& console) {
    state.begin(identity);
    if (!state.exists()) return;
    if (!settings.continue_trace) return state.remove();
    if (!state.load(identity)) {
        console.line("warning: the interrupted picture was another one: it is rendered from the start");
        state.remove();
    }
}

/// For Render_File.
std::string options_text(const Settings& settings) {
    return fmt::format(
        "Input file: {}\nImage resolution: {} by {}\nQuality: {}\nAntialiasing: {}\nThreads: {}\n",
        settings.input_file, settings.width, settings.height, settings.quality,
        settings.antialias ? fmt::format("method {}", settings.antialias_options.method) : "off",
        settings.threads > 0 ? fmt::to_string(settings.threads) : "all");
}

/// What reading one scene gives.
struct ReadScene {
    SourceMap sources;
    Diagnostics diagnostics;
    Scene scene;
};

bool keeps_state(const Settings& settings, const std::string& path) {
    return settings.output_to_file && path != "-";
}

/// Compiles, renders and writes one picture. Throws a SceneError where a function of the scene fails.
int draw_frame(const Settings& settings, const AnimationFrame& frame, ReadScene& read, PictureState& state,
               Statistics& statistics, Console& console) {
    const bool keeps = keeps_state(settings, picture_path(settings, frame));
    const RenderOptions options = render_options(settings);
    auto start = std::chrono::steady_clock::now();
    const size_t reported = read.diagnostics.all().size();
    const World world = compile(std::move(read.scene), compile_options(settings), read.diagnostics);
    console.report(read.diagnostics, read.sources, reported);
    statistics.compile_seconds = seconds_since(start);

    if (keeps) prepare(state, identity_of(read.sources, identity_words(settings, frame)), settings, console);

    start = std::chrono::steady_clock::now();
    console.banner("Rendering");
    is_rendering.store(true);
    if (settings.preview && keeps) {
        preview(world, options, stop_requested,
                [&](const Film& film) { write_picture(film, world.settings, settings, frame); });
    }
    const auto progress = [&](size_t done, size_t total) { console.progress(done, total); };
    const RenderResult result = render(world, options, stop_requested, progress, keeps ? &state : nullptr);
    console.end_progress();
    statistics.render_seconds = seconds_since(start);

    start = std::chrono::steady_clock::now();
    if (keeps && !result.complete) state.keep(result.film);
    if (settings.output_to_file) write_picture(result.film, world.settings, settings, frame);
    if (keeps && result.complete) state.remove();
    is_rendering.store(false);
    statistics.write_seconds = seconds_since(start);
    if (settings.view_surfels && !(result.radiosity && !result.radiosity->cells.empty()))
        console.line("warning: --gi-view surfels: there are none without radiosity{} and --gi points");
    const std::string numbers = statistics_text(statistics, world, result);
    console.keep(MessageStream::statistics, numbers);
    if (settings.explain) console.line(numbers + explanation(world, result));
    if (settings.stats_file) write_statistics(statistics, world, result, settings);
    return result.complete ? exit_done : exit_stopped;
}

/// Reads a scene and makes its picture; an exit code.
int render_frame(const Settings& settings, const AnimationFrame& frame, Console& console) {
    const std::string path = picture_path(settings, frame);
    PictureState state(path);
    if (keeps_state(settings, path) && settings.continue_trace && !state.exists() &&
        std::filesystem::exists(path)) {
        console.line("File already rendered and continue requested; skipping.");
        return exit_done;
    }
    Statistics statistics;
    const double cpu_before = cpu_seconds();
    const auto start = std::chrono::steady_clock::now();
    console.banner("Parsing");
    ReadScene read;
    ProbeOracle oracle(read.diagnostics);
    if (!load(load_options(settings, frame, console, oracle), console, read.sources, read.diagnostics,
              read.scene)) {
        return exit_error;
    }
    statistics.parse_seconds = seconds_since(start);
    statistics.parse_cpu_seconds = cpu_seconds() - cpu_before;
    statistics.parse_peak_memory = peak_memory();
    try {
        return draw_frame(settings, frame, read, state, statistics, console);
    } catch (const SceneError& error) {
        console.diagnostic(error.diagnostic(), read.sources);
        is_rendering.store(false);
        return exit_error;
    }
}

int code_after(AfterCommand after) {
    if (after == AfterCommand::abort) return exit_stopped;
    return after == AfterCommand::fail ? exit_error : exit_done;
}

/// All frames, with the commands before and after them; an exit code.
int render_frames(const Settings& settings, const std::vector<AnimationFrame>& frames,
                  const ShellCommands& commands, Console& console) {
    AfterCommand after = commands.run(ShellMoment::pre_scene, frames.front());
    for (const AnimationFrame& frame : frames) {
        if (after != AfterCommand::go_on) break;
        after = commands.run(ShellMoment::pre_frame, frame);
        if (after > AfterCommand::skip) break;
        if (after == AfterCommand::go_on) {
            const int code = render_frame(settings, frame, console);
            if (code != exit_done) return code;
        }
        after = commands.run(ShellMoment::post_frame, frame);
    }
    if (after <= AfterCommand::skip) after = commands.run(ShellMoment::post_scene, frames.back());
    return code_after(after);
}

}  // namespace

int run_render(const Settings& settings) {
    Console console(settings.verbose, settings.warning_console);
    for (const std::string& text : settings.without_effect) console.line(fmt::format("warning: {}", text));
    const std::vector<AnimationFrame> frames = frames_of(settings);
    if (settings.dump != DumpStage::none) return dump_stage(settings, frames.front(), console);
    MessageFiles files(settings);
    console.write_to(files);
    console.keep(MessageStream::render, options_text(settings));
    stop_requested.store(false);
    std::signal(SIGINT, on_signal);
    std::signal(SIGTERM, on_signal);
    create_ini(settings);
    const ShellCommands commands(settings, console);
    const ThreadLimit limit(settings.threads);
    const int code = render_frames(settings, frames, commands, console);
    if (code == exit_stopped) {
        console.line("Render cancelled by user\n");
        commands.run(ShellMoment::user_abort, frames.front());
    } else if (code == exit_error) {
        console.line("Render failed\n");
        commands.run(ShellMoment::fatal_error, frames.front());
    } else {
        console.line("POV-Ray finished\n");
    }
    return code;
}

int run(const std::vector<std::string>& arguments, std::string_view program) {
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
            case Command::compare:
                return run_compare(line.compare);
            case Command::check:
                return run_check(line.settings);
            case Command::render:
                return run_render(line.settings);
        }
    } catch (const UsageError& error) {
        std::string words(program);
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
