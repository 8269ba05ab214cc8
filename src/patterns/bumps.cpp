// bumps (manual 3.4.7.1.7): noise; as a normal, vector noise pushes the normal about.
#include "base/scratch.h"
#include "patterns/formula.h"
#include "patterns/line_bound.h"
#include "patterns/noise.h"

namespace rb {

namespace {

class Bumps final : public Pattern {
public:
    std::string_view keyword() const override { return "bumps"; }
    void evaluate(const PatternContext& context, std::span<const Vec3> points,
                  std::span<double> values) const override {
        noise(points, 1.0, context.noise_generator, values);
    }
    IntervalSlope bound(const PatternContext& context, const LinePlace& place) const override {
        return bound_noise(place, context.noise_generator);
    }
    bool perturb(const PatternContext&, float amount, std::span<const Vec3> points,
                 std::span<Vec3> normals) const override {
        Scratch::Scope memory(thread_scratch());
        const auto push = memory.take<Vec3>(points.size());
        vector_noise(points, 1.0, push);
        for (size_t i = 0; i < normals.size(); ++i) normals[i] += static_cast<double>(amount) * push[i];
        return true;
    }
};

}  // namespace

namespace patterns {
extern const PatternKind bumps;
const PatternKind bumps{.keyword = "bumps", .read = read_plain<Bumps>, .example = "bumps"};
}  // namespace patterns

}  // namespace rb
