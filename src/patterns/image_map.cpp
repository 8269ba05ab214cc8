// image_map (manual 3.4.6.1.5): a picture's own colours.
#include "patterns/image_field.h"
#include "patterns/registry.h"

namespace rb {

namespace {

class ImageMap final : public Pattern {
public:
    explicit ImageMap(ImageField field) : field_(std::move(field)) {}
    std::string_view keyword() const override { return "image_map"; }

    bool has_colors() const override { return true; }
    bool passes_light() const override { return field_.options().once || field_.texels().passes_light(); }
    void colors(std::span<const Vec3> points, std::span<Color> out) const override {
        constexpr Color outside{1, 1, 1, 0, 1};
        for (size_t i = 0; i < points.size(); ++i) {
            const auto place = field_.place(points[i]);
            out[i] = place ? field_.color(*place) : outside;
        }
    }
    /// Nobody asks: its colours are all there is.
    void evaluate(const PatternContext&, std::span<const Vec3>, std::span<double> values) const override {
        std::fill(values.begin(), values.end(), 0.0);
    }

private:
    ImageField field_;
};

}  // namespace

namespace patterns {
extern const PatternKind image_map;
const PatternKind image_map{
    .keyword = "image_map",
    .read = read_picture<ImageMap>,
    .default_frequency = 0,
    .only_in = "pigment",
    .example = "image_map { function 4, 3 { pattern { gradient x } } interpolate 2 }"};
}  // namespace patterns

}  // namespace rb
