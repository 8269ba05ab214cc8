// agate (manual 3.4.7.1): bands along z, disturbed by turbulence of the point.
#include "patterns/formula.h"
#include "patterns/line_bound.h"
#include "patterns/noise.h"
#include "patterns/sine.h"

#include <algorithm>

namespace rb {

namespace {

class Agate final : public Pattern {
public:
    std::string_view keyword() const override { return "agate"; }
    void evaluate(const PatternContext& context, std::span<const Vec3> points,
                  std::span<double> values) const override {
        const TurbulenceWarp* classic = context.modifiers.classic_turbulence();
        const TurbulenceWarp shape = classic ? *classic : TurbulenceWarp{};
        const auto strength = static_cast<double>(context.modifiers.agate_turbulence);
        turbulence(points, shape, context.noise_generator, values);
        for (size_t i = 0; i < points.size(); ++i)
            values[i] = 2.0 * pi * (1.3 * strength * values[i] + 1.1 * points[i].z);
        sines(values);
        for (size_t i = 0; i < points.size(); ++i) {
            const double band = 0.5 * (values[i] + 1.0);
            values[i] = band < 0.0 ? 0.0 : std::pow(std::min(1.0, band), 0.77);
        }
    }
    IntervalSlope bound(const PatternContext&, const LinePlace&) const override {
        return somewhere_in(0.0, 1.0);
    }
};

ColorMap agate_map() {
    return {{0.0f, {1.0f, 1.0f, 1.0f, 0, 0}}, {0.5f, {0.95f, 0.75f, 0.5f, 0, 0}},
            {0.5f, {0.9f, 0.7f, 0.5f, 0, 0}}, {0.6f, {0.9f, 0.7f, 0.4f, 0, 0}},
            {0.6f, {1.0f, 0.7f, 0.4f, 0, 0}}, {1.0f, {0.6f, 0.3f, 0.0f, 0, 0}}};
}

}  // namespace

namespace patterns {
extern const PatternKind agate;
const PatternKind agate{
    .keyword = "agate", .read = read_plain<Agate>, .default_map = agate_map, .example = "agate"};
}  // namespace patterns

}  // namespace rb
