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
    void evaluate(const PatternContext&, std::span<const Vec3> points,
                  std::span<double> values) const override {
        for (size_t i = 0; i < points.size(); ++i) {
            const auto place = field_.place(points[i]);
            values[i] = place ? static_cast<double>(grey(field_.color(*place).rgb())) : 1.0;
        }
    }

private:
    ImageField field_;
};

PatternPtr read(BlockReader& outer) {
    BlockReader in(outer.block("image_map"), outer.context());
    auto pattern = std::make_shared<ImageMap>(take_image_field(in));
    in.finish();
    return pattern;
}

}  // namespace

namespace patterns {
extern const PatternKind image_map;
const PatternKind image_map{
    .keyword = "image_map",
    .read = read,
    .default_frequency = 0,
    .example = "image_map { function 4, 3 { pattern { gradient x } } interpolate 2 }"};
}  // namespace patterns

}  // namespace rb
