#pragma once
#include "scene/color.h"
#include "scene/image.h"

#include <algorithm>

namespace rb {

/// The pixels of a picture as colours (spec: textures 6.4). Decoded one by one through tables, so that a
/// picture takes no more memory than its file's samples.
class Texels {
public:
    /// How the numbers of files become the scene's.
    struct Decoding {
        /// False: they stay as they are unless `gamma` was written, and then become linear light.
        bool is_color = true;
        bool converts = false;      ///< the scene has gamma handling: numbers become those of `working`
        bool guesses_srgb = false;  ///< files of types for the web that say nothing are sRGB
        Curve working;
    };
    Texels(const ImageSource& source, const Decoding& decoding);

    int width() const { return image_->width; }
    int height() const { return image_->height; }
    bool has_palette() const { return image_->has_palette(); }
    size_t palette_size() const { return palette_.size(); }
    bool has_alpha() const { return has_alpha_; }
    /// Some types of files store colours multiplied by alpha; these are mixed as they are, and divided then.
    Color divided(const Color& mixed) const;

    /// Of palettes: sets what an entry, or all of them, let through; of other pictures: adds to all pixels.
    void set_filter(size_t entry, float filter);
    void set_transmit(size_t entry, float transmit);
    void filter_all(float filter);
    void transmit_all(float transmit);
    /// True if some pixel may have filter or transmit.
    bool passes_light() const;

    Color at(int x, int y) const;
    /// Palette index, or 255 times red, truncated.
    uint32_t index(int x, int y) const;

private:
    float decoded(size_t sample) const {
        if (!image_->floats.empty()) return decoded_float(image_->floats[sample]);
        // A damaged file may hold more than its white.
        return table_[std::min<uint32_t>(image_->samples[sample], image_->white)];
    }
    float decoded_float(float value) const;
    void fill_table();
    void fill_palette();

    ImagePtr image_;
    Curve file_;     ///< of the stored numbers
    Curve working_;  ///< of the scene's
    bool converts_ = false;
    std::vector<float> table_;  ///< of each sample, decoded
    std::vector<Color> palette_;
    float filter_all_ = 0;
    float transmit_all_ = 0;
    bool has_alpha_ = false;
    bool premultiplied_ = false;
    bool divides_by_alpha_ = false;  ///< `premultiplied` was written for a file whose type is not
};

}  // namespace rb
