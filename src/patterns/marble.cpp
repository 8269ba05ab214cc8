// marble (manual 3.4.7.1.22): x, disturbed by turbulence.
#include "patterns/formula.h"
#include "patterns/line_bound.h"
#include "patterns/noise.h"

namespace rb {

namespace {

class Marble final : public Pattern {
public:
    std::string_view keyword() const override { return "marble"; }
    bool keeps_turbulence() const override { return true; }
    void evaluate(const PatternContext& context, std::span<const Vec3> points,
                  std::span<double> values) const override {
        const TurbulenceWarp* classic = context.modifiers.classic_turbulence();
        const double amount = classic ? classic->amount.x : 0.0;
        if (amount == 0.0) {
            for (size_t i = 0; i < points.size(); ++i) values[i] = points[i].x;
            return;
        }
        turbulence(points, *classic, context.noise_generator, values);
        for (size_t i = 0; i < points.size(); ++i) values[i] = points[i].x + amount * values[i];
    }
    IntervalSlope bound(const PatternContext& context, const LinePlace& place) const override {
        const TurbulenceWarp* classic = context.modifiers.classic_turbulence();
        return classic && classic->amount.x != 0.0 ? IntervalSlope::any_number() : place[0];
    }
};

ColorMap marble_map() {
    return {{0.0f, {0.9f, 0.8f, 0.8f, 0, 0}}, {0.9f, {0.9f, 0.08f, 0.08f, 0, 0}}, {0.9f, {0, 0, 0, 0, 0}}};
}

}  // namespace

namespace patterns {
extern const PatternKind marble;
const PatternKind marble{.keyword = "marble",
                         .read = read_plain<Marble>,
                         .default_map = marble_map,
                         .default_wave = Wave::triangle,
                         .example = "marble"};
}  // namespace patterns

}  // namespace rb
