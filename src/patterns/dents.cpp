// dents (manual 3.4.7.1.13): noise cubed.
#include "base/scratch.h"
#include "patterns/formula.h"
#include "patterns/line_bound.h"
#include "patterns/noise.h"

namespace rb {

namespace {

class Dents final : public Pattern {
public:
    std::string_view keyword() const override { return "dents"; }
    void evaluate(const PatternContext& context, std::span<const Vec3> points,
                  std::span<double> values) const override {
        noise(points, 1.0, context.noise_generator, values);
        for (double& v : values) v = v * v * v;
    }
    IntervalSlope bound(const PatternContext& context, const LinePlace& place) const override {
        return not_negative(cube(bound_noise(place, context.noise_generator)));
    }
    bool perturb(const PatternContext& context, float amount, std::span<const Vec3> points,
                 std::span<Vec3> normals) const override {
        Scratch::Scope memory(thread_scratch());
        const auto push = memory.take<Vec3>(points.size());
        const auto depth = memory.take<double>(points.size());
        vector_noise(points, 1.0, push);
        evaluate(context, points, depth);
        for (size_t i = 0; i < normals.size(); ++i) {
            normals[i] += static_cast<double>(amount) * depth[i] * push[i];
        }
        return true;
    }
};

}  // namespace

namespace patterns {
extern const PatternKind dents;
const PatternKind dents{.keyword = "dents", .read = read_plain<Dents>, .example = "dents"};
}  // namespace patterns

}  // namespace rb
