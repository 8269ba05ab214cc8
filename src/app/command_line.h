#pragma once
#include "app/settings.h"
#include "image/compare.h"

#include <string>
#include <vector>

namespace rb {

enum class Command { render, check, diff, compare, help, version };

/// What two pictures may differ by; one that is passed makes the exit code 1.
struct DifferenceLimits {
    std::optional<double> max_rmse;
    std::optional<double> max_off;
    std::optional<double> min_ssim;

    bool hold(const ImageDifference& difference) const;
};

/// `renderboy diff a.png b.png`.
struct DiffSettings {
    std::string first;
    std::string second;
    std::optional<std::string> heat_map;
    DifferenceLimits limits;
    bool json = false;
};

struct SceneToCompare {
    std::string path;
    std::vector<std::string> words;  ///< its own switches
};

/// `renderboy compare a.pov b.pov`: scenes that both programs render.
struct CompareSettings {
    std::vector<SceneToCompare> scenes;
    std::vector<std::string> words;  ///< POV-Ray's switches, for both programs and all scenes
    std::string povray = "povray";
    double timeout = 600;  ///< seconds for one run
    DifferenceLimits limits{.max_off = 0.01};
    std::optional<std::string> html;
    std::optional<std::string> table;
    std::optional<std::string> cache;  ///< folder for pictures and figures of runs
};

struct CommandLine {
    Command command = Command::render;
    Settings settings;
    DiffSettings diff;
    CompareSettings compare;
    std::string text;  ///< what help or version print
};

/// Both faces at once: words as POV-Ray takes them, and long options. Reads the initial INI file first.
/// Throws UsageError.
CommandLine parse_command_line(const std::vector<std::string>& arguments);

}  // namespace rb
