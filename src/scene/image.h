#pragma once
#include "scene/curve.h"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace rb {

/// The types of picture files that the language has a word for.
enum class ImageType { gif, tga, iff, ppm, pgm, png, jpeg, tiff, bmp, exr, hdr, pot, sys };

/// A picture as its file holds it, rows top to bottom: nothing is scaled, decoded or premultiplied.
struct Image {
    ImageType type = ImageType::png;
    int width = 0;
    int height = 0;
    int channels = 1;      ///< 1 grey or palette index, 2 grey and alpha, 3 RGB, 4 RGB and alpha
    uint32_t white = 255;  ///< the sample that means 1; of no meaning for floats and indices
    std::vector<uint16_t> samples;
    std::vector<float> floats;                    ///< instead of `samples` (OpenEXR, HDR)
    std::vector<std::array<uint8_t, 4>> palette;  ///< RGBA; not empty: the samples are indices into it
    std::optional<GammaCurve> curve;              ///< what the file says about its own numbers

    bool has_palette() const { return !palette.empty(); }
    size_t index(int x, int y) const {
        return (static_cast<size_t>(y) * static_cast<size_t>(width) + static_cast<size_t>(x)) *
               static_cast<size_t>(channels);
    }
};
using ImagePtr = std::shared_ptr<const Image>;

/// A picture that a statement names, `png "file" gamma 2.2`, or makes, `function W, H { ... }`.
struct ImageSource {
    ImagePtr image;
    std::optional<GammaCurve> gamma;  ///< as written; nothing else may decode what has no colour
    bool premultiplied = false;
};

/// Where readers get the pixels of files from. The application plugs it in, so that the front end does not
/// depend on the libraries for pictures.
class ImageFiles {
public:
    virtual ~ImageFiles() = default;
    /// Decodes a file, once however often it is asked for. Throws IoError for a file that cannot be read, is
    /// of another type or damaged.
    virtual ImagePtr read(const std::string& path, ImageType type) = 0;
    /// Files may have changed: what is asked for from now on is decoded anew.
    virtual void forget() = 0;
};

}  // namespace rb
