// The home of CLI11: the long-option face. What it does not know goes, in order, to the POV-Ray face.
#include "app/command_line.h"

#include "app/ini_options.h"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace rb {

namespace {

constexpr std::string_view version_text =
    "RenderBoy 0.1.0\nReads the scenes of POV-Ray 3.7 and takes its command line "
    "(as POV-Ray 3.7.0.10.unofficial does).\n";

constexpr std::string_view footer =
    "POV-Ray's own words are taken too, in any mix: +Iscene.pov +Oout.png +W640 +H480 +A0.3 +AM2 +R3 +J +Q9 "
    "+FN16 +UA\n"
    "+L<dir> +WT<n> +SC +EC +SR +ER -D -P -V, Name=value options, file.ini[section].\n\n"
    "renderboy check SCENE reads a scene and lists what does not work yet (--deps: the files it uses).\n"
    "renderboy diff A B compares two pictures; see `renderboy diff --help`.\n"
    "renderboy compare SCENE... renders with POV-Ray, too, and compares; see `renderboy compare --help`.\n"
    "Exit codes: 0 done, 1 error (or a limit of diff or compare passed), 2 stopped by a signal.";

void set_size(Settings& settings, const std::string& text) {
    const size_t cross = text.find_first_of("xX");
    if (cross == std::string::npos) throw UsageError(fmt::format("--size {}: WIDTHxHEIGHT expected", text));
    set_option(settings, "Width", text.substr(0, cross));
    set_option(settings, "Height", text.substr(cross + 1));
}

/// "0.5%" or "0.005"; more than 0.
double share_of(std::string_view option, const std::string& text) {
    double value = 0;
    size_t used = 0;
    try {
        value = std::stod(text, &used);
    } catch (const std::logic_error&) {
        used = 0;
    }
    const std::string unit = text.substr(used);
    if (unit == "%") value /= 100.0;
    if (used == 0 || (unit != "" && unit != "%") || !(value > 0.0) || !std::isfinite(value))
        throw UsageError(fmt::format("{} {}: a share such as 0.5% expected", option, text));
    return value;
}

/// The words of a command with options of its own.
void parse_own(CLI::App& app, const std::vector<std::string>& arguments, CommandLine& line) {
    std::vector<std::string> reversed(arguments.rbegin(), arguments.rend());
    try {
        app.parse(reversed);
    } catch (const CLI::CallForHelp&) {
        line.command = Command::help;
        line.text = app.help();
    } catch (const CLI::ParseError& error) {
        throw UsageError(error.what());
    }
}

void add_limits(CLI::App& app, DifferenceLimits& limits) {
    app.add_option("--max-rmse", limits.max_rmse, "exit 1 above this RMSE (in 1/255)");
    std::string off = "exit 1 above this share of pixels off by more than 8/255 (0..1";
    if (limits.max_off) off += fmt::format("; default: {}", *limits.max_off);
    app.add_option("--max-off", limits.max_off, off + ")");
    app.add_option("--min-ssim", limits.min_ssim, "exit 1 below this structural similarity");
}

CommandLine parse_diff(const std::vector<std::string>& arguments) {
    CommandLine line;
    line.command = Command::diff;
    CLI::App app{
        "Compares two pictures of the same size: RMSE, share of pixels off by more than 8/255, SSIM.",
        "renderboy diff"};
    DiffSettings& diff = line.diff;
    app.add_option("first", diff.first, "a picture")->required();
    app.add_option("second", diff.second, "another picture")->required();
    app.add_option("--heat-map", diff.heat_map, "write the difference as a picture");
    add_limits(app, diff.limits);
    app.add_flag("--json", diff.json, "print JSON");
    parse_own(app, arguments, line);
    return line;
}

/// One scene a line, its own switches behind it; `#` starts a comment.
void read_scene_list(const std::string& path, std::vector<SceneToCompare>& out) {
    std::ifstream in(path);
    if (!in) throw UsageError(fmt::format("{}: cannot be read", path));
    for (std::string line; std::getline(in, line);) {
        std::vector<std::string> words = split_words(line.substr(0, line.find('#')));
        if (words.empty()) continue;
        out.push_back({words.front(), {words.begin() + 1, words.end()}});
    }
}

CommandLine parse_compare(const std::vector<std::string>& arguments) {
    CommandLine line;
    line.command = Command::compare;
    CLI::App app{
        "Renders scenes with POV-Ray and with RenderBoy, each in a process of its own, and compares pictures "
        "and times. POV-Ray's words (+W640, +A0.3, +Lfolder, Name=value, file.ini) go to both; 320x240 by "
        "default.",
        "renderboy compare"};
    CompareSettings& compare = line.compare;
    std::optional<std::string> list;
    app.allow_extras();
    app.add_option("--list", list, "a file with a scene and its own switches in each line");
    app.add_option("--povray", compare.povray, "the program to compare with (default: povray)");
    app.add_option("--timeout", compare.timeout, "seconds after which a run is killed (default: 600)")
        ->check(CLI::PositiveNumber);
    add_limits(app, compare.limits);
    app.add_option("--html", compare.html, "write a page with all pictures and figures");
    app.add_option("--table", compare.table, "write the figures as a table with tabs");
    app.add_option("--cache", compare.cache,
                   "folder that keeps pictures and figures; what is there is not rendered again");
    parse_own(app, arguments, line);
    if (line.command == Command::help) return line;
    if (list) read_scene_list(*list, compare.scenes);
    for (const std::string& word : app.remaining()) {
        if (std::filesystem::path(word).extension() == ".pov" && word.front() != '+' && word.front() != '-') {
            compare.scenes.push_back({word, {}});
        } else {
            compare.words.push_back(word);
        }
    }
    if (compare.scenes.empty()) throw UsageError("compare: no scene (a file that ends in .pov)");
    return line;
}

/// An argument is split at blanks as the reference does, unless it is the name of a file that exists.
void apply_argument(Settings& settings, const std::string& argument) {
    std::error_code ignored;
    if (argument.find(' ') != std::string::npos && std::filesystem::exists(argument, ignored)) {
        apply_word(settings, argument);
        return;
    }
    for (const std::string& word : split_words(argument)) apply_word(settings, word);
}

/// The long options: what is not part of the settings, or goes through them after all other words.
class LongOptions {
public:
    LongOptions(CLI::App& app, Settings& settings, bool checks) {
        add_common(app);
        add_rendering(app, settings);
        app.add_flag("--strict", settings.strict,
                     "exact file names and syntax only; otherwise trifles are warnings");
        app.add_option("--allow-write", settings.allow_write,
                       "a folder below which the scene may write files, too (more than once)")
            ->allow_extra_args(false);
        app.add_flag("--allow-commands", settings.allow_commands,
                     "run the Pre_/Post_ commands of INI files in a shell");
        app.add_option("--max-parse-steps", settings.max_parse_steps,
                       "tokens after which a scene counts as endless (0: never)");
        if (checks) app.add_flag("--deps", settings.list_files, "list the files that the scene is made of");
    }

    bool asks_version() const { return version_; }

    void apply(Settings& settings) const {
        settings.skip_unneeded = !no_skip_;
        if (settings.stats_file == "json") settings.stats_file = "-";
        if (size_) set_size(settings, *size_);
        if (threads_) set_option(settings, "Work_Threads", *threads_);
        if (quality_) set_option(settings, "Quality", *quality_);
        if (error_) {
            settings.antialias = true;
            settings.antialias_options.method = method_by_error;
            settings.antialias_options.error = share_of("--error", *error_);
        }
        if (gi_error_) settings.gi_error = share_of("--gi-error", *gi_error_);
        if (!output_) return;
        set_option(settings, "Output_File_Name", *output_);
        if (const auto type = file_type_for(*output_)) settings.file_type = *type;
    }

private:
    void add_common(CLI::App& app) {
        app.set_help_flag("--help", "this text");
        app.add_flag("--version", version_, "print the version");
        app.add_option("-o,--output", output_, "picture to write; the extension decides the type");
        app.add_option("--size", size_, "WIDTHxHEIGHT in pixels");
        app.add_option("--threads", threads_, "threads to use (default: all)");
        app.add_option("--quality", quality_, "0..9, as +Q");
    }

    void add_rendering(CLI::App& app, Settings& settings) {
        const std::map<std::string, GeometryMode> modes{{"auto", GeometryMode::automatic},
                                                        {"exact", GeometryMode::exact},
                                                        {"tessellate", GeometryMode::tessellate},
                                                        {"refine", GeometryMode::refine}};
        app.add_option("--geometry", settings.geometry,
                       "auto, exact, tessellate or refine: how shapes meet rays (refine: hits on a "
                       "mesh are moved onto the true surface)")
            ->transform(CLI::CheckedTransformer(modes));
        app.add_option("--tessellation-error", settings.tessellation_error,
                       "largest error of a mesh, in pixels")
            ->check(CLI::PositiveNumber);
        const std::map<std::string, InstanceMode> sharing{{"auto", InstanceMode::automatic},
                                                          {"always", InstanceMode::always},
                                                          {"never", InstanceMode::never}};
        app.add_option("--instances", settings.instances,
                       "auto, always or never: whether copies of a compound share its surfaces; same picture")
            ->transform(CLI::CheckedTransformer(sharing));
        app.add_option(
            "--error", error_,
            "antialiasing: sample each pixel until its error is estimated to be below this, such as 0.5%");
        app.add_option("--max-samples", settings.antialias_options.max_samples,
                       "most samples of a pixel with --error (default: 1024)")
            ->check(CLI::Range(1u, 1u << 24));
        app.add_option("--seed", settings.seed, "another number changes everything that is drawn at random");
        const std::map<std::string, AreaLightMode> areas{{"auto", AreaLightMode::as_written},
                                                         {"grid", AreaLightMode::grid},
                                                         {"smooth", AreaLightMode::smooth},
                                                         {"true", AreaLightMode::true_area}};
        app.add_option(
               "--area-light", settings.area_lights,
               "grid, smooth or true: area lights as POV-Ray's grid of points, as the grid's density, or "
               "as even areas (default: the grid, or its density with jitter)")
            ->transform(CLI::CheckedTransformer(areas));
        const std::map<std::string, GiMode> lights{{"auto", GiMode::automatic},
                                                   {"off", GiMode::off},
                                                   {"brute", GiMode::brute},
                                                   {"points", GiMode::points},
                                                   {"cache", GiMode::cache}};
        app.add_option("--gi", settings.gi,
                       "auto, points, cache, brute or off: how radiosity{} is carried out")
            ->transform(CLI::CheckedTransformer(lights));
        app.add_option("--gi-view", settings.view_surfels,
                       "surfels: show what radiosity has learned of the surfaces, not the picture")
            ->transform(CLI::CheckedTransformer(std::map<std::string, bool>{{"surfels", true}}));
        app.add_option(
            "--gi-error", gi_error_,
            "RMSE that indirect light is to have, such as 0.5%, whatever radiosity{} says of count and "
            "error_bound");
        const std::map<std::string, DumpStage> stages{
            {"tokens", DumpStage::tokens}, {"blocks", DumpStage::blocks}, {"scene", DumpStage::scene}};
        app.add_option("--dump", settings.dump, "print tokens, blocks or scene instead of rendering")
            ->transform(CLI::CheckedTransformer(stages));
        app.add_option("--stats", settings.stats_file,
                       "write statistics as JSON to a file (json or -: standard error)");
        app.add_flag("--preview", settings.preview,
                     "write coarse pictures first, the first one after a second or so");
        app.add_flag("--explain", settings.explain,
                     "say what was done for the picture, and what the scene did not need");
        app.add_flag("--no-skip", no_skip_, "do work that the scene does not need, too; same picture");
        app.add_flag("--brute-force", settings.brute_force, "no kD-trees; same picture, slowly");
    }

    std::optional<std::string> output_, size_, quality_, threads_, error_, gi_error_;
    bool version_ = false;
    bool no_skip_ = false;
};

}  // namespace

bool DifferenceLimits::hold(const ImageDifference& d) const {
    return (!max_rmse || d.rmse <= *max_rmse) && (!max_off || d.share_off <= *max_off) &&
           (!min_ssim || d.ssim >= *min_ssim);
}

CommandLine parse_command_line(const std::vector<std::string>& arguments) {
    const std::string first = arguments.empty() ? "" : arguments.front();
    if (first == "diff") return parse_diff({arguments.begin() + 1, arguments.end()});
    if (first == "compare") return parse_compare({arguments.begin() + 1, arguments.end()});
    CommandLine line;
    Settings& settings = line.settings;
    if (first == "check") line.command = Command::check;
    CLI::App app{"Renders POV-Ray 3.7 scenes.", "renderboy"};
    app.footer(std::string(footer));
    app.allow_extras();
    LongOptions own(app, settings, line.command == Command::check);

    std::vector<std::string> reversed(arguments.rbegin(), arguments.rend());
    if (first == "render" || first == "check") reversed.pop_back();
    // The reference's other spellings, which CLI11 would take apart.
    for (std::string& word : reversed) {
        if (word == "-version" || word == "--V") word = "--version";
        if (word == "-help" || word == "-?") word = "--help";
        if (word == "-benchmark" || word == "--benchmark") {
            throw UsageError("there is no built-in benchmark: time the scene that matters to you");
        }
    }
    try {
        app.parse(reversed);
    } catch (const CLI::CallForHelp&) {
        line.command = Command::help;
        line.text = app.help();
        return line;
    } catch (const CLI::ParseError& error) {
        throw UsageError(error.what());
    }
    if (own.asks_version()) {
        line.command = Command::version;
        line.text = version_text;
        return line;
    }
    read_initial_ini(settings);
    for (const std::string& word : app.remaining()) apply_argument(settings, word);
    own.apply(settings);
    if (settings.input_file.empty()) throw UsageError("No input file provided");
    if (settings.width < 1 || settings.height < 1 || settings.width > (1 << 28) / settings.height) {
        throw UsageError(
            fmt::format("a picture of {}x{} pixels cannot be rendered", settings.width, settings.height));
    }
    return line;
}

}  // namespace rb
