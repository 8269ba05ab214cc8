// ripples, waves (manual 3.4.7.1.30, 3.4.7.1.40): circular waves from sources at random places.
#include "patterns/formula.h"
#include "patterns/noise.h"

namespace rb {

namespace {

class CircularWaves final : public Pattern {
public:
    /// `spread`: each source has its own frequency (waves).
    explicit CircularWaves(bool spread) : spread_(spread) {}
    std::string_view keyword() const override { return spread_ ? "waves" : "ripples"; }

    void evaluate(const PatternContext& context, std::span<const Vec3> points,
                  std::span<double> values) const override {
        const auto sources = wave_sources(context.number_of_waves);
        const auto count = static_cast<double>(sources.size());
        for (size_t i = 0; i < points.size(); ++i) {
            double sum = 0;
            for (const WaveSource& source : sources)
                sum += height(context, source, distance(points[i], source));
            values[i] = spread_ ? 0.2 * (2.5 + sum / count) : 0.5 * (1.0 + sum / count);
        }
    }

    bool perturb(const PatternContext& context, float amount, std::span<const Vec3> points,
                 std::span<Vec3> normals) const override {
        const auto sources = wave_sources(context.number_of_waves);
        const double share = static_cast<double>(amount) / static_cast<double>(sources.size());
        for (size_t i = 0; i < points.size(); ++i) {
            for (const WaveSource& source : sources) {
                const double d = distance(points[i], source);
                normals[i] += share * height(context, source, d) / d * (points[i] - source.center);
            }
        }
        return true;
    }

private:
    static double distance(const Vec3& p, const WaveSource& source) {
        const double d = glm::length(p - source.center);
        return d == 0.0 ? 1.0 : d;
    }
    double height(const PatternContext& context, const WaveSource& source, double d) const {
        const double frequency = context.modifiers.frequency;
        const double phase = context.modifiers.phase;
        if (!spread_) return cycloidal(d * frequency + phase);
        return cycloidal(d * frequency * source.frequency + phase) / source.frequency;
    }

    bool spread_;
};

PatternPtr read_ripples(BlockReader&) { return std::make_shared<CircularWaves>(false); }
PatternPtr read_waves(BlockReader&) { return std::make_shared<CircularWaves>(true); }

}  // namespace

namespace patterns {
extern const PatternKind ripples;
const PatternKind ripples{.keyword = "ripples", .read = read_ripples, .example = "ripples"};
extern const PatternKind waves;
const PatternKind waves{.keyword = "waves", .read = read_waves, .example = "waves"};
}  // namespace patterns

}  // namespace rb
