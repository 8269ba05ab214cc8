#pragma once
#include "app/command_line.h"
#include "app/measured_run.h"
#include "image/compare.h"

#include <optional>
#include <string>
#include <vector>

namespace rb {

/// What one program made of a scene.
struct ComparedSide {
    MeasuredRun run;
    std::optional<double> parse;   ///< CPU seconds, as the program tells
    std::optional<double> render;  ///< wall seconds of tracing, as the program tells
    std::string picture;           ///< its file; empty if there is none
    std::string error;             ///< what it said when it failed
};

struct ComparedScene {
    std::string scene;
    ComparedSide povray;
    ComparedSide ours;
    std::optional<ImageDifference> difference;  ///< where both made a picture
    std::string note;                           ///< why there is none
};

/// Renders scenes with POV-Ray and with this program, each in a process of its own, with the same switches.
/// What a run gave is kept in a folder under a name that stands for program, scene and switches (not for the
/// files that the scene includes), so that the next comparison need not render it again.
class SceneComparison {
public:
    /// `folder`: where pictures and figures stay; it must exist. Throws IoError if a program is missing.
    SceneComparison(const CompareSettings& settings, const std::string& folder);

    ComparedScene compare(const SceneToCompare& scene) const;

private:
    struct Program {
        std::string path;
        std::string identity;  ///< changes when the program does
        bool is_ours = false;
    };
    ComparedSide side(const Program& program, const SceneToCompare& scene) const;
    std::vector<std::string> words_of(const SceneToCompare& scene) const;

    const CompareSettings& settings_;
    std::string folder_;
    Program povray_;
    Program ours_;
};

}  // namespace rb
