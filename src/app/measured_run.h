#pragma once
#include <cstdint>
#include <string>
#include <vector>

namespace rb {

/// How a program ended, and what it took.
struct MeasuredRun {
    int exit_code = 0;  ///< 128 and more: the signal that ended it
    bool timed_out = false;
    double wall = 0;  ///< seconds
    double cpu = 0;   ///< seconds, of all its threads, user and system
    uint64_t peak_memory_kib = 0;
};

/// Runs a program, looked for along PATH; what it prints goes to the file `log`. It is killed after
/// `timeout` seconds, and when a signal ends this process. Throws IoError if it cannot be started.
MeasuredRun run_measured(const std::vector<std::string>& command, const std::string& log, double timeout);

/// Where a program of this name would be started from: itself if it has a slash, else along PATH; empty if
/// nowhere.
std::string find_program(const std::string& name);

}  // namespace rb
