// facets [size f] [coords f] [metric f] (manual 3.4.7.1.15): only as a normal; flat cells.
#include "patterns/feature_points.h"

#include <algorithm>
#include <limits>

namespace rb {

namespace {

struct FacetShape {
    double size = 0.1;
    double coords = 0;
    double metric = 2;
};

class Facets final : public Pattern {
public:
    explicit Facets(const FacetShape& chosen) : shape(chosen) {}
    std::string_view keyword() const override { return "facets"; }
    std::string describe() const override {
        return fmt::format("facets size {} coords {} metric {}", shape.size, shape.coords, shape.metric);
    }
    void evaluate(const PatternContext&, std::span<const Vec3>, std::span<double> values) const override {
        std::fill(values.begin(), values.end(), 0.0);
    }
    bool perturb(const PatternContext&, float, std::span<const Vec3> points,
                 std::span<Vec3> normals) const override {
        NearFeatures& features = NearFeatures::of_this_thread();
        const double scale = shape.size < 1e-6 ? 1e6 : 1.0 / shape.size;
        for (size_t i = 0; i < points.size(); ++i) {
            Vec3& n = normals[i];
            n /= glm::length(n);
            const Vec3 start = scale * (shape.coords != 0.0 ? points[i] : n);
            const Vec3 nearest = nearest_to(start, features.around(FeatureCell::of(start)));
            if (shape.coords == 0.0) {
                n = nearest;
                continue;
            }
            const Vec3 d = vector_noise(nearest);
            n += shape.coords * (d - glm::dot(d, n) * n);
        }
        return true;
    }

    const FacetShape shape;

private:
    double sum_of(const Vec3& d) const {
        if (shape.metric == 2.0) return glm::dot(d, d);
        // Signed on purpose: this is what the language does for metric 1.
        if (shape.metric == 1.0) return d.x + d.y + d.z;
        return std::pow(std::abs(d.x), shape.metric) + std::pow(std::abs(d.y), shape.metric) +
               std::pow(std::abs(d.z), shape.metric);
    }
    Vec3 nearest_to(const Vec3& p, const FeatureLanes& features) const {
        double best = std::numeric_limits<double>::max();
        Vec3 nearest = p;
        for (size_t i = 0; i < FeatureLanes::count; ++i) {
            const Vec3 feature = features.point(i);
            const double sum = sum_of(feature - p);
            if (sum >= best) continue;
            best = sum;
            nearest = feature;
        }
        return nearest;
    }
};

PatternPtr read(BlockReader&) { return std::make_shared<Facets>(FacetShape{}); }
PatternPtr read_parameter(BlockReader& in, const PatternPtr& so_far) {
    FacetShape shape = static_cast<const Facets&>(*so_far).shape;
    if (in.take_word("size")) {
        shape.size = in.number();
    } else if (in.take_word("coords")) {
        shape.coords = in.number();
    } else if (in.take_word("metric")) {
        shape.metric = in.vec3().x;
    } else {
        return nullptr;
    }
    return std::make_shared<Facets>(shape);
}

}  // namespace

namespace patterns {
extern const PatternKind facets;
const PatternKind facets{.keyword = "facets",
                         .read = read,
                         .read_parameter = read_parameter,
                         .only_in = "normal",
                         .example = "facets size 0.3"};
}  // namespace patterns

}  // namespace rb
