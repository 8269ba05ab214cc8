#pragma once
#include "scene/curve.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace rb {

/// Turns working-space values into the numbers of the output file.
class OutputEncoding {
public:
    /// `assumed` empty: the scene has no gamma handling, numbers pass unchanged (language spec 6).
    OutputEncoding(const std::optional<GammaCurve>& assumed, const GammaCurve& file);
    float encode(float working) const { return passes_ ? working : file_.encode(working_.decode(working)); }
    /// For formats that hold linear light (OpenEXR, HDR).
    float linear(float working) const { return passes_ ? working : working_.decode(working); }
    const Curve& file_curve() const { return file_; }
    bool passes_unchanged() const { return passes_; }

private:
    Curve working_;
    Curve file_;
    bool passes_ = false;
};

/// 8-bit codes without a power function per value: exactly floor(encode(v) * 255 + 0.5), found among the 255
/// values at which the code changes. Its slow twin is OutputEncoding::encode.
class CodeTable {
public:
    explicit CodeTable(const OutputEncoding& encoding);
    int code(float working) const;

private:
    std::array<float, 257> change_;  ///< smallest value with at least code k
    std::vector<uint8_t> first_;     ///< a code to start from, by the upper half of the value's bits
};

/// "2.2" or "sRGB" (any case) as an option or the scene writes it; empty if neither.
std::optional<GammaCurve> parse_gamma(std::string_view text);

}  // namespace rb
