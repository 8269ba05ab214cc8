#pragma once
#include "app/animation.h"
#include "app/console.h"

namespace rb {

/// What happens to the run after a command, by its `..._Return` letter (language spec 23.8).
enum class AfterCommand { go_on, skip, skip_all, quit, abort, fail };

/// The shell-out commands of the settings. They run only with --allow-commands; otherwise the constructor
/// says that they do not.
class ShellCommands {
public:
    ShellCommands(const Settings& settings, Console& console);

    /// Runs the command of this moment, if there is one, with the frame's values in its `%` places.
    AfterCommand run(ShellMoment moment, const AnimationFrame& frame) const;

private:
    std::string expanded(std::string_view command, const AnimationFrame& frame) const;

    const Settings& settings_;
};

}  // namespace rb
