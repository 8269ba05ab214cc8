// gradient <v> (manual 3.4.7.1.17): distance along a direction.
#include "patterns/formula.h"
#include "patterns/line_bound.h"

namespace rb {

namespace {

class GradientPattern final : public PointPattern<GradientPattern> {
public:
    explicit GradientPattern(const Vec3& axis) : axis_(axis) {
        const double length = glm::length(axis);
        if (length > 0.0) axis_ /= length;
    }
    std::string_view keyword() const override { return "gradient"; }
    std::string describe() const override {
        return fmt::format("gradient <{},{},{}>", axis_.x, axis_.y, axis_.z);
    }
    double value(const Vec3& p) const {
        const double d = glm::dot(p, axis_);
        return d > 1.0 ? std::fmod(d, 1.0) : d;
    }
    IntervalSlope bound(const PatternContext&, const LinePlace& place) const override {
        const IntervalSlope d = place[0] * axis_.x + place[1] * axis_.y + place[2] * axis_.z;
        if (d.value.hi <= 1.0) return d;
        if (d.value.lo > 1.0) return fmod(d, 1.0);
        return IntervalSlope::jumping({std::min(d.value.lo, 0.0), 1.0});
    }

private:
    Vec3 axis_;
};

PatternPtr read(BlockReader& in) { return std::make_shared<GradientPattern>(in.vec3()); }

}  // namespace

namespace patterns {
extern const PatternKind gradient;
const PatternKind gradient{.keyword = "gradient", .read = read, .example = "gradient <1, 2, 0>"};
}  // namespace patterns

}  // namespace rb
