#include "app/animation.h"

#include <algorithm>
#include <string>

namespace rb {

namespace {

/// 0 and absent: `whole`; a number in (0, 1): that part of the frames; otherwise a frame number.
int subset_frame(double value, int first, int last, int whole) {
    if (value <= 0.0) return whole;
    if (value < 1.0) return std::max(first, static_cast<int>((last - first + 1) * value));
    return static_cast<int>(std::min(value, 2e9));
}

}  // namespace

std::vector<AnimationFrame> frames_of(const Settings& s) {
    const int given_first = s.initial_frame.value_or(0);
    const int given_last = s.final_frame.value_or(0);
    const bool still = given_first == given_last && (given_first == 0 || given_first == 1);
    if (still) {
        AnimationFrame frame;
        frame.clock = static_cast<double>(static_cast<float>(s.clock));
        return {frame};
    }
    const int first = std::max(s.initial_frame.value_or(1), 0);
    const int last = std::max(given_last, first) + (s.cyclic_animation ? 1 : 0);
    const double delta = (s.final_clock - s.initial_clock) / (last - first);
    const int start = subset_frame(s.subset_start_frame, first, last, first);
    const int end = subset_frame(s.subset_end_frame, first, last, s.cyclic_animation ? last - 1 : last);
    std::vector<AnimationFrame> frames;
    for (int n = start; n <= end; n += std::max(1, s.frame_step)) {
        const auto clock = static_cast<float>(delta * (n - first) + s.initial_clock);
        frames.push_back({n, static_cast<double>(clock), delta, first, last, s.initial_clock, s.final_clock,
                          static_cast<int>(std::to_string(last).size())});
    }
    return frames;
}

}  // namespace rb
