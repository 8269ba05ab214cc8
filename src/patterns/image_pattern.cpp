// image_pattern (manual 3.4.7.1.16): the grey of a picture, or what its alpha lets through.
#include "patterns/formula.h"
#include "patterns/image_field.h"
#include "patterns/line_bound.h"

namespace rb {

namespace {

class ImagePattern final : public PointPattern<ImagePattern> {
public:
    explicit ImagePattern(ImageField field) : field_(std::move(field)) {}
    std::string_view keyword() const override { return "image_pattern"; }
    double value(const Vec3& p) const {
        const auto place = field_.place(p);
        if (!place) return 0.0;
        const Color color = field_.color(*place);
        if (!field_.options().use_alpha) return clamp01(static_cast<double>(grey(color.rgb())));
        return clamp01(static_cast<double>(field_.texels().has_alpha() ? color.transmit : color.red));
    }
    IntervalSlope bound(const PatternContext&, const LinePlace&) const override {
        return somewhere_in(0.0, 1.0);
    }

private:
    ImageField field_;
};

}  // namespace

namespace patterns {
extern const PatternKind image_pattern;
const PatternKind image_pattern{.keyword = "image_pattern",
                                .read = read_picture<ImagePattern>,
                                .default_frequency = 0,
                                .example = "image_pattern { function 4, 3 { pattern { gradient y } } }"};
}  // namespace patterns

}  // namespace rb
