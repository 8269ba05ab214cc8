#pragma once
#include "app/settings.h"

#include <string>
#include <vector>

namespace rb {

enum class Command { render, check, diff, help, version };

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

struct CommandLine {
    Command command = Command::render;
    Settings settings;
    DiffSettings diff;
    std::string text;  ///< what help or version print
};

/// Both faces at once: words as POV-Ray takes them, and long options. Reads the initial INI file first.
/// Throws UsageError.
CommandLine parse_command_line(const std::vector<std::string>& arguments);

}  // namespace rb
