#include "app/measured_run.h"

#include "base/diagnostics.h"

#include <array>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <spawn.h>
#include <sstream>
#include <sys/resource.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

#include <fmt/format.h>

namespace rb {

namespace {

double seconds(const timeval& t) {
    constexpr double micro = 1e-6;
    return static_cast<double>(t.tv_sec) + micro * static_cast<double>(t.tv_usec);
}

volatile std::sig_atomic_t signal_to_end = 0;

/// While it lives, what would end this process is only noted: its child has to end first.
class EndingNoted {
public:
    EndingNoted() {
        for (size_t i = 0; i < before_.size(); ++i) {
            before_[i] = std::signal(endings[i], [](int number) { signal_to_end = number; });
            // As under nohup.
            if (before_[i] == SIG_IGN) std::signal(endings[i], SIG_IGN);
        }
    }
    ~EndingNoted() {
        for (size_t i = 0; i < before_.size(); ++i) std::signal(endings[i], before_[i]);
        const int number = signal_to_end;
        signal_to_end = 0;
        if (number != 0) std::raise(number);
    }
    EndingNoted(const EndingNoted&) = delete;
    EndingNoted& operator=(const EndingNoted&) = delete;

private:
    static constexpr std::array endings{SIGINT, SIGTERM, SIGHUP};
    std::array<void (*)(int), endings.size()> before_{};
};

pid_t start(const std::vector<std::string>& command, const std::string& log) {
    std::vector<char*> arguments;
    arguments.reserve(command.size() + 1);
    for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    posix_spawn_file_actions_t files;
    posix_spawn_file_actions_init(&files);
    posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
    posix_spawn_file_actions_adddup2(&files, STDOUT_FILENO, STDERR_FILENO);
    pid_t child = 0;
    const int error = posix_spawnp(&child, arguments.front(), &files, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&files);
    if (error != 0)
        throw IoError(fmt::format("{} cannot be started: {}", command.front(), std::strerror(error)));
    return child;
}

}  // namespace

MeasuredRun run_measured(const std::vector<std::string>& command, const std::string& log, double timeout) {
    using Clock = std::chrono::steady_clock;
    const auto began = Clock::now();
    const auto wall = [&] { return std::chrono::duration<double>(Clock::now() - began).count(); };
    const EndingNoted ending;
    const pid_t child = start(command, log);
    MeasuredRun out;
    int status = 0;
    rusage used{};
    constexpr auto pause = std::chrono::milliseconds(2);
    while (wait4(child, &status, WNOHANG, &used) == 0) {
        if (!out.timed_out && (wall() > timeout || signal_to_end != 0)) {
            kill(child, SIGKILL);
            out.timed_out = true;
        }
        std::this_thread::sleep_for(pause);
    }
    constexpr int by_signal = 128;
    out.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : by_signal + WTERMSIG(status);
    out.wall = wall();
    out.cpu = seconds(used.ru_utime) + seconds(used.ru_stime);
    out.peak_memory_kib = static_cast<uint64_t>(used.ru_maxrss);
    return out;
}

std::string find_program(const std::string& name) {
    if (name.find('/') != std::string::npos) return access(name.c_str(), X_OK) == 0 ? name : "";
    const char* path = std::getenv("PATH");
    std::istringstream folders(path ? path : "");
    for (std::string folder; std::getline(folders, folder, ':');) {
        std::string candidate = (folder.empty() ? "." : folder) + "/" + name;
        if (access(candidate.c_str(), X_OK) == 0) return candidate;
    }
    return "";
}

}  // namespace rb
