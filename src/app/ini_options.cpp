#include "app/ini_options.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <functional>
#include <span>

#include <fmt/format.h>

namespace rb {

namespace {

std::string lower(std::string_view text) {
    std::string out(text);
    std::ranges::transform(out, out.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return out;
}

[[noreturn]] void bad_value(std::string_view name, std::string_view value, std::string_view wanted) {
    throw UsageError(fmt::format("{}={}: {} expected", name, value, wanted));
}

double to_number(std::string_view name, std::string_view value) {
    double number = 0;
    const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), number);
    if (error != std::errc{} || end != value.data() + value.size()) bad_value(name, value, "a number");
    return number;
}

/// Whole numbers may be written as floats and are truncated (`Width=640.0`).
int to_integer(std::string_view name, std::string_view value) {
    const double number = to_number(name, value);
    if (!(std::abs(number) < 2147483648.0)) bad_value(name, value, "a number within 32 bits");
    return static_cast<int>(number);
}

constexpr std::array<std::string_view, 4> on_words{"on", "true", "yes", "1"};
constexpr std::array<std::string_view, 4> off_words{"off", "false", "no", "0"};

/// Where something else than on or off may stand: the whole word, in any case.
bool is_one_of(std::span<const std::string_view> words, std::string_view value) {
    return std::ranges::find(words, lower(value)) != words.end();
}

/// What begins with one of the words counts.
bool to_switch(std::string_view name, std::string_view value) {
    const std::string word = lower(value);
    const auto begins_word = [&word](std::string_view known) { return word.starts_with(known); };
    if (std::ranges::any_of(on_words, begins_word)) return true;
    if (std::ranges::any_of(off_words, begins_word)) return false;
    bad_value(name, value, "on or off");
}

void set_file_type(Settings& s, std::string_view value) {
    if (value.empty()) return;
    switch (std::toupper(static_cast<unsigned char>(value.front()))) {
        case 'N':
            s.file_type = FileType::png;
            break;
        case 'P':
            s.file_type = FileType::ppm;
            break;
        case 'C':
            s.file_type = FileType::tga;
            break;
        case 'T':
            s.file_type = FileType::tga_uncompressed;
            break;
        case 'J':
            s.file_type = FileType::jpeg;
            break;
        case 'B':
            s.file_type = FileType::bmp;
            break;
        case 'E':
            s.file_type = FileType::exr;
            break;
        case 'H':
            s.file_type = FileType::hdr;
            break;
        default:
            throw UsageError(fmt::format("Unrecognized output file format {}.", value));
    }
    std::string_view rest = value.substr(1);
    if (!rest.empty() && std::tolower(static_cast<unsigned char>(rest.front())) == 'g') {
        s.grayscale = true;
        rest.remove_prefix(1);
    }
    if (!rest.empty()) s.bits_per_color = std::clamp(to_integer("Bits_Per_Color", rest), 5, 16);
}

void declare(Settings& s, std::string_view value) {
    const size_t equals = value.find('=');
    if (equals == std::string_view::npos || equals == 0) throw UsageError(fmt::format("Declare={}", value));
    const std::string name(value.substr(0, equals));
    std::string_view text = value.substr(equals + 1);
    if (text.size() >= 2 && text.front() == '"' && text.back() == '"') {
        s.declares.emplace_back(name, std::string(text.substr(1, text.size() - 2)));
        return;
    }
    // As C's atof does: what is no number counts as 0.
    s.declares.emplace_back(name, std::strtod(std::string(text).c_str(), nullptr));
}

using Setter = std::function<void(Settings&, std::string_view name, std::string_view value)>;

Setter number_of(double Settings::*field) {
    return [field](Settings& s, std::string_view n, std::string_view v) { s.*field = to_number(n, v); };
}
Setter integer_of(int Settings::*field) {
    return [field](Settings& s, std::string_view n, std::string_view v) { s.*field = to_integer(n, v); };
}
Setter frame_of(std::optional<int> Settings::*field) {
    return [field](Settings& s, std::string_view n, std::string_view v) { s.*field = to_integer(n, v); };
}
Setter clamped_of(int Settings::*field, int lo, int hi) {
    return [=](Settings& s, std::string_view n, std::string_view v) {
        s.*field = std::clamp(to_integer(n, v), lo, hi);
    };
}
Setter switch_of(bool Settings::*field) {
    return [field](Settings& s, std::string_view n, std::string_view v) { s.*field = to_switch(n, v); };
}
Setter side_of(RegionSide Settings::*field) {
    return [field](Settings& s, std::string_view n, std::string_view v) { s.*field = to_number(n, v); };
}
Setter text_of(std::string Settings::*field) {
    return [field](Settings& s, std::string_view, std::string_view v) { s.*field = v; };
}
Setter command_of(ShellMoment moment) {
    return [moment](Settings& s, std::string_view, std::string_view v) {
        s.commands[static_cast<size_t>(moment)].line = v;
    };
}
Setter action_of(ShellMoment moment) {
    return [moment](Settings& s, std::string_view, std::string_view v) {
        s.commands[static_cast<size_t>(moment)].action = v;
    };
}
/// A name, or `on` for the reference's own.
Setter message_file_of(MessageStream stream, std::string_view usual) {
    return [=](Settings& s, std::string_view, std::string_view v) {
        s.message_files[static_cast<size_t>(stream)] = is_one_of(off_words, v)  ? ""
                                                       : is_one_of(on_words, v) ? usual
                                                                                : v;
    };
}
/// Something that would change the result and does not work yet.
Setter not_yet(std::string_view what) {
    return [what](Settings& s, std::string_view n, std::string_view v) {
        if (v.empty() || is_one_of(off_words, v)) return;
        s.without_effect.push_back(fmt::format("{}={}: {}", n, v, what));
    };
}

struct Option {
    std::string_view name;  ///< lower case
    Setter set;
};

std::vector<Option> make_options() {
    return {
        {"input_file_name", text_of(&Settings::input_file)},
        {"include_header",
         [](Settings& s, std::string_view, std::string_view v) {
             s.include_header = v.empty() ? std::nullopt : std::optional<std::string>(v);
         }},
        {"library_path",
         [](Settings& s, std::string_view, std::string_view v) { s.library_paths.emplace_back(v); }},
        {"declare", [](Settings& s, std::string_view, std::string_view v) { declare(s, v); }},
        {"version", [](Settings& s, std::string_view n, std::string_view v) { s.version = to_number(n, v); }},
        {"width", integer_of(&Settings::width)},
        {"height", integer_of(&Settings::height)},
        {"start_column", side_of(&Settings::start_column)},
        {"end_column", side_of(&Settings::end_column)},
        {"start_row", side_of(&Settings::start_row)},
        {"end_row", side_of(&Settings::end_row)},
        {"quality", clamped_of(&Settings::quality, 0, 9)},
        {"antialias", switch_of(&Settings::antialias)},
        {"antialias_threshold",
         [](Settings& s, std::string_view n, std::string_view v) {
             s.antialias_options.threshold = std::clamp(to_number(n, v), 0.0, 1.0);
         }},
        {"antialias_depth",
         [](Settings& s, std::string_view n, std::string_view v) {
             s.antialias_options.depth = std::clamp(to_integer(n, v), 1, 9);
         }},
        {"sampling_method",
         [](Settings& s, std::string_view n, std::string_view v) {
             s.antialias_options.method = std::clamp(to_integer(n, v), 0, 3);
         }},
        {"antialias_confidence",
         [](Settings& s, std::string_view n, std::string_view v) {
             s.antialias_options.confidence = to_number(n, v);
             if (!(s.antialias_options.confidence > 0.0 && s.antialias_options.confidence < 1.0))
                 bad_value(n, v, "a number between 0 and 1");
         }},
        {"antialias_gamma",
         [](Settings& s, std::string_view n, std::string_view v) {
             s.antialias_options.gamma = to_number(n, v);
             if (!(s.antialias_options.gamma > 0.0)) bad_value(n, v, "a positive number");
         }},
        {"jitter", switch_of(&Settings::jitter)},
        {"jitter_amount",
         [](Settings& s, std::string_view n, std::string_view v) {
             s.jitter_amount = std::clamp(to_number(n, v), 0.0, 1.0);
         }},
        {"render_block_size", [](Settings& s, std::string_view n,
                                 std::string_view v) { s.block_size = std::max(4, to_integer(n, v)); }},
        {"work_threads", [](Settings& s, std::string_view n,
                            std::string_view v) { s.threads = std::clamp(to_integer(n, v), 0, 512); }},
        {"output_to_file", switch_of(&Settings::output_to_file)},
        {"output_file_name", text_of(&Settings::output_file)},
        {"output_file_type", [](Settings& s, std::string_view, std::string_view v) { set_file_type(s, v); }},
        {"bits_per_color", clamped_of(&Settings::bits_per_color, 5, 16)},
        {"bits_per_colour", clamped_of(&Settings::bits_per_color, 5, 16)},
        {"compression", clamped_of(&Settings::compression, 0, 255)},
        {"grayscale_output", switch_of(&Settings::grayscale)},
        {"greyscale_output", switch_of(&Settings::grayscale)},
        {"output_alpha", switch_of(&Settings::alpha)},
        {"file_gamma",
         [](Settings& s, std::string_view n, std::string_view v) {
             const auto gamma = parse_gamma(v);
             if (!gamma) bad_value(n, v, "a positive number or sRGB");
             s.file_gamma = *gamma;
         }},
        {"verbose", switch_of(&Settings::verbose)},
        {"debug_console", switch_of(&Settings::debug_console)},
        {"render_console", switch_of(&Settings::render_console)},
        {"statistic_console", switch_of(&Settings::statistic_console)},
        {"warning_console", switch_of(&Settings::warning_console)},
        {"all_console",
         [](Settings& s, std::string_view n, std::string_view v) {
             s.debug_console = s.render_console = s.statistic_console = s.warning_console = to_switch(n, v);
         }},
        {"clock",
         [](Settings& s, std::string_view n, std::string_view v) {
             s.clock = to_number(n, v);
             s.clock_given = true;
         }},
        {"initial_clock", number_of(&Settings::initial_clock)},
        {"final_clock", number_of(&Settings::final_clock)},
        {"initial_frame", frame_of(&Settings::initial_frame)},
        {"final_frame", frame_of(&Settings::final_frame)},
        {"subset_start_frame", number_of(&Settings::subset_start_frame)},
        {"subset_end_frame", number_of(&Settings::subset_end_frame)},
        {"frame_step", integer_of(&Settings::frame_step)},
        {"cyclic_animation", switch_of(&Settings::cyclic_animation)},
        {"include_ini", [](Settings& s, std::string_view, std::string_view v) { apply_word(s, v); }},
        {"dither", switch_of(&Settings::dither)},
        {"dither_method",
         [](Settings& s, std::string_view n, std::string_view v) {
             const auto method = dither_method(v);
             if (!method) bad_value(n, v, "B2, B3, B4, D1, D2 or FS");
             s.dither_method = *method;
         }},
        {"continue_trace", switch_of(&Settings::continue_trace)},
        {"preview_file", not_yet("a live preview is not written yet")},
        {"clockless_animation", not_yet("clockless animation is not supported yet")},
        {"create_ini", text_of(&Settings::create_ini)},
        {"radiosity_file_name", text_of(&Settings::radiosity_file)},
        {"radiosity_from_file", switch_of(&Settings::radiosity_from_file)},
        {"radiosity_to_file", switch_of(&Settings::radiosity_to_file)},
        {"pre_scene_command", command_of(ShellMoment::pre_scene)},
        {"pre_frame_command", command_of(ShellMoment::pre_frame)},
        {"post_frame_command", command_of(ShellMoment::post_frame)},
        {"post_scene_command", command_of(ShellMoment::post_scene)},
        {"user_abort_command", command_of(ShellMoment::user_abort)},
        {"fatal_error_command", command_of(ShellMoment::fatal_error)},
        {"pre_scene_return", action_of(ShellMoment::pre_scene)},
        {"pre_frame_return", action_of(ShellMoment::pre_frame)},
        {"post_frame_return", action_of(ShellMoment::post_frame)},
        {"post_scene_return", action_of(ShellMoment::post_scene)},
        {"user_abort_return", action_of(ShellMoment::user_abort)},
        {"fatal_error_return", action_of(ShellMoment::fatal_error)},
        {"all_file", message_file_of(MessageStream::all, "alltext.out")},
        {"debug_file", message_file_of(MessageStream::debug, "debug.out")},
        {"fatal_file", message_file_of(MessageStream::fatal, "fatal.out")},
        {"render_file", message_file_of(MessageStream::render, "render.out")},
        {"statistic_file", message_file_of(MessageStream::statistics, "stats.out")},
        {"warning_file", message_file_of(MessageStream::warning, "warning.out")},
        {"append_file", switch_of(&Settings::append_files)},
        {"create_histogram", not_yet("histograms are not made")},
        {"histogram_name", not_yet("histograms are not made")},
        {"real_time_raytracing", not_yet("only whole pictures are rendered, one after the other")},
        {"fatal_console",
         [](Settings& s, std::string_view n, std::string_view v) {
             if (!to_switch(n, v))
                 s.without_effect.push_back(fmt::format("{}={}: errors are always shown", n, v));
         }},
        {"remove_bounds",
         [](Settings& s, std::string_view n, std::string_view v) {
             if (to_switch(n, v)) return;
             s.without_effect.push_back(
                 fmt::format("{}={}: bounds that the picture does not need are always left out", n, v));
         }},
    };
}

/// The same, but what stands behind the name must be a number.
constexpr std::string_view silent_numbers[] = {
    "bounding_method",    "bounding_threshold",      "bsp_maxdepth",       "bsp_isectcost",
    "bsp_baseaccesscost", "bsp_childaccesscost",     "bsp_misschance",     "render_block_step",
    "render_pattern",     "max_image_buffer_memory", "preview_start_size", "preview_end_size",
    "warning_level",      "test_abort_count",        "buffer_size"};

/// Names that callers send and that change nothing here: preview, bounding and console options of the
/// reference.
constexpr std::string_view silent_options[] = {"display",
                                               "display_gamma",
                                               "video_mode",
                                               "palette",
                                               "pause_when_done",
                                               "field_render",
                                               "odd_field",
                                               "bounding",
                                               "light_buffer",
                                               "vista_buffer",
                                               "draw_vistas",
                                               "split_unions",
                                               "high_reproducibility",
                                               "radiosity_vain_pretrace",
                                               "test_abort",
                                               "buffer_output",
                                               "histogram_type",
                                               "histogram_grid_size"};

}  // namespace

void set_option(Settings& settings, std::string_view name, std::string_view value) {
    static const std::vector<Option> options = make_options();
    const std::string key = lower(name);
    if (key != "include_ini") settings.given.emplace_back(key, value);
    for (const Option& option : options) {
        if (option.name == key) {
            option.set(settings, name, value);
            return;
        }
    }
    if (std::ranges::find(silent_numbers, key) != std::end(silent_numbers)) {
        to_number(name, value);
        return;
    }
    if (std::ranges::find(silent_options, key) != std::end(silent_options)) return;
    throw UsageError(fmt::format("unknown option '{}'", name));
}

}  // namespace rb
