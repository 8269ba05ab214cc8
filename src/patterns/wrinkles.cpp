// wrinkles (manual 3.4.7.1.41): ten octaves of noise.
#include "patterns/formula.h"
#include "patterns/noise.h"

namespace rb {

namespace {

class Wrinkles final : public Pattern {
public:
    std::string_view keyword() const override { return "wrinkles"; }
    void evaluate(const PatternContext& context, std::span<const Vec3> points,
                  std::span<double> values) const override {
        const int generator = context.noise_generator;
        for (size_t i = 0; i < points.size(); ++i) {
            double sum = 0;
            double scale = 1;
            for (int octave = 0; octave < 10; ++octave, scale *= 2) {
                const double n = noise(scale * points[i], generator);
                sum += (generator > 1 ? clamp01(2.0 * n - 0.5) : n) / scale;
            }
            values[i] = 0.5 * sum;
        }
    }
    bool perturb(const PatternContext&, float amount, std::span<const Vec3> points,
                 std::span<Vec3> normals) const override {
        for (size_t i = 0; i < points.size(); ++i) {
            Vec3 sum{0.0};
            double scale = 1;
            for (int octave = 0; octave < 10; ++octave, scale *= 2) {
                const Vec3 d = vector_noise(scale * points[i]);
                sum += Vec3{std::abs(d.x), std::abs(d.y), std::abs(d.z)} / scale;
            }
            normals[i] += static_cast<double>(amount) * sum;
        }
        return true;
    }
};

}  // namespace

namespace patterns {
extern const PatternKind wrinkles;
const PatternKind wrinkles{.keyword = "wrinkles", .read = read_plain<Wrinkles>, .example = "wrinkles"};
}  // namespace patterns

}  // namespace rb
