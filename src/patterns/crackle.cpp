// crackle [form <v>] [metric f] [offset f] [solid] (manual 3.4.7.1.11; Worley, "A Cellular Texture Basis
// Function"): distances to the nearest random points.
#include "patterns/feature_points.h"
#include "patterns/line_bound.h"
#include "patterns/quad.h"

#include <algorithm>
#include <cstring>
#include <limits>

namespace rb {

namespace {

struct CrackleShape {
    Vec3 form{-1.0, 1.0, 0.0};
    double metric = 2;
    double offset = 0;
    bool solid = false;
};

/// The three least numbers of each lane, in order. Three names: a loop over an array of them would keep them
/// in memory.
template <class Numbers>
struct Least {
    Numbers first;
    Numbers second;
    Numbers third;

    RB_INLINE void add(const Numbers& number) {
        const Numbers over_first = number < first ? first : number;
        first = number < first ? number : first;
        const Numbers over_second = over_first < second ? second : over_first;
        second = over_first < second ? over_first : second;
        third = over_second < third ? over_second : third;
    }
    RB_INLINE void add(const Least& other) {
        add(other.first);
        add(other.second);
        add(other.third);
    }
};

RB_INLINE void put_halves_together(const Least<Quad>& of, Least<Quad>& out) { out = of; }
RB_INLINE void put_halves_together(const Least<Oct>& of, Least<Quad>& out) {
    const Oct* lanes[3] = {&of.first, &of.second, &of.third};
    Quad halves[6];
    for (size_t k = 0; k < 3; ++k) std::memcpy(&halves[2 * k], lanes[k], sizeof(Oct));
    out = {halves[0], halves[2], halves[4]};
    out.add(Least<Quad>{halves[1], halves[3], halves[5]});
}

/// Of all four lanes, in each.
RB_INLINE void put_lanes_together(Least<Quad>& out) {
    const Least<Quad> opposite{__builtin_shufflevector(out.first, out.first, 2, 3, 0, 1),
                               __builtin_shufflevector(out.second, out.second, 2, 3, 0, 1),
                               __builtin_shufflevector(out.third, out.third, 2, 3, 0, 1)};
    out.add(opposite);
    const Least<Quad> neighbour{__builtin_shufflevector(out.first, out.first, 1, 0, 3, 2),
                                __builtin_shufflevector(out.second, out.second, 1, 0, 3, 2),
                                __builtin_shufflevector(out.third, out.third, 1, 0, 3, 2)};
    out.add(neighbour);
}

template <class Lanes>
RB_INLINE void least_squares_in(const Vec3& p, const FeatureLanes& features, double (&out)[3]) {
    using Numbers = typename Lanes::Numbers;
    const Numbers far = Numbers{} + std::numeric_limits<double>::max();
    Least<Numbers> least{far, far, far};
    for (size_t i = 0; i < FeatureLanes::size; i += Lanes::count) {
        Numbers x;
        Numbers y;
        Numbers z;
        load(&features.x[i], x);
        load(&features.y[i], y);
        load(&features.z[i], z);
        x -= p.x;
        y -= p.y;
        z -= p.z;
        least.add(x * x + y * y + z * z);
    }
    Least<Quad> of_all;
    put_halves_together(least, of_all);
    put_lanes_together(of_all);
    out[0] = of_all.first[0];
    out[1] = of_all.second[0];
    out[2] = of_all.third[0];
}

/// The three smallest squares of distances from a finite point, in order.
void least_squares(const Vec3& p, const FeatureLanes& features, double (&out)[3]);
RB_FOR_EACH_WIDTH(least_squares, (const Vec3& p, const FeatureLanes& features, double (&out)[3]),
                  (p, features, out))

class Crackle final : public Pattern {
public:
    explicit Crackle(const CrackleShape& chosen) : shape(chosen) {
        // Of three numbers the norms of two exponents differ by no more than this factor; very small
        // exponents magnify rounding errors.
        constexpr double least_bounded = 0.01;
        constexpr double rounding = 1.0 + 1e-9;
        if (shape.metric > least_bounded)
            square_spread_ = rounding * std::pow(3.0, 2.0 * std::abs(1.0 / shape.metric - 0.5));
    }
    std::string_view keyword() const override { return "crackle"; }
    std::string describe() const override {
        return fmt::format("crackle form <{},{},{}> metric {} offset {} solid {}", shape.form.x, shape.form.y,
                           shape.form.z, shape.metric, shape.offset, shape.solid);
    }
    void evaluate(const PatternContext& context, std::span<const Vec3> points,
                  std::span<double> values) const override {
        NearFeatures& features = NearFeatures::of_this_thread();
        const bool plain = shape.metric == 2.0 && !shape.solid;
        for (size_t i = 0; i < points.size(); ++i) {
            const Vec3& p = points[i];
            const bool quick = plain && std::isfinite(p.x + p.y + p.z);
            const FeatureCell cell = FeatureCell::of(p);
            const Nearest nearest =
                quick ? nearest_by_square(p, features.around(cell)) : nearest_to(p, features, cell);
            values[i] =
                clamp01(shape.solid ? noise(nearest.point, context.noise_generator) : combined(nearest));
        }
    }
    IntervalSlope bound(const PatternContext&, const LinePlace&) const override {
        return somewhere_in(0.0, 1.0);
    }

    const CrackleShape shape;

private:
    struct Nearest {
        double sum[3];
        Vec3 point;
    };

    /// `d`: the lengths along the axes.
    double sum_of(const Vec3& d) const {
        if (shape.metric == 2.0) return glm::dot(d, d);
        if (shape.metric == 1.0) return d.x + d.y + d.z;
        return std::pow(d.x, shape.metric) + std::pow(d.y, shape.metric) + std::pow(d.z, shape.metric);
    }

    Nearest nearest_to(const Vec3& p, NearFeatures& features, const FeatureCell& cell) const {
        constexpr double far = std::numeric_limits<double>::max();
        Nearest n{{far, far, far}, p};
        // Powers are dear: features that are too far by squares are not among the three nearest.
        double reach = std::numeric_limits<double>::infinity();
        if (std::isfinite(p.x + p.y + p.z))
            reach = square_spread_ * nearest_by_square(p, features.around(cell)).sum[2];
        const FeatureLanes& near = features.around(cell);
        for (size_t i = 0; i < FeatureLanes::count; ++i) {
            const Vec3 feature = near.point(i);
            const Vec3 d = glm::abs(feature - p);
            if (glm::dot(d, d) > reach) continue;
            const double sum = sum_of(d);
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

    /// The sums of nearest_to(), for metric 2.
    static Nearest nearest_by_square(const Vec3& p, const FeatureLanes& features) {
        Nearest nearest{{}, p};
        least_squares(p, features, nearest.sum);
        return nearest;
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

    double square_spread_ = std::numeric_limits<double>::infinity();
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
