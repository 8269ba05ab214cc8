// bozo, spotted (manual 3.4.7.1.1, 3.4.7.1.35): plain noise.
#include "patterns/formula.h"
#include "patterns/line_bound.h"
#include "patterns/noise.h"

namespace rb {

namespace {

class PlainNoise final : public Pattern {
public:
    explicit PlainNoise(std::string_view keyword) : keyword_(keyword) {}
    std::string_view keyword() const override { return keyword_; }
    void evaluate(const PatternContext& context, std::span<const Vec3> points,
                  std::span<double> values) const override {
        noise(points, 1.0, context.noise_generator, values);
    }
    IntervalSlope bound(const PatternContext& context, const LinePlace& place) const override {
        return bound_noise(place, context.noise_generator);
    }

private:
    std::string_view keyword_;
};

ColorMap bozo_map() {
    constexpr Color green{0, 1, 0, 0, 0};
    constexpr Color blue{0, 0, 1, 0, 0};
    return {{0.4f, {1, 1, 1, 0, 0}}, {0.4f, green}, {0.6f, green}, {0.6f, blue}, {0.8f, blue},
            {0.8f, {1, 0, 0, 0, 0}}};
}

PatternPtr read_bozo(BlockReader&) { return std::make_shared<PlainNoise>("bozo"); }
PatternPtr read_spotted(BlockReader&) { return std::make_shared<PlainNoise>("spotted"); }

}  // namespace

namespace patterns {
extern const PatternKind bozo;
const PatternKind bozo{.keyword = "bozo", .read = read_bozo, .default_map = bozo_map, .example = "bozo"};
extern const PatternKind spotted;
const PatternKind spotted{.keyword = "spotted", .read = read_spotted, .example = "spotted"};
}  // namespace patterns

}  // namespace rb
