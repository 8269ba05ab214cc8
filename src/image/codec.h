#pragma once
#include "image/file.h"
#include "scene/image.h"

#include <algorithm>
#include <cstdint>

namespace rb {

/// Samples as the file stores them: 8 or 16 bit integers, or floats (OpenEXR, HDR).
struct Samples {
    int width = 0;
    int height = 0;
    int channels = 3;
    std::vector<uint8_t> bytes;
    std::vector<uint16_t> words;
    std::vector<float> floats;
};

/// File values to stored integers: floor(clamp(v) * (2^bits - 1) + 0.5), or dithered, and spread over the
/// stored range where that has more bits (textures spec 10.2; netpbm says in its header how far it goes). NaN
/// becomes 0.
class Quantiser {
public:
    Quantiser(const OutputFormat& format, int width, int channels);
    /// 16 stored bits instead of 8.
    bool is_wide() const { return wide_; }
    /// What full light becomes.
    int greatest() const { return spread(static_cast<int>(levels_)); }
    /// The next row, top to bottom. `to` has the type that is_wide() tells.
    template <typename T>
    void row(std::span<const float> from, std::span<T> to) {
        if (dither_) {
            dithered_.resize(from.size());
            std::ranges::copy(from, dithered_.begin());
            dither_->round(dithered_, levels_);
            for (size_t i = 0; i < from.size(); ++i) {
                to[i] = static_cast<T>(spread(static_cast<int>(dithered_[i])));
            }
            return;
        }
        for (size_t i = 0; i < from.size(); ++i) to[i] = static_cast<T>(level(from[i]));
    }

private:
    int level(float v) const {
        const float clamped = v > 0.0f ? std::min(v, 1.0f) : 0.0f;
        // Values are not negative, so that truncation is floor.
        return spread(static_cast<int>(clamped * levels_ + 0.5f));
    }
    int spread(int code) const {
        return spread_ == 1.0f ? code : static_cast<int>(static_cast<float>(code) * spread_ + 0.5f);
    }

    bool wide_;
    float levels_;
    float spread_;
    std::optional<Dither> dither_;
    std::vector<float> dithered_;
};

/// All rows as the file stores them.
Samples samples_of(const PixelRows& rows, const OutputFormat& format);

/// PNG without OpenImageIO. The default format has its own writer because loading OpenImageIO (261 shared
/// libraries on Debian 12) costs 0.2 s of CPU time, more than most small pictures; see docs/architecture.md,
/// "Image files".
void write_png(const PixelRows& rows, const OutputFormat& format, const std::string& path);

/// PPM, or PGM for one channel, of any number of bits: OpenImageIO 2.4 writes no more than 8.
void write_netpbm(const PixelRows& rows, const OutputFormat& format, const std::string& path);

/// Every other format through OpenImageIO, which lives in a module of its own that is loaded at the first
/// call.
void write_with_oiio(const Samples& samples, const OutputFormat& format, const std::string& path);
Pixels read_with_oiio(const std::string& path);
/// TIFF (as 8 bits a channel, like the reference), OpenEXR, HDR as the file holds them.
Image read_samples_with_oiio(const std::string& path, ImageType type);

}  // namespace rb
