// granite (manual 3.4.7.1.18): six octaves of noise folded at one half.
#include "base/scratch.h"
#include "patterns/formula.h"
#include "patterns/noise.h"

#include <algorithm>

namespace rb {

namespace {

class Granite final : public Pattern {
public:
    std::string_view keyword() const override { return "granite"; }
    void evaluate(const PatternContext& context, std::span<const Vec3> points,
                  std::span<double> values) const override {
        const int generator = context.noise_generator;
        Scratch::Scope memory(thread_scratch());
        const auto octave_values = memory.take<double>(points.size());
        std::fill(values.begin(), values.end(), 0.0);
        double scale = 1;
        for (int octave = 0; octave < 6; ++octave, scale *= 2) {
            noise(points, 4.0 * scale, generator, octave_values);
            for (size_t i = 0; i < values.size(); ++i) {
                const double n = octave_values[i];
                const double folded =
                    generator > 1 ? std::min(0.5, std::abs(1.0 - 2.0 * n)) : std::abs(0.5 - n);
                values[i] += folded / scale;
            }
        }
    }
};

}  // namespace

namespace patterns {
extern const PatternKind granite;
const PatternKind granite{.keyword = "granite", .read = read_plain<Granite>, .example = "granite"};
}  // namespace patterns

}  // namespace rb
