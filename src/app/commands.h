#pragma once
#include "app/command_line.h"

namespace rb {

/// Exit codes that callers rely on (language spec 24).
enum ExitCode { exit_done = 0, exit_error = 1, exit_stopped = 2 };

int run_render(const Settings& settings);
/// Reads the scene without rendering it and lists what does not work yet, or the files it is made of.
int run_check(const Settings& settings);
int run_diff(const DiffSettings& settings);
/// Renders scenes with POV-Ray, too, and tells how far the pictures lie apart and what they took.
int run_compare(const CompareSettings& settings);

/// The whole program, called as `program`; prints, and maps every failure to an exit code.
int run(const std::vector<std::string>& arguments, std::string_view program = "renderboy");

}  // namespace rb
