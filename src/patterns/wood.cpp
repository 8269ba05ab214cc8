// wood (manual 3.4.7.1.42): rings around z, disturbed by turbulence.
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
        for (size_t i = 0; i < points.size(); ++i) {
            const Vec3& p = points[i];
            double x = p.x;
            double y = p.y;
            if (classic) {
                const Vec3 d = vector_turbulence(p, *classic);
                x += cycloidal((p.x + d.x) * classic->amount.x);
                y += cycloidal((p.y + d.y) * classic->amount.y);
            }
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
