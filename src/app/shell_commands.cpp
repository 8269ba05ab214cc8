#include "app/shell_commands.h"

#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <sys/wait.h>

#include <fmt/format.h>

namespace rb {

namespace {

AfterCommand after_letter(char letter) {
    switch (std::toupper(static_cast<unsigned char>(letter))) {
        case 'S':
            return AfterCommand::skip;
        case 'A':
            return AfterCommand::skip_all;
        case 'Q':
            return AfterCommand::quit;
        case 'U':
            return AfterCommand::abort;
        case 'F':
            return AfterCommand::fail;
        default:
            return AfterCommand::go_on;
    }
}

}  // namespace

ShellCommands::ShellCommands(const Settings& settings, Console& console) : settings_(settings) {
    if (settings.allow_commands) return;
    for (const ShellCommand& command : settings.commands) {
        if (command.line.empty()) continue;
        console.line(fmt::format("warning: '{}' is not run: commands need --allow-commands", command.line));
    }
}

std::string ShellCommands::expanded(std::string_view command, const AnimationFrame& frame) const {
    const std::string number = frame.digits > 0 ? fmt::format("{:0{}}", frame.number, frame.digits) : "";
    std::string out;
    for (size_t i = 0; i < command.size(); ++i) {
        if (command[i] != '%' || i + 1 == command.size()) {
            out += command[i];
            continue;
        }
        switch (command[++i]) {
            case 'o':
                out += output_path(settings_, number);
                break;
            case 's':
                out += std::filesystem::path(settings_.input_file).stem().string();
                break;
            case 'n':
                out += fmt::format("{}", frame.number);
                break;
            case 'k':
                out += fmt::format("{:#.6f}", frame.clock);
                break;
            case 'w':
                out += fmt::format("{}", settings_.width);
                break;
            case 'h':
                out += fmt::format("{}", settings_.height);
                break;
            default:
                out += command[i];
        }
    }
    return out;
}

AfterCommand ShellCommands::run(ShellMoment moment, const AnimationFrame& frame) const {
    const ShellCommand& command = settings_.commands[static_cast<size_t>(moment)];
    if (!settings_.allow_commands || command.line.empty()) return AfterCommand::go_on;
    const int status = std::system(expanded(command.line, frame).c_str());
    const bool failed = !WIFEXITED(status) || WEXITSTATUS(status) != 0;
    std::string_view action = command.action;
    const bool negated = action.starts_with('!') || action.starts_with('-');
    if (negated) action.remove_prefix(1);
    if (action.empty() || failed == negated) return AfterCommand::go_on;
    return after_letter(action.front());
}

}  // namespace rb
