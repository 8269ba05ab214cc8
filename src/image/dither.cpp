#include "image/dither.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <string>
#include <utility>

namespace rb {

namespace {

/// Ranks of a square of pixels, row by row: with `n` of them one of rank r is rounded up from 1 - r/n on.
struct Bayer {
    size_t side;
    std::array<float, 16> ranks;
};
constexpr Bayer bayer2{2, {1, 4, 3, 2}};
constexpr Bayer bayer3{3, {3, 6, 2, 7, 1, 8, 4, 9, 5}};
constexpr Bayer bayer4{4, {1, 13, 4, 16, 9, 5, 12, 8, 3, 15, 2, 14, 11, 7, 10, 6}};

const Bayer* bayer_of(DitherMethod method) {
    switch (method) {
        case DitherMethod::bayer2:
            return &bayer2;
        case DitherMethod::bayer3:
            return &bayer3;
        case DitherMethod::bayer4:
            return &bayer4;
        default:
            return nullptr;
    }
}

/// Where a pixel's error goes: the next pixel, and before, below and behind it in the next row.
struct Shares {
    float right = 0, below_left = 0, below = 0, below_right = 0;
};

Shares shares_of(DitherMethod method) {
    if (method == DitherMethod::line) return {.right = 1.0f};
    if (method == DitherMethod::plane) return {.right = 0.5f, .below = 0.25f, .below_right = 0.25f};
    return {7.0f / 16.0f, 3.0f / 16.0f, 5.0f / 16.0f, 1.0f / 16.0f};
}

/// Not a number becomes 0.
float clamped(float value, float most) { return value > 0.0f ? std::min(value, most) : 0.0f; }

}  // namespace

std::optional<DitherMethod> dither_method(std::string_view name) {
    static constexpr std::array<std::pair<std::string_view, DitherMethod>, 6> methods{
        {{"B2", DitherMethod::bayer2},
         {"B3", DitherMethod::bayer3},
         {"B4", DitherMethod::bayer4},
         {"D1", DitherMethod::line},
         {"D2", DitherMethod::plane},
         {"FS", DitherMethod::floyd_steinberg}}};
    std::string upper(name);
    std::ranges::transform(upper, upper.begin(),
                           [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    for (const auto& [known, method] : methods) {
        if (known == upper) return method;
    }
    return std::nullopt;
}

Dither::Dither(const Dithering& dithering, int width, int channels)
    : method_(dithering.method),
      curve_(dithering.curve),
      channels_(static_cast<size_t>(channels)),
      errors_((static_cast<size_t>(width) + 2) * channels_),
      next_(errors_.size()) {}

void Dither::round(std::span<float> values, float most) {
    if (bayer_of(method_)) {
        round_to_thresholds(values, most);
    } else {
        diffuse(values, most);
    }
    ++y_;
}

void Dither::round_to_thresholds(std::span<float> values, float most) const {
    const Bayer& bayer = *bayer_of(method_);
    const auto count = static_cast<float>(bayer.side * bayer.side);
    const float* ranks = &bayer.ranks[y_ % bayer.side * bayer.side];
    for (size_t i = 0; i < values.size(); ++i) {
        const float threshold = ranks[i / channels_ % bayer.side] / count;
        values[i] = clamped(std::floor(encode(i, values[i]) * most + threshold), most);
    }
}

void Dither::diffuse(std::span<float> values, float most) {
    const Shares shares = shares_of(method_);
    std::ranges::fill(next_, 0.0f);
    for (size_t i = 0; i < values.size(); ++i) {
        const size_t at = i + channels_;
        const float wanted = clamped(values[i] + errors_[at], 1.0f);
        values[i] = std::floor(encode(i, wanted) * most + 0.5f);
        const float error = wanted - decode(i, values[i] / most);
        errors_[at + channels_] += error * shares.right;
        next_[at - channels_] += error * shares.below_left;
        next_[at] += error * shares.below;
        next_[at + channels_] += error * shares.below_right;
    }
    // Along a line the error goes on at the start of the next one.
    if (method_ == DitherMethod::line) {
        const auto count = static_cast<ptrdiff_t>(channels_);
        std::copy_n(errors_.end() - count, channels_, next_.begin() + count);
    }
    std::swap(errors_, next_);
}

}  // namespace rb
