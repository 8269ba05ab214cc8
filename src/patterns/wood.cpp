// wood (manual 3.4.7.1.42): rings around z, disturbed by turbulence.
#include "base/scratch.h"
#include "patterns/formula.h"
#include "patterns/line_bound.h"
#include "patterns/noise.h"
#include "patterns/sine.h"

namespace rb {

namespace {

class Wood final : public Pattern {
public:
    std::string_view keyword() const override { return "wood"; }
    bool keeps_turbulence() const override { return true; }
    void evaluate(const PatternContext& context, std::span<const Vec3> points,
                  std::span<double> values) const override {
        const TurbulenceWarp* classic = context.modifiers.classic_turbulence();
        Scratch::Scope memory(thread_scratch());
        const size_t count = points.size();
        const auto moves = memory.take<double>(2 * count, 0.0);
        const auto moves_x = moves.first(count);
        const auto moves_y = moves.subspan(count);
        if (classic) {
            const auto turbulent = memory.take<Vec3>(count);
            vector_turbulence(points, *classic, turbulent);
            for (size_t i = 0; i < count; ++i) {
                moves_x[i] = 2.0 * pi * ((points[i].x + turbulent[i].x) * classic->amount.x);
                moves_y[i] = 2.0 * pi * ((points[i].y + turbulent[i].y) * classic->amount.y);
            }
            sines(moves);
        }
        for (size_t i = 0; i < count; ++i) {
            const double x = points[i].x + moves_x[i];
            const double y = points[i].y + moves_y[i];
            values[i] = std::sqrt(x * x + y * y);
        }
    }
    IntervalSlope bound(const PatternContext& context, const LinePlace& place) const override {
        return context.modifiers.classic_turbulence() ? IntervalSlope::any_number()
                                                      : length(std::span(place).first(2));
    }
};

ColorMap wood_map() { return {{0.6f, {0.666f, 0.312f, 0.2f, 0, 0}}, {0.6f, {0.4f, 0.1333f, 0.066f, 0, 0}}}; }

}  // namespace

namespace patterns {
extern const PatternKind wood;
const PatternKind wood{.keyword = "wood",
                       .read = read_plain<Wood>,
                       .default_map = wood_map,
                       .default_wave = Wave::triangle,
                       .example = "wood"};
}  // namespace patterns

}  // namespace rb
