// wrinkles (manual 3.4.7.1.41): ten octaves of noise.
#include "patterns/formula.h"
#include "patterns/line_bound.h"
#include "patterns/octave_sums.h"

namespace rb {

namespace {

struct Spread {
    bool centered;
    template <class Numbers>
    RB_INLINE void operator()(Numbers& value, int) const {
        if (!centered) return;
        value = 2.0 * value - 0.5;
        clamp_unit(value);
    }
};

template <class Lanes>
RB_INLINE void wrinkle_values_in(std::span<const Vec3> points, int generator, std::span<double> values) {
    with_noise(generator, [&](const auto& noise) RB_INLINED {
        sum_octaves<Lanes>(noise, points, Octaves::doubling(10, 1.0), Spread{noise.centered}, values);
    });
    for (double& v : values) v *= 0.5;
}
RB_FOR_EACH_WIDTH(wrinkle_values, (std::span<const Vec3> points, int generator, std::span<double> values),
                  (points, generator, values))

template <class Lanes>
RB_INLINE void add_wrinkles_in(std::span<const Vec3> points, double amount, std::span<Vec3> normals) {
    sum_vector_octaves<Lanes>(
        points, Octaves::doubling(10, 1.0), [](auto& value) RB_INLINED { set_magnitude(value, value); },
        [amount, normals](size_t i, const Vec3& sum) RB_INLINED { normals[i] += amount * sum; });
}
RB_FOR_EACH_WIDTH(add_wrinkles, (std::span<const Vec3> points, double amount, std::span<Vec3> normals),
                  (points, amount, normals))

class Wrinkles final : public Pattern {
public:
    std::string_view keyword() const override { return "wrinkles"; }
    void evaluate(const PatternContext& context, std::span<const Vec3> points,
                  std::span<double> values) const override {
        wrinkle_values(points, context.noise_generator, values);
    }
    IntervalSlope bound(const PatternContext& context, const LinePlace& place) const override {
        const int generator = context.noise_generator;
        return 0.5 *
               bound_octaves(place, Octaves::doubling(10, 1.0), generator, [&](const IntervalSlope& value) {
                   return generator == 1 ? value : clamp01(2.0 * value - 0.5);
               });
    }
    bool perturb(const PatternContext&, float amount, std::span<const Vec3> points,
                 std::span<Vec3> normals) const override {
        add_wrinkles(points, static_cast<double>(amount), normals);
        return true;
    }
};

}  // namespace

namespace patterns {
extern const PatternKind wrinkles;
const PatternKind wrinkles{.keyword = "wrinkles", .read = read_plain<Wrinkles>, .example = "wrinkles"};
}  // namespace patterns

}  // namespace rb
