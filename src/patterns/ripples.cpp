// ripples, waves (manual 3.4.7.1.30, 3.4.7.1.40): circular waves from sources at random places.
#include "base/scratch.h"
#include "patterns/formula.h"
#include "patterns/line_bound.h"
#include "patterns/noise.h"
#include "patterns/quad.h"
#include "patterns/sine.h"

#include <algorithm>

namespace rb {

namespace {

/// Distances to a place; 1 instead of 0.
RB_FOR_EACH_TARGET void measure(std::span<const Vec3> points, const Vec3& from, std::span<double> distances) {
    for (size_t i = 0; i < points.size(); ++i) {
        const double x = points[i].x - from.x;
        const double y = points[i].y - from.y;
        const double z = points[i].z - from.z;
        const double d = std::sqrt(x * x + y * y + z * z);
        distances[i] = d == 0.0 ? 1.0 : d;
    }
}

RB_FOR_EACH_TARGET void divide(std::span<double> values, double by) {
    for (double& v : values) v /= by;
}

class CircularWaves final : public Pattern {
public:
    /// `spread`: each source has its own frequency (waves).
    explicit CircularWaves(bool spread) : spread_(spread) {}
    std::string_view keyword() const override { return spread_ ? "waves" : "ripples"; }

    void evaluate(const PatternContext& context, std::span<const Vec3> points,
                  std::span<double> values) const override {
        const auto sources = wave_sources(context.number_of_waves);
        Scratch::Scope memory(thread_scratch());
        const Waves waves(points.size(), memory);
        std::fill(values.begin(), values.end(), 0.0);
        for (const WaveSource& source : sources) {
            find_heights(context, source, points, waves);
            for (size_t i = 0; i < values.size(); ++i) values[i] += waves.height[i];
        }
        const auto count = static_cast<double>(sources.size());
        for (double& v : values) v = spread_ ? 0.2 * (2.5 + v / count) : 0.5 * (1.0 + v / count);
    }
    /// What can be proven of ten waves is far above their true slope.
    IntervalSlope bound(const PatternContext&, const LinePlace&) const override {
        return IntervalSlope::any_number();
    }

    bool perturb(const PatternContext& context, float amount, std::span<const Vec3> points,
                 std::span<Vec3> normals) const override {
        const auto sources = wave_sources(context.number_of_waves);
        const double share = static_cast<double>(amount) / static_cast<double>(sources.size());
        Scratch::Scope memory(thread_scratch());
        const Waves waves(points.size(), memory);
        for (const WaveSource& source : sources) {
            find_heights(context, source, points, waves);
            for (size_t i = 0; i < points.size(); ++i)
                normals[i] += share * waves.height[i] / waves.distance[i] * (points[i] - source.center);
        }
        return true;
    }

private:
    /// Of one source at all points.
    struct Waves {
        Waves(size_t count, Scratch::Scope& memory)
            : distance(memory.take<double>(count)), height(memory.take<double>(count)) {}
        std::span<double> distance;
        std::span<double> height;
    };
    void find_heights(const PatternContext& context, const WaveSource& source, std::span<const Vec3> points,
                      const Waves& waves) const {
        measure(points, source.center, waves.distance);
        const double frequency = context.modifiers.frequency;
        const double phase = context.modifiers.phase;
        const double own = spread_ ? source.frequency : 1.0;
        for (size_t i = 0; i < points.size(); ++i)
            waves.height[i] = 2.0 * pi * (waves.distance[i] * frequency * own + phase);
        sines(waves.height);
        if (!spread_) return;
        divide(waves.height, source.frequency);
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
