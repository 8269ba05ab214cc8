// crackle [form <v>] [metric f] [offset f] [solid] (manual 3.4.7.1.11; Worley, "A Cellular Texture Basis
// Function"): distances to the nearest random points.
#include "patterns/feature_points.h"

#include <limits>

namespace rb {

namespace {

struct CrackleShape {
    Vec3 form{-1.0, 1.0, 0.0};
    double metric = 2;
    double offset = 0;
    bool solid = false;
};

class Crackle final : public Pattern {
public:
    explicit Crackle(const CrackleShape& chosen) : shape(chosen) {}
    std::string_view keyword() const override { return "crackle"; }
    std::string describe() const override {
        return fmt::format("crackle form <{},{},{}> metric {} offset {} solid {}", shape.form.x, shape.form.y,
                           shape.form.z, shape.metric, shape.offset, shape.solid);
    }
    void evaluate(const PatternContext& context, std::span<const Vec3> points,
                  std::span<double> values) const override {
        NearFeatures features;
        for (size_t i = 0; i < points.size(); ++i) {
            const Nearest nearest = nearest_to(points[i], features.around(FeatureCell::of(points[i])));
            values[i] =
                clamp01(shape.solid ? noise(nearest.point, context.noise_generator) : combined(nearest));
        }
    }

    const CrackleShape shape;

private:
    struct Nearest {
        double sum[3];
        Vec3 point;
    };

    double sum_of(const Vec3& d) const {
        if (shape.metric == 2.0) return glm::dot(d, d);
        if (shape.metric == 1.0) return std::abs(d.x) + std::abs(d.y) + std::abs(d.z);
        return std::pow(std::abs(d.x), shape.metric) + std::pow(std::abs(d.y), shape.metric) +
               std::pow(std::abs(d.z), shape.metric);
    }

    Nearest nearest_to(const Vec3& p, const std::array<Vec3, 81>& features) const {
        constexpr double far = std::numeric_limits<double>::max();
        Nearest n{{far, far, far}, p};
        for (const Vec3& feature : features) {
            const double sum = sum_of(feature - p);
            if (sum >= n.sum[2]) continue;
            if (sum < n.sum[0]) {
                n = {{sum, n.sum[0], n.sum[1]}, feature};
            } else if (sum < n.sum[1]) {
                n.sum[2] = n.sum[1];
                n.sum[1] = sum;
            } else {
                n.sum[2] = sum;
            }
        }
        return n;
    }

    double combined(const Nearest& nearest) const {
        double result = 0;
        for (int i = 0; i < 3; ++i) {
            double sum = nearest.sum[i];
            if (shape.metric == 2.0) {
                sum = std::sqrt(sum + shape.offset * shape.offset);
            } else if (shape.metric == 1.0) {
                sum += shape.offset;
            } else {
                if (shape.offset != 0.0) sum += std::pow(shape.offset, shape.metric);
                sum = std::pow(sum, 1.0 / shape.metric);
            }
            result += shape.form[i] * sum;
        }
        return result;
    }
};

PatternPtr read(BlockReader&) { return std::make_shared<Crackle>(CrackleShape{}); }
PatternPtr read_parameter(BlockReader& in, const PatternPtr& so_far) {
    CrackleShape shape = static_cast<const Crackle&>(*so_far).shape;
    if (in.take_word("form")) {
        shape.form = in.vec3();
    } else if (in.take_word("metric")) {
        shape.metric = in.vec3().x;
    } else if (in.take_word("offset")) {
        shape.offset = in.number();
    } else if (in.take_word("solid")) {
        shape.solid = in.optional_switch();
    } else {
        return nullptr;
    }
    return std::make_shared<Crackle>(shape);
}

}  // namespace

namespace patterns {
extern const PatternKind crackle;
const PatternKind crackle{.keyword = "crackle",
                          .read = read,
                          .read_parameter = read_parameter,
                          .example = "crackle form <-1, 1, 0> metric 2"};
}  // namespace patterns

}  // namespace rb
