// spiral1 n, spiral2 n (manual 3.4.7.1.33-34): n arms that wind around z.
#include "patterns/formula.h"
#include "patterns/line_bound.h"
#include "patterns/noise.h"

#include <algorithm>

namespace rb {

namespace {

class Spiral final : public Pattern {
public:
    Spiral(int kind, int arms) : kind_(kind), arms_(arms) {}
    std::string_view keyword() const override { return kind_ == 1 ? "spiral1" : "spiral2"; }
    std::string describe() const override { return fmt::format("{} {}", keyword(), arms_); }
    void evaluate(const PatternContext& context, std::span<const Vec3> points,
                  std::span<double> values) const override {
        const TurbulenceWarp* classic = context.modifiers.classic_turbulence();
        const double amount = classic ? classic->amount.x : 0.0;
        if (amount != 0.0) {
            turbulence(points, *classic, context.noise_generator, values);
        } else {
            std::fill(values.begin(), values.end(), 0.0);
        }
        for (size_t i = 0; i < points.size(); ++i) {
            const Vec3& p = points[i];
            const double radius = std::sqrt(p.x * p.x + p.y * p.y);
            double angle = 0;
            if (radius != 0.0) {
                const double a = std::asin(p.y / radius);
                angle = p.x < 0.0 ? 1.5 * pi - a : 0.5 * pi + a;
            }
            const double v = p.z + radius + arms_ * angle / (2.0 * pi) + amount * values[i];
            values[i] = kind_ == 1 ? v : triangle(radius) + triangle(v);
        }
    }
    IntervalSlope bound(const PatternContext& context, const LinePlace& place) const override {
        const TurbulenceWarp* classic = context.modifiers.classic_turbulence();
        if (classic && classic->amount.x != 0.0)
            return kind_ == 1 ? IntervalSlope::any_number() : somewhere_in(0.0, 2.0);
        const IntervalSlope radius = length(std::span(place).first(2));
        // What the arc sine loses near its ends.
        constexpr double rounding = 1e-6;
        const IntervalSlope angle =
            pi - atan2(place[0], place[1]) + IntervalSlope(Interval(-rounding, rounding), 0.0);
        const IntervalSlope v = place[2] + radius + arms_ * angle / (2.0 * pi);
        return kind_ == 1 ? v : triangle(radius) + triangle(v);
    }

private:
    int kind_;
    int arms_;
};

int read_arms(BlockReader& in) { return static_cast<int16_t>(in.integer()); }
PatternPtr read_first(BlockReader& in) { return std::make_shared<Spiral>(1, read_arms(in)); }
PatternPtr read_second(BlockReader& in) { return std::make_shared<Spiral>(2, read_arms(in)); }

}  // namespace

namespace patterns {
extern const PatternKind spiral1;
const PatternKind spiral1{
    .keyword = "spiral1", .read = read_first, .default_wave = Wave::triangle, .example = "spiral1 5"};
extern const PatternKind spiral2;
const PatternKind spiral2{
    .keyword = "spiral2", .read = read_second, .default_wave = Wave::triangle, .example = "spiral2 5"};
}  // namespace patterns

}  // namespace rb
