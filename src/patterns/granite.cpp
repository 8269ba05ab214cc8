// granite (manual 3.4.7.1.18): six octaves of noise folded at one half.
#include "patterns/formula.h"
#include "patterns/line_bound.h"
#include "patterns/octave_sums.h"

namespace rb {

namespace {

/// The distance of noise values from one half.
struct Folded {
    bool centered;
    template <class Numbers>
    RB_INLINE void operator()(Numbers& value, int) const {
        set_magnitude(centered ? 1.0 - 2.0 * value : 0.5 - value, value);
        if (centered) value = 0.5 < value ? Numbers{} + 0.5 : value;
    }
};

template <class Lanes>
RB_INLINE void granite_values_in(std::span<const Vec3> points, int generator, std::span<double> values) {
    with_noise(generator, [&](const auto& noise) RB_INLINED {
        sum_octaves<Lanes>(noise, points, Octaves::doubling(6, 4.0), Folded{noise.centered}, values);
    });
}
RB_FOR_EACH_WIDTH(granite_values, (std::span<const Vec3> points, int generator, std::span<double> values),
                  (points, generator, values))

class Granite final : public Pattern {
public:
    std::string_view keyword() const override { return "granite"; }
    void evaluate(const PatternContext& context, std::span<const Vec3> points,
                  std::span<double> values) const override {
        granite_values(points, context.noise_generator, values);
    }
    IntervalSlope bound(const PatternContext& context, const LinePlace& place) const override {
        const int generator = context.noise_generator;
        return bound_octaves(place, Octaves::doubling(6, 4.0), generator, [&](const IntervalSlope& value) {
            return generator == 1 ? abs(0.5 - value) : min(abs(1.0 - 2.0 * value), IntervalSlope(0.5));
        });
    }
};

}  // namespace

namespace patterns {
extern const PatternKind granite;
const PatternKind granite{.keyword = "granite", .read = read_plain<Granite>, .example = "granite"};
}  // namespace patterns

}  // namespace rb
