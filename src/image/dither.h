#pragma once
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

/// Rounds the rows of one picture, top to bottom.
class Dither {
public:
    Dither(DitherMethod method, int width, int channels);
    /// `values`: the next row in levels of the file, not clamped; whole numbers 0..most afterwards. NaN
    /// becomes 0.
    void round(std::span<float> values, float most);

private:
    void add_thresholds(std::span<float> values) const;
    void diffuse(std::span<float> values, float most);

    DitherMethod method_;
    size_t channels_;
    size_t y_ = 0;
    std::vector<float> errors_;  ///< that came to this row, a pixel more at either end
    std::vector<float> next_;    ///< to the next one
};

}  // namespace rb
