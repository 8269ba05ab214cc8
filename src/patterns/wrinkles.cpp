// wrinkles (manual 3.4.7.1.41): ten octaves of noise.
#include "base/scratch.h"
#include "patterns/formula.h"
#include "patterns/noise.h"

#include <algorithm>

#include <glm/common.hpp>

namespace rb {

namespace {

class Wrinkles final : public Pattern {
public:
    std::string_view keyword() const override { return "wrinkles"; }
    void evaluate(const PatternContext& context, std::span<const Vec3> points,
                  std::span<double> values) const override {
        const int generator = context.noise_generator;
        Scratch::Scope memory(thread_scratch());
        const auto octave_values = memory.take<double>(points.size());
        std::fill(values.begin(), values.end(), 0.0);
        double scale = 1;
        for (int octave = 0; octave < 10; ++octave, scale *= 2) {
            noise(points, scale, generator, octave_values);
            for (size_t i = 0; i < values.size(); ++i) {
                const double n = octave_values[i];
                values[i] += (generator > 1 ? clamp01(2.0 * n - 0.5) : n) / scale;
            }
        }
        for (double& v : values) v *= 0.5;
    }
    bool perturb(const PatternContext&, float amount, std::span<const Vec3> points,
                 std::span<Vec3> normals) const override {
        Scratch::Scope memory(thread_scratch());
        const auto octave_values = memory.take<Vec3>(points.size());
        double scale = 1;
        for (int octave = 0; octave < 10; ++octave, scale *= 2) {
            vector_noise(points, scale, octave_values);
            const double strength = static_cast<double>(amount) / scale;
            for (size_t i = 0; i < normals.size(); ++i) normals[i] += strength * glm::abs(octave_values[i]);
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
