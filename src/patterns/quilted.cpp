// quilted [control0 f] [control1 f] (manual 3.4.7.1.28): cushions in unit cubes.
#include "patterns/formula.h"
#include "patterns/line_bound.h"

namespace rb {

namespace {

class Quilted final : public PointPattern<Quilted> {
public:
    Quilted(double slope0, double slope1) : control0(single(slope0)), control1(single(slope1)) {}
    std::string_view keyword() const override { return "quilted"; }
    std::string describe() const override {
        return fmt::format("quilted control0 {} control1 {}", control0, control1);
    }
    double value(const Vec3& p) const {
        const Vec3 c = cushion(p);
        return (std::abs(c.x) + std::abs(c.y) + std::abs(c.z)) / 3.0;
    }
    IntervalSlope bound(const PatternContext&, const LinePlace& place) const override {
        LinePlace c;
        // Where a cushion ends the next begins, at the same distance from its middle.
        for (size_t i = 0; i < 3; ++i) c[i] = 0.5 - 0.5 * triangle(place[i]);
        const IntervalSlope t = length(c);
        const IntervalSlope u = 1.0 - t;
        const IntervalSlope share =
            1.154700538 * (cube(t) + 3.0 * control0 * t * square(u) + 3.0 * control1 * square(t) * u);
        return not_negative(abs(share) * (c[0] + c[1] + c[2]) / 3.0);
    }
    bool perturb(const PatternContext&, float amount, std::span<const Vec3> points,
                 std::span<Vec3> normals) const override {
        for (size_t i = 0; i < points.size(); ++i) {
            normals[i] += static_cast<double>(amount) * cushion(points[i]);
        }
        return true;
    }

    const double control0;
    const double control1;

private:
    Vec3 cushion(const Vec3& p) const {
        const Vec3 c{p.x - floor_below(p.x) - 0.5, p.y - floor_below(p.y) - 0.5,
                     p.z - floor_below(p.z) - 0.5};
        const double t = glm::length(c);
        const double u = 1.0 - t;
        return 1.154700538 * (t * t * t + 3.0 * t * u * u * control0 + 3.0 * t * t * u * control1) * c;
    }
};

PatternPtr read(BlockReader&) { return std::make_shared<Quilted>(1.0, 1.0); }
PatternPtr read_parameter(BlockReader& in, const PatternPtr& so_far) {
    const auto& q = static_cast<const Quilted&>(*so_far);
    if (in.take_word("control0")) return std::make_shared<Quilted>(in.number(), q.control1);
    if (in.take_word("control1")) return std::make_shared<Quilted>(q.control0, in.number());
    return nullptr;
}

}  // namespace

namespace patterns {
extern const PatternKind quilted;
const PatternKind quilted{.keyword = "quilted",
                          .read = read,
                          .read_parameter = read_parameter,
                          .default_frequency = 0,
                          .example = "quilted control0 0.3 control1 0.7"};
}  // namespace patterns

}  // namespace rb
