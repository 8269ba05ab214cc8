// wood (manual 3.4.7.1.42): rings around z, disturbed by turbulence.
#include "base/scratch.h"
#include "patterns/formula.h"
#include "patterns/noise.h"

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
        const auto moves = memory.take<Vec3>(points.size(), Vec3{0.0});
        if (classic) {
            vector_turbulence(points, *classic, moves);
            for (size_t i = 0; i < points.size(); ++i) {
                moves[i].x = cycloidal((points[i].x + moves[i].x) * classic->amount.x);
                moves[i].y = cycloidal((points[i].y + moves[i].y) * classic->amount.y);
            }
        }
        for (size_t i = 0; i < points.size(); ++i) {
            const double x = points[i].x + moves[i].x;
            const double y = points[i].y + moves[i].y;
            values[i] = std::sqrt(x * x + y * y);
        }
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
