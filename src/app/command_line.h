#pragma once
#include "app/settings.h"

#include <string>
#include <vector>

namespace rb {

enum class Command { render, check, diff, compare, help, version };

/// `renderboy diff a.png b.png`: pictures and limits; a limit that is passed makes the exit code 1.
struct DiffSettings {
    std::string first;
    std::string second;
    std::optional<std::string> heat_map;
    std::optional<double> max_rmse;
    std::optional<double> max_off;
    std::optional<double> min_ssim;
    bool json = false;
};

struct SceneToCompare {
    std::string path;
    std::vector<std::string> words;  ///< its own switches
};

/// `renderboy compare a.pov b.pov`: scenes that both programs render, and limits as of `diff`.
struct CompareSettings {
    std::vector<SceneToCompare> scenes;
    std::vector<std::string> words;  ///< POV-Ray's switches, for both programs and all scenes
    std::string povray = "povray";
    double timeout = 600;  ///< seconds for one run
    double max_off = 0.01;
    std::optional<double> max_rmse;
    std::optional<double> min_ssim;
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
