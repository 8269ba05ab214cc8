#pragma once
#include "compile/world.h"
#include "image/file.h"
#include "render/render.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace rb {

/// A wrong word on the command line or in an INI file: exit code 1, nothing is rendered.
class UsageError : public std::exception {
public:
    explicit UsageError(std::string message) : message_(std::move(message)) {}
    const char* what() const noexcept override { return message_.c_str(); }

private:
    std::string message_;
};

/// A command that an INI file asks to be run, and the letter that says what a failure of it does.
struct ShellCommand {
    std::string line;
    std::string action;
};
enum class ShellMoment { pre_scene, pre_frame, post_frame, post_scene, user_abort, fatal_error };

/// The streams of messages; `all` stands for the five others together.
enum class MessageStream { all, debug, fatal, render, statistics, warning };

enum class DumpStage { none, tokens, blocks, scene };

/// One side of the rendered region as it was written: a pixel number (1-based) or a fraction (language
/// spec 23.6).
using RegionSide = std::optional<double>;

/// Everything that the command line and INI files decide. Names follow the INI keys.
struct Settings {
    std::string input_file;
    std::optional<std::string> include_header;
    std::vector<std::string> library_paths;
    std::vector<std::pair<std::string, std::variant<double, std::string>>> declares;
    std::optional<double> version;

    int width = 160;
    int height = 120;
    RegionSide start_column, end_column, start_row, end_row;
    int quality = 9;
    bool antialias = false;
    AntialiasOptions antialias_options{.method = 1};  ///< Sampling_Method counts only while antialias is on
    bool jitter = true;
    double jitter_amount = 1.0;
    int block_size = 32;
    int threads = 0;

    bool output_to_file = true;
    bool continue_trace = false;
    std::string output_file;
    FileType file_type = FileType::png;
    int bits_per_color = 8;
    bool grayscale = false;
    bool alpha = false;
    int compression = 0;
    bool dither = false;
    DitherMethod dither_method = DitherMethod::floyd_steinberg;  ///< while dither is on
    GammaCurve file_gamma = SrgbCurve{};

    bool verbose = true;
    // Streams that are shown; errors always are.
    bool debug_console = true;
    bool render_console = true;
    bool statistic_console = true;
    bool warning_console = true;
    std::array<std::string, 6> message_files;  ///< by MessageStream: name without folder; empty: none
    bool append_files = false;
    double clock = 0;
    bool clock_given = false;
    double initial_clock = 0;
    double final_clock = 1;
    std::optional<int> initial_frame;
    std::optional<int> final_frame;
    double subset_start_frame = 0;
    double subset_end_frame = 0;
    int frame_step = 1;
    bool cyclic_animation = false;

    // The long-option face.
    GeometryMode geometry = GeometryMode::automatic;
    double tessellation_error = 0.05;
    uint64_t seed = 0;
    AreaLightMode area_lights = AreaLightMode::as_written;
    GiMode gi = GiMode::automatic;
    std::string radiosity_file = "object.rca";
    bool radiosity_from_file = false;
    bool radiosity_to_file = false;
    double gi_error = 0;  ///< in shares of white; 0: as radiosity{} says
    bool skip_unneeded = true;
    bool explain = false;
    bool preview = false;
    bool view_surfels = false;
    bool brute_force = false;
    InstanceMode instances = InstanceMode::automatic;
    /// Tokens that a scene may take before it counts as a loop without end; minutes of parsing.
    uint64_t max_parse_steps = 10'000'000'000;
    bool strict = false;                   ///< no leniency with files and trifles of the language
    std::vector<std::string> allow_write;  ///< more folders that a scene may write to
    bool allow_commands = false;           ///< run the shell-out commands of INI files
    std::array<ShellCommand, 6> commands;  ///< by ShellMoment
    bool list_files = false;               ///< `check --deps`
    DumpStage dump = DumpStage::none;
    std::optional<std::string> stats_file;  ///< "-" writes to standard error

    std::vector<std::string> ini_files;  ///< as they were read

    std::string create_ini;
    /// Every option in the order given, by lower case name.
    std::vector<std::pair<std::string, std::string>> given;

    /// Options that were understood and have no effect, with the reason, for one message.
    std::vector<std::string> without_effect;
};

/// The pixels to render: `width` x `height` cut by the region sides. Throws UsageError where the reference
/// does.
PixelBlock region_of(const Settings& settings);

/// Bits of one channel in the file: grey PNG has 16 whatever was asked for.
int output_bits(const Settings& settings);

/// Where the picture goes: +O rules of language spec 23.7; "-" is standard output. `number` stands before the
/// extension.
std::string output_path(const Settings& settings, const std::string& number);

}  // namespace rb
