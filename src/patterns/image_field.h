#pragma once
#include "block/reader.h"
#include "patterns/texels.h"

#include <memory>
#include <optional>
#include <utility>

namespace rb {

enum class ImageMapping { planar = 0, spherical = 1, cylindrical = 2, toroidal = 5 };
enum class Interpolation { none = 0, bilinear = 2, bicubic = 3, distance = 4 };

/// What may follow the picture's name in image_map, bump_map, image_pattern and material_map.
struct ImageOptions {
    ImageMapping mapping = ImageMapping::planar;
    Interpolation interpolation = Interpolation::none;
    bool once = false;
    bool use_index = false;
    bool use_alpha = false;
    Vec2 repeat{1.0};
    Vec2 offset{0.0};
    std::optional<float> amount;  ///< `bump_size` within bump_map
};

/// A picture spread over space (spec: textures 6.2, 6.3).
class ImageField {
public:
    ImageField(Texels texels, const ImageOptions& options) : texels_(std::move(texels)), options_(options) {}

    const Texels& texels() const { return texels_; }
    const ImageOptions& options() const { return options_; }

    /// Continuous pixel coordinates of a point, y downward from the top row; absent where there is no
    /// picture.
    std::optional<Vec2> place(const Vec3& p) const;
    /// The colour at such coordinates, interpolated.
    Color color(const Vec2& place) const;
    /// The index of the pixel there.
    uint32_t index(const Vec2& place) const;

private:
    std::optional<Vec2> unrolled(const Vec3& p) const;
    std::pair<int, int> within(int x, int y) const;
    Color pixel(int x, int y) const;

    Texels texels_;
    ImageOptions options_;
};

/// Takes the picture and its options from an image_map, image_pattern, bump_map or material_map; the numbers
/// of all but image_map are no colours.
ImageField take_image_field(BlockReader& in);

/// Reads a block `keyword { FILE OPTIONS }` as a pattern that is made of its field.
template <class P>
PatternPtr read_picture(BlockReader& outer) {
    BlockReader in(outer.block(outer.peek_word()), outer.context());
    auto pattern = std::make_shared<P>(take_image_field(in));
    in.finish();
    return pattern;
}

}  // namespace rb
