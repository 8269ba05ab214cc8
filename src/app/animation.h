#pragma once
#include "app/settings.h"

#include <vector>

namespace rb {

/// One picture of an animation, or the only one of a still.
struct AnimationFrame {
    int number = 0;
    double clock = 0;
    double clock_delta = 0;
    int initial_frame = 0;
    int final_frame = 0;
    double initial_clock = 0;
    double final_clock = 0;
    int digits = 0;  ///< of the number in the file name; 0: a still picture, no number
};

/// The frames that the settings ask for, in order (language spec 23.5). A still unless the frame range says
/// otherwise.
std::vector<AnimationFrame> frames_of(const Settings& settings);

}  // namespace rb
