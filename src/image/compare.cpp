#include "image/compare.h"

#include "base/diagnostics.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

namespace rb {

namespace {

constexpr double off_limit = 8.0;

double byte_value(float v) { return 255.0 * static_cast<double>(std::clamp(v, 0.0f, 1.0f)); }

double largest_difference(const float* a, const float* b) {
    double largest = 0;
    for (int c = 0; c < 3; ++c) largest = std::max(largest, std::abs(byte_value(a[c]) - byte_value(b[c])));
    return largest;
}

/// Sums over every 7x7 window by summed-area tables.
class WindowSums {
public:
    WindowSums(int width, int height)
        : stride_(static_cast<size_t>(width) + 1), table_(stride_ * (static_cast<size_t>(height) + 1)) {}

    void set_row(int y, const std::vector<double>& row) {
        double running = 0;
        const size_t above = static_cast<size_t>(y) * stride_;
        for (size_t x = 0; x < row.size(); ++x) {
            running += row[x];
            table_[above + stride_ + x + 1] = table_[above + x + 1] + running;
        }
    }
    double sum(int x, int y, int size) const {
        const auto at = [&](int px, int py) {
            return table_[static_cast<size_t>(py) * stride_ + static_cast<size_t>(px)];
        };
        return at(x + size, y + size) - at(x, y + size) - at(x + size, y) + at(x, y);
    }

private:
    size_t stride_;
    std::vector<double> table_;
};

double channel_ssim(const Pixels& a, const Pixels& b, int channel) {
    constexpr int window = 7;
    if (a.width < window || a.height < window) return 1.0;
    enum { sum_a, sum_b, sum_aa, sum_bb, sum_ab };
    std::vector<WindowSums> sums(5, WindowSums(a.width, a.height));
    std::array<std::vector<double>, 5> rows;
    for (auto& row : rows) row.resize(static_cast<size_t>(a.width));
    for (int y = 0; y < a.height; ++y) {
        for (int x = 0; x < a.width; ++x) {
            const double va = byte_value(a.at(x, y)[channel]);
            const double vb = byte_value(b.at(x, y)[channel]);
            const auto i = static_cast<size_t>(x);
            rows[sum_a][i] = va;
            rows[sum_b][i] = vb;
            rows[sum_aa][i] = va * va;
            rows[sum_bb][i] = vb * vb;
            rows[sum_ab][i] = va * vb;
        }
        for (size_t k = 0; k < 5; ++k) sums[k].set_row(y, rows[k]);
    }
    constexpr double n = window * window;
    constexpr double c1 = 0.01 * 255 * 0.01 * 255;
    constexpr double c2 = 0.03 * 255 * 0.03 * 255;
    double total = 0;
    for (int y = 0; y + window <= a.height; ++y) {
        for (int x = 0; x + window <= a.width; ++x) {
            const double ma = sums[sum_a].sum(x, y, window) / n;
            const double mb = sums[sum_b].sum(x, y, window) / n;
            const double unbiased = n / (n - 1);
            const double vaa = unbiased * (sums[sum_aa].sum(x, y, window) / n - ma * ma);
            const double vbb = unbiased * (sums[sum_bb].sum(x, y, window) / n - mb * mb);
            const double vab = unbiased * (sums[sum_ab].sum(x, y, window) / n - ma * mb);
            total += (2 * ma * mb + c1) * (2 * vab + c2) / ((ma * ma + mb * mb + c1) * (vaa + vbb + c2));
        }
    }
    return total / (static_cast<double>(a.width - window + 1) * static_cast<double>(a.height - window + 1));
}

void check_sizes(const Pixels& a, const Pixels& b) {
    if (a.width != b.width || a.height != b.height) {
        throw IoError(fmt::format("the pictures differ in size: {}x{} and {}x{}", a.width, a.height, b.width,
                                  b.height));
    }
}

}  // namespace

ImageDifference compare(const Pixels& a, const Pixels& b) {
    check_sizes(a, b);
    ImageDifference out;
    double squares = 0;
    size_t off = 0;
    for (int y = 0; y < a.height; ++y) {
        for (int x = 0; x < a.width; ++x) {
            const double largest = largest_difference(a.at(x, y), b.at(x, y));
            for (int c = 0; c < 3; ++c) {
                const double d = byte_value(a.at(x, y)[c]) - byte_value(b.at(x, y)[c]);
                squares += d * d;
            }
            // Half a code value of slack: 8-bit codes are compared as integers.
            if (largest > off_limit + 0.5 / 255) ++off;
            out.max_error = std::max(out.max_error, largest);
        }
    }
    const double pixels = static_cast<double>(a.width) * static_cast<double>(a.height);
    out.rmse = std::sqrt(squares / (3.0 * pixels));
    out.share_off = static_cast<double>(off) / pixels;
    out.ssim = (channel_ssim(a, b, 0) + channel_ssim(a, b, 1) + channel_ssim(a, b, 2)) / 3.0;
    return out;
}

Pixels heat_map(const Pixels& a, const Pixels& b) {
    check_sizes(a, b);
    struct Stop {
        double at;
        std::array<float, 3> color;
    };
    constexpr std::array<Stop, 5> stops{
        {{0, {0, 0, 0}}, {4, {0, 0, 1}}, {8, {0, 0.8f, 0}}, {24, {1, 1, 0}}, {64, {1, 0, 0}}}};
    Pixels out(a.width, a.height, 3);
    for (int y = 0; y < a.height; ++y) {
        for (int x = 0; x < a.width; ++x) {
            const double d = std::min(largest_difference(a.at(x, y), b.at(x, y)), stops.back().at);
            size_t i = 1;
            while (i + 1 < stops.size() && d > stops[i].at) ++i;
            const auto t = static_cast<float>((d - stops[i - 1].at) / (stops[i].at - stops[i - 1].at));
            for (size_t c = 0; c < 3; ++c) {
                out.at(x, y)[c] = (1 - t) * stops[i - 1].color[c] + t * stops[i].color[c];
            }
        }
    }
    return out;
}

}  // namespace rb
