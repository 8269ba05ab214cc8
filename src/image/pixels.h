#pragma once
#include <cstddef>
#include <vector>

namespace rb {

/// A picture as floats, interleaved, rows top to bottom. 1, 3 or 4 channels; values are what the file holds
/// (encoded, 0..1) unless a function says linear.
struct Pixels {
    int width = 0;
    int height = 0;
    int channels = 3;
    std::vector<float> values;

    Pixels() = default;
    Pixels(int w, int h, int c)
        : width(w),
          height(h),
          channels(c),
          values(static_cast<size_t>(w) * static_cast<size_t>(h) * static_cast<size_t>(c)) {}

    float* at(int x, int y) { return values.data() + index(x, y); }
    const float* at(int x, int y) const { return values.data() + index(x, y); }

private:
    size_t index(int x, int y) const {
        return (static_cast<size_t>(y) * static_cast<size_t>(width) + static_cast<size_t>(x)) *
               static_cast<size_t>(channels);
    }
};

}  // namespace rb
