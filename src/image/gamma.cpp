#include "image/gamma.h"

#include <bit>
#include <charconv>
#include <cmath>
#include <limits>

namespace rb {

OutputEncoding::OutputEncoding(const std::optional<GammaCurve>& assumed, const GammaCurve& file)
    : file_(file) {
    if (!assumed) {
        passes_ = true;
        return;
    }
    working_ = Curve(*assumed);
    passes_ = working_.same_as(file_);
}

CodeTable::CodeTable(const OutputEncoding& encoding) {
    constexpr uint32_t infinity = 0x7f800000u;
    const auto code_of = [&](uint32_t bits) {
        const float encoded = encoding.encode(std::bit_cast<float>(bits));
        return encoded >= 1.0f ? 255 : static_cast<int>(encoded * 255.0f + 0.5f);
    };
    change_[0] = 0.0f;
    change_[256] = std::numeric_limits<float>::infinity();
    uint32_t least = 0;
    for (int k = 1; k < 256; ++k) {
        uint32_t greatest = infinity;
        while (least < greatest) {
            const uint32_t middle = least + (greatest - least) / 2;
            if (code_of(middle) >= k) {
                greatest = middle;
            } else {
                least = middle + 1;
            }
        }
        change_[static_cast<size_t>(k)] = std::bit_cast<float>(least);
    }
    first_.resize((infinity >> 16) + 1);
    size_t code = 0;
    for (uint32_t upper = 0; upper < first_.size(); ++upper) {
        const auto value = std::bit_cast<float>(upper << 16);
        while (code < 255 && value >= change_[code + 1]) ++code;
        first_[upper] = static_cast<uint8_t>(code);
    }
}

int CodeTable::code(float working) const {
    if (!(working > 0.0f)) return 0;
    size_t code = first_[std::bit_cast<uint32_t>(working) >> 16];
    while (code < 255 && working >= change_[code + 1]) ++code;
    return static_cast<int>(code);
}

std::optional<GammaCurve> parse_gamma(std::string_view text) {
    if (text.size() == 4 && (text[0] | 32) == 's' && (text[1] | 32) == 'r' && (text[2] | 32) == 'g' &&
        (text[3] | 32) == 'b') {
        return GammaCurve{SrgbCurve{}};
    }
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size() || !(value > 0.0)) return std::nullopt;
    return GammaCurve{value};
}

}  // namespace rb
