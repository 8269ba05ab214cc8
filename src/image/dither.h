#pragma once
#include "scene/curve.h"

#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace rb {

/// How a value between two levels of the file is rounded. POV-Ray's names: B2, B3, B4 (ordered), D1, D2, FS
/// (the error of a pixel goes to those that follow).
enum class DitherMethod { none, bayer2, bayer3, bayer4, line, plane, floyd_steinberg };

/// By its name in any case; empty if there is none.
std::optional<DitherMethod> dither_method(std::string_view name);

/// How a picture is dithered: its rows hold light, since that is what the errors are measured in.
struct Dithering {
    DitherMethod method = DitherMethod::none;
    Curve curve;  ///< makes file values of light
};

/// Rounds the rows of one picture, top to bottom.
class Dither {
public:
    Dither(const Dithering& dithering, int width, int channels);
    /// `values`: the next row as light, not clamped (the last of 2 or 4 channels is alpha); levels of the
    /// file afterwards, whole numbers 0..most. NaN becomes 0.
    void round(std::span<float> values, float most);

private:
    bool is_alpha(size_t i) const { return channels_ % 2 == 0 && i % channels_ == channels_ - 1; }
    float encode(size_t i, float light) const { return is_alpha(i) ? light : curve_.encode(light); }
    float decode(size_t i, float value) const { return is_alpha(i) ? value : curve_.decode(value); }
    void round_to_thresholds(std::span<float> values, float most) const;
    void diffuse(std::span<float> values, float most);

    DitherMethod method_;
    Curve curve_;
    size_t channels_;
    size_t y_ = 0;
    std::vector<float> errors_;  ///< that came to this row, a pixel more at either end
    std::vector<float> next_;    ///< to the next one
};

}  // namespace rb
